// SPDX-License-Identifier: Apache-2.0
// plan() is pure: a workspace in which other robots have been planned for decides as a fresh
// workspace does. The decisions agree bit for bit, over all models, certificates, methods, walls
// and moving obstacles. The test overwrites the scratch memory of the robot before by what is no
// number. A robot that still reads this memory shows.
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <vector>

#include "avo/planner.h"
#include "support/generators.h"
#include "support/poison.h"

namespace avo::test {
namespace {

struct Scene {
  PlannerOptions options;
  Robot robot;
  std::vector<Neighbor> neighbors;
  std::vector<Wall> walls;
  Detour detour;
};

MotionModel any_model(Random& random) {
  switch (random.below(6)) {
    case 0:
      return Holonomic{};
    case 1:
      return DifferentialDrive{
          .track = 0.4, .offset = 0.2, .wheel_speed = 3.0, .wheel_acceleration = 6.0};
    case 2:
      return Airplane{};
    default: {
      Car car;
      if (random.below(3) > 0) car.body = CarBody{random.uniform(-0.8, 0.8), 0.5};
      if (random.below(2) == 0) car.max_curvature = random.uniform(0.2, 1.5);
      if (random.below(2) == 0) car.acceleration_set = AccelerationSet::exact;
      car.reverse = random.below(2) == 0;
      return car;
    }
  }
}

Robot any_robot(Random& random) {
  Robot robot;
  robot.model = any_model(random);
  robot.position = in_disc(random, 2.0);
  robot.heading = random.uniform(-3.1, 3.1);
  robot.radius = random.uniform(0.2, 0.6);
  robot.max_acceleration = random.uniform(0.5, 2.0);
  robot.max_speed = random.uniform(0.5, 2.5);
  double speed = random.below(4) == 0 ? 0.0 : random.uniform(0.0, robot.max_speed);
  const Vec2 ahead{std::cos(robot.heading), std::sin(robot.heading)};
  Vec2 way = moves_along_heading(robot.model) ? ahead : random.direction();
  if (const auto* airplane = std::get_if<Airplane>(&robot.model)) {
    robot.max_speed = airplane->min_speed * random.uniform(1.1, 2.0);
    speed = random.uniform(airplane->min_speed, robot.max_speed);
  } else if (random.below(3) == 0) {
    robot.max_braking = random.uniform(0.2, 1.0) * robot.max_acceleration;
  }
  const Car* car = std::get_if<Car>(&robot.model);
  if (car != nullptr && car->reverse && random.below(2) == 0) way = -way;
  robot.velocity = speed * way;
  robot.preferred_velocity = in_disc(random, robot.max_speed);
  if (random.below(2) == 0) robot.distance_to_goal = random.log_uniform(0.05, 20.0);
  if (random.below(4) == 0) robot.priority = random.log_uniform(0.1, 10.0);
  return robot;
}

Neighbor any_neighbor(Random& random, const Robot& robot) {
  Neighbor other;
  other.radius = random.uniform(0.2, 0.6);
  const double gap = random.below(8) == 0 ? random.uniform(-0.1, 0.0) : random.log_uniform(1e-3, 5);
  other.position = robot.position + (robot.radius + other.radius + gap) * random.direction();
  other.velocity = random.below(4) == 0 ? Vec2{} : in_disc(random, 1.5);
  other.max_acceleration = random.uniform(0.5, 3.0);
  if (random.below(4) == 0) other.max_braking = random.uniform(0.2, 1.0) * other.max_acceleration;
  if (random.below(4) == 0) other.priority = random.log_uniform(0.1, 10.0);
  return other;
}

// What is allowed of neighbors beside airplanes is less.
void make_any_kind(Random& random, Neighbor& other) {
  switch (random.below(5)) {
    case 0:
      other.behavior = Behavior::moves_on;
      other.acceleration = in_disc(random, 1.0);
      if (random.below(2) == 0) other.max_deviation = 1.0, other.max_speed = 2.0;
      if (random.below(2) == 0) other.likely_deviation = random.log_uniform(0.01, 10.0);
      break;
    case 1:
      other.age = 1 + random.below(3);
      other.max_deviation = random.uniform(0.0, 3.0);
      break;
    case 2:
      other.position_error = random.uniform(0.0, 0.2);
      break;
    default:
      break;
  }
}

PlannerOptions any_options(Random& random) {
  constexpr Method kMethods[] = {Method::avo_paper,
                                 Method::orca,
                                 Method::velocity_obstacle,
                                 Method::orca_clamped,
                                 Method::reciprocal_velocity_obstacle,
                                 Method::buffered_voronoi};
  PlannerOptions options =
      random.below(6) == 0 ? default_options(kMethods[random.below(6)]) : PlannerOptions{};
  options.time_step = random.log_uniform(0.02, 0.3);
  if (options.method != Method::avo) return options;
  options.control_time = options.time_step * random.log_uniform(1.0, 30.0);
  options.time_horizon = random.log_uniform(0.5, 10.0);
  constexpr Certificate kCertificates[] = {Certificate::braking_trajectories,
                                           Certificate::braking_trajectories,
                                           Certificate::braking_trajectories, Certificate::none};
  options.certificate = kCertificates[random.below(4)];
  if (random.below(4) == 0) options.motion = Motion::exponential;
  if (options.certificate != Certificate::braking_trajectories) return options;
  if (random.below(4) == 0) options.sensing_error = {0.05, 0.05};
  if (random.below(4) == 0)
    options.motion = Motion::held, options.clock = Clock::free,
    options.longest_step = 1.5 * options.time_step;
  if (random.below(8) == 0) options.max_neighbors = 3;
  return options;
}

Scene any_scene(Random& random) {
  Scene s;
  s.options = any_options(random);
  s.robot = any_robot(random);
  const bool flies = !can_rest(s.robot.model);
  if (flies) s.options = default_options(Method::avo), s.options.time_step = 0.1;
  const bool kinds = !flies && random.below(2) == 0;
  for (int k = random.below(9); k > 0; --k) {
    s.neighbors.push_back(any_neighbor(random, s.robot));
    Neighbor& other = s.neighbors.back();
    const bool moves_on = flies && random.below(2) == 0;
    if (flies) other.position = (moves_on ? 4.0 : 40.0) * other.position;
    if (kinds) make_any_kind(random, other);
    if (moves_on) other.behavior = Behavior::moves_on, other.max_deviation = random.below(2);
  }
  for (int k = random.below(3) == 0 ? 1 + random.below(3) : 0; k > 0; --k) {
    const Vec2 away = random.direction(), along = perpendicular(away);
    const Vec2 at = s.robot.position + (s.robot.radius + random.log_uniform(1e-3, 3.0)) * away;
    s.walls.push_back({at - 2.0 * along, at + random.uniform(0.1, 2.0) * along, 0.0});
  }
  s.detour = {static_cast<float>(random.below(2) * random.uniform(0.0, 2.0)),
              static_cast<float>(random.below(2) * random.uniform(0.0, 100.0)),
              static_cast<float>(random.uniform(0.0, 2.0)), false};
  return s;
}

// All that a decision says.
std::vector<std::uint64_t> bits_of(const Scene& s, PlanWorkspace& workspace) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); };
  const auto add_plan = [&](const Plan& plan) {
    for (const Vec2 v : {plan.new_velocity, plan.next_velocity, plan.acceleration})
      add(v.x), add(v.y);
    add(plan.violation), add(static_cast<double>(plan.status)),
        add(static_cast<double>(plan.state));
  };
  const Planner planner(s.options);
  Detour detour = s.detour;
  add_plan(planner.plan(s.robot, s.neighbors, workspace, &detour, s.walls));
  add(detour.angle), add(detour.beside), add(detour.congestion),
      add(detour.has_arrived ? 1.0 : 0.0);
  add_plan(planner.plan_among_movers(s.robot, s.neighbors, workspace));
  const SafetyReport report = planner.state(s.robot, s.neighbors, workspace, s.walls);
  add(static_cast<double>(report.state)), add(report.neighbor), add(report.wall), add(report.time);
  const std::vector<Vec2> asked{{}, s.robot.velocity, s.robot.preferred_velocity};
  std::vector<std::uint8_t> admitted(asked.size());
  planner.find_admitted(s.robot, s.neighbors, workspace, asked, admitted, s.walls);
  for (const std::uint8_t one : admitted) add(one);
  return bits;
}

