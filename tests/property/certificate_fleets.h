// SPDX-License-Identifier: Apache-2.0
// Small fleets that choose as badly as the certificate admits: no optimizer, no goals.
#pragma once
#include <cstddef>
#include <ostream>
#include <vector>

#include "support/certificates.h"

namespace avo::test {

/// How a robot picks its next velocity.
enum class Whim { random, at_the_nearest, at_where_it_stops, past_the_nearest, backup };

struct Fleet {
  PlannerOptions options;
  std::vector<Robot> robots;
  std::vector<Neighbor> movers;  ///< decide nothing, keep their acceleration
};

/// Unequal radii, a_max, v_max, over a decade each.
inline Robot random_robot(Random& random) {
  Robot robot;
  robot.radius = random.log_uniform(0.1, 1.5);
  robot.max_acceleration = random.log_uniform(0.3, 4.0);
  robot.max_speed = random.log_uniform(0.4, 4.0);
  return robot;
}

inline bool touches(const Robot& robot, const std::vector<Neighbor>& all) {
  return std::any_of(all.begin(), all.end(), [&](const Neighbor& other) {
    return norm(robot.position - other.position) <= 1.000001 * (robot.radius + other.radius);
  });
}

/// 2 to 8 robots close together, in any motion that joint braking still ends without contact; now
/// and then 10^7 m off.
inline Fleet random_fleet(Random& random, Certificate kind, Motion motion) {
  Fleet fleet;
  fleet.options = random_options(random, kind, motion);
  const CertificateLaw law = law_of(fleet.options);
  const Vec2 offset = random.below(8) == 0 ? 1e7 * random.direction() : Vec2{};
  const int count = 2 + random.below(7);
  const bool brakes_otherwise = random.below(2) == 0;
  double extent = 1.0;
  while (static_cast<int>(fleet.robots.size()) < count) {
    extent *= 1.05;
    Robot robot = random_robot(random);
    if (brakes_otherwise) robot.max_braking = random_braking(random, robot.max_acceleration);
    robot.position = offset + in_disc(random, extent);
    if (touches(robot, others(fleet.robots, count))) continue;
    fleet.robots.push_back(robot);
    Robot& last = fleet.robots.back();
    double speed = last.max_speed;
    do {
      last.velocity = speed < 0.02 ? Vec2{} : in_disc(random, speed);
      speed *= 0.7;
    } while (last.velocity != Vec2{} && !invariant_holds(fleet.robots, law));
    // even at rest the robot may block another robot
    if (!invariant_holds(fleet.robots, law)) fleet.robots.pop_back();
  }
  return fleet;
}

/// The admitted velocity farthest from the backup towards `wish`, by bisection.
inline Vec2 farthest_admitted(const Robot& robot, Vec2 wish, const CertificateLaw& law,
                              CertificateConstraints& constraints, int bisections = 12) {
  if (admits(robot, wish, law, constraints)) return wish;
  const Vec2 backup = backup_velocity(robot, law);
  Vec2 best = backup;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < bisections; ++i) {
    const double part = 0.5 * (low + high);
    const Vec2 candidate = backup + part * (wish - backup);
    if (admits(robot, candidate, law, constraints)) {
      low = part;
      best = candidate;
    } else {
      high = part;
    }
  }
  return best;
}

/// v + `change`, shortened to v_max.
inline Vec2 within_speed(const Robot& robot, Vec2 change) {
  const Vec2 next = robot.velocity + change;
  const double speed = norm(next);
  return speed > robot.max_speed ? ((1.0 - 1e-15) * robot.max_speed / speed) * next : next;
}

inline Vec2 adverse_velocity(Random& random, const Robot& robot, Whim whim,
                             const std::vector<Neighbor>& neighbors, const CertificateLaw& law,
                             CertificateConstraints& constraints) {
  const double u = increment(robot.max_acceleration, law.step);
  if (whim == Whim::random) {
    for (int i = 0; i < 6; ++i) {
      const Vec2 next = within_speed(robot, in_disc(random, u));
      if (admits(robot, next, law, constraints)) return next;
    }
  }
  if (whim == Whim::random || whim == Whim::backup) return backup_velocity(robot, law);
  const Neighbor* nearest = neighbors.data();
  for (const Neighbor& each : neighbors) {
    if (norm(each.position - robot.position) < norm(nearest->position - robot.position)) {
      nearest = &each;
    }
  }
  Vec2 towards = nearest->position - robot.position;
  if (whim == Whim::at_where_it_stops && nearest->behavior == Behavior::decides) {
    const double b = decrement_of(*nearest, law.step);
    const double speed = norm(nearest->velocity);
    if (speed > 0.0) {
      towards = towards + (stopping_length(speed, b, law.step) / speed) * nearest->velocity;
    }
  }
  if (whim == Whim::past_the_nearest) towards = towards + 0.7 * perpendicular(towards);
  const double length = norm(towards);
  const Vec2 push = length > 0.0 ? (u / length) * towards : Vec2{u, 0.0};
  return farthest_admitted(robot, within_speed(robot, push), law, constraints);
}

/// At most 1 where v_1 is a mixture of full braking and of a velocity within u of v: it is in one
/// of the discs between these two.
inline double part_of_ability(const Robot& robot, Vec2 next, const CertificateLaw& law) {
  const double u = increment(robot.max_acceleration, law.step);
  const Vec2 v = robot.velocity, backup = backup_velocity(robot, law);
  const auto missing = [&](double part) {
    return norm(next - (v + part * (backup - v))) - (1.0 - part) * u;
  };
  return 1.0 + std::min(missing(1.0), refined_least(missing, 1.0, 8, 60)) / u;
}

/// What one step of the whole fleet showed.
struct Witness {
  double least_gap = 1.0 / 0.0;  ///< m, between robots
  double most_change = 0.0;      ///< see part_of_ability()
  double most_speed = 0.0;       ///< of |v| / v_max
  bool backup_refused = false;   ///< by a robot with more gap than rounding can cost
};

}  // namespace avo::test
