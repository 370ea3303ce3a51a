// SPDX-License-Identifier: Apache-2.0
// Finds pairs with starts that a certificate cannot keep apart. The certificate itself tests every
// pair that can reach each other.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "certificate/fallback_areas.h"
#include "planner/stages/disc_pairs.h"
#include "robots/footprint.h"
#include "robots/model.h"
#include "sim/columns/fleet.h"
#include "sim/scene/assumptions.h"
#include "spatial/point_grid.h"

namespace avo::inline sim {
namespace {

// A robot or an obstacle at the start.
struct Starter {
  Vec2 position;
  int source = 0;      // robot i, or -1 - k for moving obstacle k
  Vec2 to_rest;        // m, displacement from the robot's place to where it would stop
  double reach = 0.0;  // m, radius and the largest distance that it can move while the robots brake
  bool loiters = false;
};

// Certificate, scene and scratch memory.
struct Starts {
  const Scenario& scenario;
  CertificateLaw law;  // by which all brake at once, also where clocks are free: see late_phase()
  double longest_step = 0.0;  // s, where clocks are free
  bool mixed = false;
  double margin = 0.0;  // m, that all pairs keep in addition
  std::vector<Starter> starters = {};
  CertificateConstraints constraints = {};
  std::vector<BrokenStart> broken = {};
};

double seconds_until_rest(const RobotSetup& robot, const CertificateLaw& law) {
  const double speed = norm(robot.velocity);
  return law.step.time_step * braking_steps(speed, decrement_of(robot, law.step));
}

// m/s
double top_speed(const RobotSetup& robot) {
  return std::max(robot.max_speed, norm(robot.velocity));
}

void collect_starters(Starts& starts) {
  double longest = 0.0;  // s
  const std::vector<RobotSetup>& robots = starts.scenario.robots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Vec2 to_rest = vector_to_rest(robots[i], starts.law);
    longest = std::max(longest, seconds_until_rest(robots[i], starts.law));
    const auto circle = circle_of(robots[i].model, robots[i].position, start_velocity(robots[i]));
    starts.starters.push_back({disc_center(robots[i]), static_cast<int>(i), to_rest,
                               disc_radius(robots[i]) +
                                   (circle ? 2.0 * circle->radius : norm(to_rest)) +
                                   late_phase(robots[i], starts.longest_step),
                               circle.has_value()});
  }
  for (std::size_t i = 0; i < robots.size() && starts.mixed; ++i)  // as movers
    starts.starters[i].reach = disc_radius(robots[i]) + longest * top_speed(robots[i]);
  const std::vector<MovingObstacle>& obstacles = starts.scenario.moving_obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const MovingObstacle& obstacle = obstacles[k];
    const double length =
        longest * norm(obstacle.velocity) +
        0.5 * longest * longest * (norm(obstacle.acceleration) + obstacle.max_deviation) +
        parabola_error(obstacle.acceleration, starts.law.step);
    starts.starters.push_back(
        {obstacle.position, -1 - static_cast<int>(k), {}, obstacle.radius + length});
  }
}

// Returns whether the line across p separates the two on their whole paths: most pairs of a crowd
// need no more than this test.
bool are_apart(const Starter& a, const Starter& b, Behavior behavior, double contact,
               double margin) {
  const Vec2 p = a.position - b.position;
  const double distance = norm(p);
  if (distance >= a.reach + b.reach + margin) return true;
  if (behavior != Behavior::decides || a.loiters || b.loiters || !(distance > 0.0)) return false;
  return distance +
             (std::min(0.0, dot(p, a.to_rest)) - std::max(0.0, dot(p, b.to_rest))) / distance >=
         contact;
}

