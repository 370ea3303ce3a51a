// SPDX-License-Identifier: Apache-2.0
#include "metrics/encounters.h"

#include <algorithm>
#include <limits>

#include "avo/velocity_obstacle.h"
#include "metrics/wall_contacts.h"

namespace avo {
namespace {

constexpr double kAtRest = 1e-9;  // of max_speed: no faster is at rest

// Which of two robots avoid the other. Parked ones cannot help standing where they do.
enum class Avoidance : unsigned char { none, one_sided, mutual };
Avoidance avoidance(const RobotSetup& a, const RobotSetup& b) {
  if (a.parked || b.parked) return a.parked && b.parked ? Avoidance::none : Avoidance::mutual;
  const bool of_a = avoids(a, b), of_b = avoids(b, a);
  if (of_a && of_b) return Avoidance::mutual;
  return of_a || of_b ? Avoidance::one_sided : Avoidance::none;
}

// Smallest distance of the centers over the step.
double distance(const Body& a, const Body& b, double cutoff, const StepSpan& step) {
  if (!step.response || !a.exact || !b.exact)
    return separation_of(a, b, step.duration, cutoff).distance;
  const Pair pair{a.position - b.position, a.velocity - b.velocity, a.radius + b.radius};
  const Obstacle obstacle{pair, *step.response, step.duration};
  return closest_approach(obstacle, pair.velocity + (a.w - b.w)).distance;
}

// m: any pair bounds the smallest clearance, here the first robot that avoids somebody and its
// nearest.
std::optional<double> any_clearance(const std::vector<Body>& robots) {
  std::optional<double> nearest;
  for (std::size_t i = 0; i < robots.size() && !nearest; ++i) {
    const Body& a = robots[i];
    for (std::size_t j = i + 1; j < robots.size(); ++j) {
      const Body& b = robots[j];
      if (avoidance(*a.setup, *b.setup) != Avoidance::mutual) continue;
      const double clearance = norm(b.position - a.position) - a.radius - b.radius;
      nearest = std::min(nearest.value_or(clearance), clearance);
    }
  }
  return nearest;
}

// How many different ones; orders them anew.
std::int64_t count_distinct(std::vector<std::uint64_t>& names) {
  std::sort(names.begin(), names.end());
  return std::unique(names.begin(), names.end()) - names.begin();
}

}  // namespace

void Encounters::meet(const Body& a, const Body& b, const StepSpan& step) {
  const double contact = a.radius + b.radius;
  const Avoidance kind = avoidance(*a.setup, *b.setup);
  if (kind == Avoidance::none) return;
  if (kind == Avoidance::one_sided) {
    if (!(distance(a, b, contact, step) < contact * (1.0 - kContact))) return;
    one_sided.insert(std::minmax(a.name, b.name));
    overlapping.push_back(avoids(*a.setup, *b.setup) ? a.name : b.name);
    return;
  }
  const double best = min_clearance.value_or(std::numeric_limits<double>::infinity());
  const double d = distance(a, b, contact + std::max(best, 0.0), step);
  if (d - contact < best) min_clearance = d - contact;
  const double overlaps = contact * (1.0 - kContact);
  if (!(d < overlaps)) return;
  collided.insert(std::minmax(a.name, b.name));
  for (const std::uint64_t name : {a.name, b.name}) {
    overlapping.push_back(name);
    colliding_.push_back(name);
  }
  overlap_depth = std::max(overlap_depth, (contact - d) / contact);
  const Separation closest = separation_of(a, b, step.duration, overlaps);
  const bool turns = a.arc || b.arc;  // some time at which they overlap will do
  const double fraction =
      turns ? closest.fraction : first_below(a.path, b.path, overlaps, closest.fraction);
  const double time = step.begin + fraction * step.duration;
  first_collision_time = std::min(first_collision_time.value_or(time), time);
}

void Encounters::meet_obstacle(const Body& robot, const Body& obstacle, const StepSpan& step) {
  const double contact = robot.radius + obstacle.radius;
  if (!(distance(robot, obstacle, contact, step) < contact * (1.0 - kContact))) return;
  const std::pair pair(robot.name, obstacle.name);
  if (with_obstacle.insert(pair).second) new_hits.push_back(pair);
  touched_by_movers.push_back(robot.name);
  if (way_of(robot) > kAtRest * robot.setup->max_speed * step.duration)
    with_obstacle_in_motion.insert({robot.name, obstacle.name});
}

// Every pair that can come nearer than the smallest clearance so far, or overlap.
void Encounters::observe(std::vector<Body>& robots, std::vector<Body>& obstacles,
                         const StepSpan& step) {
  overlapping.clear();
  touched_by_movers.clear();
  new_hits.clear();
  colliding_.clear();
  double largest = 0.0, farthest = 0.0;  // radius and way of a step, m
  const auto measure = [&](const Body& body) {
    largest = std::max(largest, body.radius);
    farthest = std::max(farthest, way_of(body));
  };
  std::for_each(robots.begin(), robots.end(), measure);
  if (!min_clearance) min_clearance = any_clearance(robots);
  std::for_each(obstacles.begin(), obstacles.end(), measure);

  positions_.clear();
  for (const Body& body : robots) positions_.push_back(body.position);
  const double clearance = std::max(min_clearance.value_or(0.0), 0.0);
  grid_.build(positions_, 2.0 * largest + clearance + 2.0 * farthest);
  const std::size_t all = robots.size();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const NeighborHit& hit : grid_.gather(positions_[i], static_cast<int>(i), all, scratch_)) {
      const auto j = static_cast<std::size_t>(hit.index);
      if (j > i) meet(robots[i], robots[j], step);
    }
  }
  for (const Body& obstacle : obstacles) {
    for (const NeighborHit& hit : grid_.gather(obstacle.position, -1, all, scratch_)) {
      meet_obstacle(robots[static_cast<std::size_t>(hit.index)], obstacle, step);
    }
  }
  if (step.moves) collision_robot_steps += count_distinct(colliding_);
}

}  // namespace avo
