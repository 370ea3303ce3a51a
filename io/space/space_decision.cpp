// SPDX-License-Identifier: Apache-2.0
// Finds a decision in space, and what it followed from: by public calls of the library alone.
#include "avo_io/space_decision.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "avo/error.h"
#include "avo/half_plane.h"
#include "core/elementary.h"
#include "core/ranges.h"
#include "io/space/space_words.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::Box;
using avo::space::Neighbor;
using avo::space::Robot;
using avo::space::Scenario;
using avo::space::Simulation;

void require_explainable(const Scenario& scenario, std::int64_t robot) {
  // what is listed are the states of robots and boxes, not what a robot measured
  if (!scenario.sensing.is_exact())
    throw avo::Error("sensing: found errors, must be exact where a decision in space is explained");
  if (!scenario.moving_obstacles.empty())
    throw avo::Error(
        "moving_obstacles: found some, must be none where a decision in space is explained");
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  if (robot < 0 || robot >= robots)
    throw avo::Error(fmt::format("robot: found {}, must be 0 to {}", robot, robots - 1));
}

void require_time(const Scenario& scenario, double time) {
  if (!std::isfinite(time) || time < 0.0)
    throw avo::Error(fmt::format("time: found {}, must be finite and >= 0 s", time));
  if (time > scenario.duration * (1.0 + 1e-12))
    throw avo::Error(
        fmt::format("time: found {} s, must be <= duration = {} s", time, scenario.duration));
}

// Takes the neighbors and boxes that robot k senses among robots as they were.
void look_around(const Scenario& scenario, const std::vector<Robot>& robots, std::size_t k,
                 const avo::PlannerOptions& options, SpaceDecision& decision) {
  const double radius = sensing_radius_of(scenario);
  const auto squared_to = [&](std::size_t other) {
    return norm_squared(robots[other].position - robots[k].position);
  };
  std::vector<std::size_t> order(robots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t other) {
    return other == k || !(squared_to(other) <= radius * radius);
  });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return squared_to(a) < squared_to(b); });
  for (const std::size_t other : order) {
    decision.neighbors.push_back(neighbor_of(robots[other]));
    decision.numbers.push_back(static_cast<std::int64_t>(other));
  }
  const double range = box_range(robots[k], options);
  for (std::size_t b = 0; b < scenario.boxes.size(); ++b) {
    if (norm(displacement_to(scenario.boxes[b], robots[k].position)) > range) continue;
    decision.boxes.push_back(scenario.boxes[b]);
    decision.obstacles.push_back(b < scenario.obstacle_of_box.size()
                                     ? scenario.obstacle_of_box[b]
                                     : static_cast<std::int64_t>(b));
  }
}

// The axes of the plane of p and v (docs/space.md, "The half-space of a pair").
struct PairAxes {
  Vec3 along, across;
};
PairAxes axes_of(Vec3 p, Vec3 v) {
  constexpr double kParallel = 1e-9;
  PairAxes axes{p / norm(p), {}};
  const Vec3 rest = v - dot(axes.along, v) * axes.along;
  if (norm(rest) > kParallel * norm(v)) {
    axes.across = rest / norm(rest);
  } else {
    const double horizontal = norm(avo::Vec2{p.x, p.y});
    axes.across = horizontal > 1e-6 * std::abs(p.z) ? Vec3{-p.y / horizontal, p.x / horizontal, 0.0}
                                                    : Vec3{0.0, p.z < 0.0 ? 1.0 : -1.0, 0.0};
  }
  return axes;
}

// m: p_A - p_B from A's and B's downwash that the relative course comes nearest to.
Vec3 relative_place(const Robot& robot, const Neighbor& other, Vec3 v, double time_horizon) {
  Vec3 p = robot.position - other.position;
  const double squared = norm_squared(v);
  const double nearest = squared > 0.0 ? std::max(-dot(p, v), 0.0) / squared : 0.0;
  const double height = p.z + std::min(nearest, time_horizon) * v.z;
  p.z -= std::clamp(height, -other.downwash, robot.downwash);
  return p;
}

void collect_half_spaces(const avo::PlannerOptions& options, SpaceDecision& decision) {
  const Robot& self = decision.self;
  const double time_horizon = own_time_horizon(self, options);
  const avo::Horizon horizon(options.control_time, time_horizon, options.time_step);
  std::size_t most = decision.neighbors.size();
  if (options.max_neighbors)
    most = std::min(most, static_cast<std::size_t>(*options.max_neighbors));
  for (std::size_t k = 0; k < most; ++k) {
    const Neighbor& other = decision.neighbors[k];
    const Vec3 v = self.velocity - other.velocity;
    const Vec3 p = relative_place(self, other, v, time_horizon);
    if (p == Vec3{}) continue;
    const PairAxes axes = axes_of(p, v);
    const avo::Pair pair{
        {norm(p), 0.0}, {dot(axes.along, v), dot(axes.across, v)}, self.radius + other.radius};
    const avo::RelativeHalfPlane plane = half_plane(
        pair, options.control_time * (self.max_acceleration + other.max_acceleration), horizon);
    if (plane.state == avo::PairState::free || plane.state == avo::PairState::coincident) continue;
    const Vec3 normal = plane.plane.normal.x * axes.along + plane.plane.normal.y * axes.across;
    const double share = avo::reciprocal_share(self.max_acceleration, other.max_acceleration,
                                               self.priority, other.priority);
    decision.half_spaces.push_back(
        {static_cast<int>(k), normal, dot(normal, self.velocity) + share * plane.plane.offset});
  }
}