// What a robot counts on from another one by its certificate; none where no certificate asks. Every
// robot with a certificate avoids moving obstacles and parked robots. Parked ones do not overlap.
std::optional<Expectation> counted_on(const Starter& b, const Starter& a, const Starts& starts) {
  const Scenario& scenario = starts.scenario;
  const auto robot = [&](const Starter& starter) -> const RobotSetup& {
    return scenario.robots[static_cast<std::size_t>(starter.source)];
  };
  const RobotSetup& own = robot(a);
  if (!is_parked(own) && !keeps(scenario, own, starts.law)) return std::nullopt;
  if (b.source < 0) return Expectation::moves_on;
  const RobotSetup& other = robot(b);
  if (is_parked(own) || is_parked(other)) {
    const bool some = is_parked(own) == is_parked(other) || keeps(scenario, own, starts.law) ||
                      keeps(scenario, other, starts.law);
    return some ? std::optional(Expectation::decides) : std::nullopt;
  }
  const UsualMethod usual = usual_method(scenario);
  return expected_of(conduct_of(other, usual), conduct_of(own, usual));
}

BrakingPose start_pose(const RobotSetup& robot, const CertificateLaw& law) {
  return braking_pose(robot.model, start_velocity(robot), robot.heading, braking_limit(robot),
                      law.step);
}

BodyId body_of(int source) {
  if (source >= 0) return RobotId{static_cast<std::uint64_t>(source)};
  return MovingObstacleId{static_cast<std::uint64_t>(-1 - source)};
}
// Orders moving obstacles before robots.
std::int64_t rank_of(BodyId body) {
  const auto* robot = std::get_if<RobotId>(&body);
  if (robot != nullptr) return static_cast<std::int64_t>(robot->value);
  return -1 - static_cast<std::int64_t>(std::get<MovingObstacleId>(body).value);
}

void examine(const Starter& a, const Starter& b, Expectation expected, Starts& starts) {
  const auto& [scenario, law, longest_step, mixed, extra, starters, constraints, broken] = starts;
  const RobotSetup& own = scenario.robots[static_cast<std::size_t>(a.source)];
  Neighbor neighbor;
  double margin = extra;
  if (b.source >= 0) {
    const RobotSetup& other = scenario.robots[static_cast<std::size_t>(b.source)];
    neighbor = sensed(traits_of(other), conduct_of(other, usual_method(scenario)), expected,
                      disc_center(other), start_velocity(other));
    neighbor.loiter = circle_of(other.model, other.position, start_velocity(other));
    if (has_footprint(other.model)) cover(other.model, start_pose(other, law), neighbor);
    margin += late_phase(own, longest_step) + late_phase(other, longest_step);
  } else {
    const MovingObstacle& other =
        scenario.moving_obstacles[static_cast<std::size_t>(-1 - b.source)];
    neighbor = {.position = other.position,
                .velocity = other.velocity,
                .radius = other.radius,
                .behavior = Behavior::moves_on,
                .max_deviation = other.max_deviation,
                .acceleration = other.acceleration,
                .max_speed = other.max_speed.value_or(std::numeric_limits<double>::infinity())};
    margin += parabola_error(other.acceleration, law.step) + late_phase(own, longest_step);
  }
  const double contact = disc_radius(own) + neighbor.radius;
  if (are_apart(a, b, neighbor.behavior, contact + margin, extra)) return;
  Robot robot;
  robot.position = disc_center(own);
  robot.velocity = start_velocity(own);
  robot.radius = disc_radius(own);
  robot.max_acceleration = own.max_acceleration;
  robot.max_speed = own.max_speed;
  robot.max_braking = own.max_braking;
  robot.loiter = circle_of(own.model, own.position, start_velocity(own));
  if (has_footprint(own.model)) robot.model = own.model, robot.heading = own.heading;
  double distance = norm(robot.position - neighbor.position);
  if (neighbor.footprint || has_footprint(own.model))  // as if the discs were the robots
    distance = contact + nearest_discs(discs_of(robot, law.step), neighbor).gap;
  if (robot.loiter) {
    // a robot that flies need not keep its circle beside an obstacle
    starts.constraints.invariant.slack =
        b.source < 0
            ? distance - contact
            : gap_of(fallback_area_of(robot, law.step), fallback_area_of(neighbor, law.step));
  } else {
    collect_constraints(robot, std::span(&neighbor, 1), law, starts.constraints);
  }
  // the slack beside a robot at rest leaves out bodies that may touch it, but their touch is
  // contact here
  const double depth =
      std::max(contact - distance, std::min(contact, margin - starts.constraints.invariant.slack));
  if (depth > kStartTolerance * contact) {
    starts.broken.push_back(
        {std::get<RobotId>(body_of(a.source)), body_of(b.source), distance, depth});
  }
}