TEST(Purity, used_and_poisoned_workspaces_decide_as_fresh_ones) {
  Random random(32);
  // what is no number is refused by most comparisons, and what is large or small by others
  constexpr double kPoisons[] = {std::numeric_limits<double>::quiet_NaN(), -1.0, -1e-3, 1e3};
  PlanWorkspace used, spoiled;
  std::map<PlanStatus, int> statuses;
  for (int i = 0; i < 8000; ++i) {
    const Scene s = any_scene(random);
    PlanWorkspace fresh;
    const std::vector<std::uint64_t> expected = bits_of(s, fresh);
    Poison{kPoisons[i % 4]}(spoiled);
    ASSERT_EQ(bits_of(s, used), expected) << "used, scene " << i;
    ASSERT_EQ(bits_of(s, spoiled), expected) << "poisoned, scene " << i;
    PlanWorkspace again;
    ++statuses[Planner(s.options).plan(s.robot, s.neighbors, again, nullptr, s.walls).status];
  }
  for (const PlanStatus status :
       {PlanStatus::optimal, PlanStatus::least_unsafe, PlanStatus::refused, PlanStatus::detour,
        PlanStatus::braking, PlanStatus::overlapping})
    EXPECT_GT(statuses[status], 80) << to_string(status);
  EXPECT_LT(statuses[PlanStatus::invalid_input], 1600);
}

}  // namespace
}  // namespace avo::test