// Asks the certificate about each neighbor and each box alone.
void find_refusing(const avo::space::Planner& planner, SpaceDecision& decision) {
  avo::space::PlanWorkspace workspace;
  const auto admits = [&](std::span<const Neighbor> neighbors, std::span<const Box> boxes) {
    return planner.is_admitted(decision.self, neighbors, workspace, decision.proposal, boxes);
  };
  if (!admits({}, {})) return;  // it is beyond the robot's own limits by rounding
  for (std::size_t k = 0; k < decision.neighbors.size(); ++k)
    if (!admits({&decision.neighbors[k], 1}, {}))
      decision.refusing.push_back({static_cast<int>(k), -1});
  for (std::size_t b = 0; b < decision.boxes.size(); ++b)
    if (!admits({}, {&decision.boxes[b], 1}))
      decision.refusing.push_back({-1, static_cast<int>(b)});
}

// The next velocity of an uncertified planner among these neighbors.
Vec3 proposed(const avo::space::Planner& uncertified, const avo::space::Detour& memory,
              const SpaceDecision& decision, std::span<const Neighbor> neighbors) {
  avo::space::PlanWorkspace workspace;
  avo::space::Detour detour = memory;
  return uncertified.plan(decision.self, neighbors, workspace, &detour, decision.boxes)
      .next_velocity;
}

// Finds the neighbors without which the proposal would be another one.
void find_shaping(const avo::space::Planner& uncertified, const avo::space::Detour& memory,
                  SpaceDecision& decision) {
  constexpr double kSame = 1e-6;  // m/s
  std::vector<bool> breaks(decision.neighbors.size(), false);
  for (const NeighborHalfSpace& own : decision.half_spaces)
    breaks[static_cast<std::size_t>(own.neighbor)] =
        dot(own.normal, decision.self.preferred_velocity) < own.offset - kSame;
  for (std::size_t k = 0; k < decision.neighbors.size(); ++k) {
    std::vector<Neighbor> others = decision.neighbors;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const Vec3 without = proposed(uncertified, memory, decision, others);
    if (norm(without - decision.proposal) <= kSame) continue;
    (breaks[k] ? decision.binding : decision.heeded).push_back({static_cast<int>(k), -1});
  }
}

}  // namespace

SpaceDecision explain_step(Simulation& simulation, std::int64_t robot) {
  const Scenario& scenario = simulation.scenario();
  require_explainable(scenario, robot);
  const auto k = static_cast<std::size_t>(robot);
  const avo::space::Planner planner(planner_options(scenario));
  avo::space::Detour memory;
  if (simulation.steps() > 0) memory.acceleration = simulation.plans()[k].acceleration;
  const std::vector<Robot> before(simulation.robots().begin(), simulation.robots().end());
  SpaceDecision decision;
  decision.scene = scenario.name;
  decision.robot = robot;
  decision.time = simulation.time();
  decision.goal = simulation.goal({k});
  decision.is_at_goal = simulation.is_at_goal({k});
  look_around(scenario, before, k, planner.options(), decision);
  simulation.step();
  decision.self = before[k];
  decision.self.preferred_velocity = simulation.robots()[k].preferred_velocity;
  decision.self.distance_to_goal = simulation.robots()[k].distance_to_goal;
  decision.plan = simulation.plans()[k];
  collect_half_spaces(planner.options(), decision);
  avo::PlannerOptions options = planner.options();
  options.certificate = avo::Certificate::none;
  options.sensing_error = {};
  const avo::space::Planner uncertified(options);
  decision.proposal = proposed(uncertified, memory, decision, decision.neighbors);
  find_shaping(uncertified, memory, decision);
  if (planner.options().certificate != avo::Certificate::none) find_refusing(planner, decision);
  decision.sentence = sentence_of(decision);
  return decision;
}

std::optional<SpaceDecision> explain_in_space(const Scenario& scenario, std::int64_t robot,
                                              double time, int threads,
                                              const std::function<bool(double time)>& go_on) {
  require_explainable(scenario, robot);
  require_time(scenario, time);
  Simulation simulation(scenario, threads);
  while (simulation.time() + scenario.time_step <= time * (1.0 + 1e-12)) {
    if (go_on && !go_on(simulation.time())) return std::nullopt;
    simulation.step();
  }
  return explain_step(simulation, robot);
}

}  // namespace avo_io