// Examines a pair, unless neither has to keep clear of the other.
void examine_pair(const Starter* a, const Starter* b, Starts& starts) {
  if (b->source >= 0 && (a->source < 0 || b->source < a->source)) std::swap(a, b);
  if (a->source < 0) return;
  // if one of the two promises nothing, the other one must keep clear
  const Behavior own = starts.scenario.robots[static_cast<std::size_t>(a->source)].behavior;
  if (b->source >= 0 && !promises(own) && counted_on(*a, *b, starts)) std::swap(a, b);
  if (const auto expected = counted_on(*b, *a, starts)) {
    examine(*a, *b, *expected, starts);
  } else if (b->source >= 0) {
    if (const auto other = counted_on(*a, *b, starts)) examine(*b, *a, *other, starts);
  }
}

// Examines the pairs of one group of starters with reaches that differ by a factor of two at most.
// These are pairs within the group, and pairs with all starters of less reach. So a starter with a
// long reach costs the others nothing.
void examine_group(std::size_t first, std::size_t last, Starts& starts) {
  const std::vector<Starter>& starters = starts.starters;
  std::vector<Vec2> positions;
  double reach = 0.0;
  for (std::size_t j = first; j < last; ++j) {
    positions.push_back(starters[j].position);
    reach = std::max(reach, starters[j].reach);
  }
  PointGrid grid;
  grid.build(positions, 2.0 * reach);
  SearchScratch scratch;
  for (std::size_t i = 0; i < last; ++i) {
    for (const NeighborHit& hit :
         grid.gather(starters[i].position, -1, positions.size(), scratch)) {
      const std::size_t j = first + static_cast<std::size_t>(hit.index);
      if (j <= i) continue;  // the starter itself, or a pair that was examined already
      examine_pair(&starters[i], &starters[j], starts);
      if (starts.broken.size() >= BrokenAssumptions::kCounted) return;
    }
  }
}

Starts starts_of(const Scenario& scenario, const CertificateLaw& law) {
  Starts starts{scenario, law, longest_first_step(law), is_mixed(scenario)};
  starts.law.step.longest_step = 0.0;
  collect_starters(starts);
  return starts;
}

// Takes the deepest ones.
void take_starts(const std::vector<BrokenStart>& broken, BrokenAssumptions& result) {
  result.start_count = static_cast<std::int64_t>(broken.size());
  result.starts.resize(std::min(broken.size(), BrokenAssumptions::kNamed));
  std::partial_sort_copy(broken.begin(), broken.end(), result.starts.begin(), result.starts.end(),
                         [](const BrokenStart& a, const BrokenStart& b) {
                           if (a.depth != b.depth) return a.depth > b.depth;
                           if (a.robot != b.robot) return a.robot.value < b.robot.value;
                           return rank_of(a.other) < rank_of(b.other);
                         });
}

}  // namespace

void find_broken_starts(const Scenario& scenario, const CertificateLaw& law,
                        BrokenAssumptions& result) {
  Starts starts = starts_of(scenario, law);
  std::vector<Starter>& starters = starts.starters;
  std::stable_sort(starters.begin(), starters.end(), [](const Starter& a, const Starter& b) {
    return std::ilogb(a.reach) < std::ilogb(b.reach);
  });
  for (std::size_t first = 0; first < starters.size();) {
    std::size_t last = first;
    while (last < starters.size() &&
           std::ilogb(starters[last].reach) == std::ilogb(starters[first].reach)) {
      ++last;
    }
    examine_group(first, last, starts);
    if (starts.broken.size() >= BrokenAssumptions::kCounted) break;
    first = last;
  }
  take_starts(starts.broken, result);
}

void find_starts_of_first(const Scenario& scenario, const CertificateLaw& law, double margin,
                          BrokenAssumptions& result) {
  Starts starts = starts_of(scenario, law);
  starts.margin = margin;
  for (std::size_t k = 1; k < starts.starters.size(); ++k)
    examine_pair(&starts.starters[0], &starts.starters[k], starts);
  take_starts(starts.broken, result);
}

}  // namespace avo::inline sim
