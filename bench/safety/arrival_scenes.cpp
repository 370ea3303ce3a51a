// SPDX-License-Identifier: Apache-2.0
// Scenes in which other robots block a robot.
#include "arrival_scenes.h"

#include <cmath>
#include <utility>
#include <vector>

#include "placement.h"

namespace avo::safety {
namespace {

constexpr double kRadius = 0.5;  // m, of usual robots

void add_at_goal(Scenario& scenario, Vec2 place, double radius = kRadius) {
  scenario.robots.push_back(usual_robot(place, place, kSpeed));
  scenario.robots.back().radius = radius;
}

// Returns a random place at this distance from the origin.
Vec2 from_around(double distance, Random& random) {
  const int places = 1 << 20;
  return distance * circle_point(static_cast<int>(random.below(places)), places);
}

// Returns a scene in which all robots with a goal must arrive.
Scene until_rest(Scenario scenario, double units) {
  Scene scene{std::move(scenario)};
  scene.unit = straight_time(scene.scenario);
  scene.limit = units;
  scene.until_rest = true;
  return scene;
}

}  // namespace

Scene closed_ring(std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 20);
  constexpr int kRobots = 8;
  constexpr double kGap = 0.05, kJitter = 0.02;  // m
  const double distance = 0.5 * (2.0 * kRadius + kGap) / circle_point(1, 2 * kRobots).y;
  for (int k = 0; k < kRobots; ++k)
    add_at_goal(scenario, distance * circle_point(k, kRobots) + random.in_square(kJitter));
  scenario.robots.push_back(usual_robot(from_around(10.0, random), {}, kSpeed));
  scenario.duration = 200.0;
  return until_rest(std::move(scenario), 8.0);
}

Scene deep_among(std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 21);
  constexpr double kSpacing = 1.1, kJitter = 0.06;  // m
  for (const Vec2 place : triangular_block(7, 7, kSpacing)) {
    const Vec2 from_center = place - Vec2{0.25 * kSpacing, 0.0};
    if (norm(from_center) < 0.1 * kSpacing || norm(from_center) > 3.1 * kSpacing) continue;
    add_at_goal(scenario, from_center + random.in_square(kJitter));
  }
  scenario.robots.push_back(usual_robot(from_around(12.0, random), {}, kSpeed));
  scenario.duration = 300.0;
  return until_rest(std::move(scenario), 8.0);
}

Scene large_among(std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 22);
  constexpr int kRobots = 200;
  constexpr double kSmall = 0.3, kLarge = 3.0, kPart = 0.11;
  const double side = std::sqrt(kRobots * kPi * kSmall * kSmall / kPart);
  const std::vector<double> radii(kRobots, kSmall);
  for (const Vec2 place : random_places(radii, side, 0.05, random))
    add_at_goal(scenario, place, kSmall);
  const double start = 0.5 * side + 1.5 * kLarge;
  const Vec2 from{-start, random.between(-3.0, 3.0)}, to{start, random.between(-3.0, 3.0)};
  scenario.robots.push_back(usual_robot(from, to, kSpeed));
  scenario.robots.back().radius = kLarge;
  scenario.max_neighbors = 40;
  scenario.duration = 300.0;
  return until_rest(std::move(scenario), 8.0);
}

Scene touching_goals(int n, bool hexagonal, std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 23);
  const auto rows = static_cast<int>(std::lround(std::sqrt(n)));
  constexpr double kDiameter = 2.0 * kRadius;
  std::vector<Vec2> goals =
      hexagonal ? triangular_block(rows, rows, kDiameter) : block({}, rows, rows, kDiameter);
  goals = dealt_anew(std::move(goals), random);
  const double inner = 0.75 * rows * kDiameter + 2.0, side = 2.0 * (inner + rows * kDiameter);
  std::vector<Vec2> starts;
  while (starts.size() < goals.size()) {
    const Vec2 place = random.in_square(side);
    bool is_clear = norm(place) > inner;
    for (const Vec2 other : starts) is_clear = is_clear && norm(place - other) > 1.3 * kDiameter;
    if (is_clear) starts.push_back(place);
  }
  for (std::size_t k = 0; k < goals.size(); ++k)
    scenario.robots.push_back(usual_robot(starts[k], goals[k], kSpeed));
  scenario.duration = 360.0;
  Scene scene = until_rest(std::move(scenario), 0.0);
  scene.limit = 300.0 / scene.unit;
  return scene;
}

Scene neighbors_swap(std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 24);
  constexpr int kSide = 8;
  std::vector<Vec2> places = block({}, kSide, kSide, 1.2);
  for (Vec2& place : places) place = place + random.in_square(0.1);
  for (std::size_t k = 0; k < places.size(); k += 2) {
    scenario.robots.push_back(usual_robot(places[k], places[k + 1], kSpeed));
    scenario.robots.push_back(usual_robot(places[k + 1], places[k], kSpeed));
  }
  scenario.duration = 300.0;
  return until_rest(std::move(scenario), 20.0);
}

Scene clump(int n, std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, 25);
  const double side = std::sqrt(n * kPi * kRadius * kRadius / 0.25);
  const std::vector<double> radii(static_cast<std::size_t>(n), kRadius);
  const std::vector<Vec2> starts = random_places(radii, side, 0.1, random);
  const std::vector<Vec2> goals = random_places(radii, side, 0.1, random);
  for (std::size_t k = 0; k < starts.size(); ++k)
    scenario.robots.push_back(usual_robot(starts[k], goals[k], kSpeed));
  scenario.duration = 400.0;
  return until_rest(std::move(scenario), n > 200 ? 4.5 : 3.0);
}

}  // namespace avo::safety
