// SPDX-License-Identifier: Apache-2.0
// The search for overlaps.
#include "unit/certificate/broken_proof.h"

#include <limits>

namespace avo::test {
namespace {

/// What a robot is after during one trial.
struct Aim {
  std::size_t target = 0;
  bool at_its_stop = false;
  double turn = 0.0;  ///< rad, off the direction to the target
  int from = 0;       ///< step; it brakes before
};

Vec2 push(const Robot& robot, const Robot& target, const Aim& aim, const PlannerOptions& options) {
  Vec2 towards = target.position - robot.position;
  const double speed = norm(target.velocity);
  if (aim.at_its_stop && speed > 0.0) {
    towards = towards + (0.5 * speed / target.max_acceleration) * target.velocity;
  }
  const double length = std::max(norm(towards), 1e-9);
  const Vec2 next =
      robot.velocity + (decrement_of(robot, options) / length) * turned(towards, aim.turn);
  return norm(next) > robot.max_speed ? (robot.max_speed / norm(next)) * next : next;
}

// The farthest that is admitted between the backup and what is wished.
Vec2 as_far_as_admitted(const Choices& choices, Vec2 wish) {
  if (choices.admits(wish)) return wish;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 8; ++i) {
    const double part = 0.5 * (low + high);
    (choices.admits(choices.backup + part * (wish - choices.backup)) ? low : high) = part;
  }
  return choices.backup + low * (wish - choices.backup);
}

double least_gap(const std::vector<TrueStep>& steps, const std::vector<Robot>& robots,
                 const PlannerOptions& options) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double contact = robots[i].radius + robots[j].radius;
      const double moved = norm(steps[i].velocity - steps[j].velocity) +
                           decrement_of(robots[i], options) + decrement_of(robots[j], options);
      const double distance = norm(steps[i].position - steps[j].position);
      if (distance - contact > moved * options.time_step) continue;
      least = std::min(least, least_distance(steps[i], steps[j], options) - contact);
    }
  }
  return least;
}

double trial(const Rule& rule, const Search& search, Random& random) {
  const PlannerOptions& options = search.options;
  std::vector<Robot> robots = search.start(random, options);
  std::vector<Aim> aims(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const auto step =
        static_cast<std::size_t>(1 + random.below(static_cast<int>(robots.size()) - 1));
    aims[k] = {(k + step) % robots.size(), random.below(2) == 0,
               random.below(2) == 0 ? 0.0 : random.uniform(-1.5, 1.5),
               random.below(3) == 0 ? random.below(search.steps) : 0};
  }
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2 * search.steps; ++k) {
    std::vector<TrueStep> steps;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Choices choices = rule(robots, i, options);
      const bool brakes = k >= search.steps || k < aims[i].from;
      const Vec2 wish = push(robots[i], robots[aims[i].target], aims[i], options);
      steps.push_back({robots[i].position, robots[i].velocity,
                       brakes ? choices.backup : as_far_as_admitted(choices, wish)});
    }
    least = std::min(least, least_gap(steps, robots, options));
    for (std::size_t i = 0; i < robots.size(); ++i) {
      robots[i].position = steps[i].at(options.time_step, options);
      robots[i].velocity = steps[i].next_velocity;
    }
  }
  return least;
}

}  // namespace

double deepest_overlap(const Rule& rule, const Search& search) {
  double least = std::numeric_limits<double>::infinity();
  for (int seed = 1; seed <= search.trials; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    least = std::min(least, trial(rule, search, random));
  }
  return -least;
}

}  // namespace avo::test
