// SPDX-License-Identifier: Apache-2.0
// Robots that sense each other wrongly, each of which chooses the worst that its certificate
// admits.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/check.h"
#include "certificate/certificate.h"
#include "support/generators.h"

namespace avo::test {

/// A robot, or a mover that keeps its acceleration.
struct Body {
  Robot robot;
  bool decides = true;
  Vec2 acceleration = {};  // m/s^2, of a mover
  std::vector<Robot> past = {};
};

/// What is declared to the certificate, and how wrong sensing is. of_speed: velocities are wrong
/// along themselves, so that robots look slower or faster. States are up to so many steps old, and
/// carried on; whether their age is told.
struct Senses {
  SensingError declared, actual;
  bool of_speed = false;
  int oldest = 0;
  bool tells_age = true;
};

inline CertificateLaw held_law(SensingError declared) {
  CertificateLaw law;
  law.step.sensing_error = declared;
  return law;
}

inline Vec2 unit(Vec2 a) {
  const double length = norm(a);
  return length > 0.0 ? a / length : Vec2{1.0, 0.0};
}

/// How a neighbor in direction n (unit) is displaced, as a part of the bound: 0 farther, 1 nearer,
/// 2 and 3 to the sides, 4 anywhere on the rim, 5 anywhere, 6 not at all.
inline constexpr int kShapes = 7;
inline Vec2 error_of(int shape, Vec2 n, Random& random) {
  switch (shape) {
    case 0:
      return n;
    case 1:
      return -n;
    case 2:
      return perpendicular(n);
    case 3:
      return -perpendicular(n);
    case 4:
      return random.direction();
    case 5:
      return in_disc(random, 1.0);
    default:
      return {};
  }
}

/// The others as `self` senses them; the shapes of the errors of position and velocity.
inline std::vector<Neighbor> sensed(const std::vector<Body>& bodies, std::size_t self,
                                    const Senses& senses, int of_position, int of_velocity,
                                    Random& random) {
  const SensingError& error = senses.actual;
  std::vector<Neighbor> neighbors;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (k == self) continue;
    const int known = std::min(senses.oldest, static_cast<int>(bodies[k].past.size()));
    const int age = known > 0 ? random.below(known + 1) : 0;
    const Robot& other = age > 0 ? *(bodies[k].past.end() - age) : bodies[k].robot;
    const Vec2 n = unit(other.position - bodies[self].robot.position);
    const Vec2 p = other.position + error.position * error_of(of_position, n, random);
    const Vec2 along = senses.of_speed ? unit(other.velocity) : n;
    const Vec2 v = other.velocity + error.velocity * error_of(of_velocity, along, random);
    const double time = age * StepLaw{}.time_step;
    const Vec2 a = bodies[k].acceleration;
    neighbors.push_back({.position = p + time * v + (0.5 * time * time) * a,
                         .velocity = v + time * a,
                         .radius = other.radius,
                         .max_acceleration = other.max_acceleration,
                         .behavior = bodies[k].decides ? Behavior::decides : Behavior::moves_on,
                         .age = senses.tells_age ? age : 0,
                         .max_braking = other.max_braking,
                         .acceleration = a});
  }
  return neighbors;
}

/// Least distance beyond contact, at the ends of the steps, if `self` takes v_1 and then brakes
/// while the others brake, or keep their acceleration.
inline double clearance_after(const std::vector<Body>& bodies, std::size_t self, Vec2 v_1,
                              const StepLaw& law) {
  const Robot& robot = bodies[self].robot;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (k == self) continue;
    const Robot& other = bodies[k].robot;
    Vec2 v = robot.velocity, next = v_1, p = robot.position;
    Vec2 w = other.velocity, q = other.position;
    for (int m = 0;
         m < 100 && (norm_squared(v) > 0.0 || norm_squared(next) > 0.0 || norm_squared(w) > 0.0);
         ++m) {
      p = p + (0.5 * law.time_step) * (v + next);
      v = next;
      next = braked(v, decrement_of(robot, law));
      const Vec2 w_1 = bodies[k].decides ? braked(w, decrement_of(other, law))
                                         : w + law.time_step * bodies[k].acceleration;
      q = q + (0.5 * law.time_step) * (w + w_1);
      w = w_1;
      least = std::min(least, norm(p - q) - robot.radius - other.radius);
      if (!bodies[k].decides && v == Vec2{} && next == Vec2{}) break;
    }
  }
  return least;
}

/// The farthest admitted velocity from braking towards `wanted`.
inline Vec2 farthest_admitted(const Robot& robot, Vec2 wanted, const CertificateLaw& law,
                              CertificateConstraints& constraints) {
  if (admits(robot, wanted, law, constraints)) return wanted;
  const Vec2 backup = backup_velocity(robot, law);
  double good = 0.0, bad = 1.0;
  for (int i = 0; i < 12; ++i) {
    const double part = 0.5 * (good + bad);
    (admits(robot, backup + part * (wanted - backup), law, constraints) ? good : bad) = part;
  }
  return backup + good * (wanted - backup);
}

/// Returns what leaves the least clearance, of what `self` is allowed under some errors within the
/// bound. One time in `calm` (> 0) the robot takes anything admitted.
inline Vec2 worst_choice(const std::vector<Body>& bodies, std::size_t self, const Senses& senses,
                         int calm, Random& random, CertificateConstraints& constraints) {
  const Robot& robot = bodies[self].robot;
  const CertificateLaw law = held_law(senses.declared);
  const double u = braking_decrement(robot.max_acceleration, law.step);
  const bool anything = random.below(calm) == 0;
  Vec2 worst = backup_velocity(robot, law);
  double least = clearance_after(bodies, self, worst, law.step);
  for (int draw = 0; draw < (anything ? 1 : 4); ++draw) {
    const int of_position = random.below(kShapes);
    const int of_velocity = random.below(2) == 0 ? of_position : random.below(kShapes);
    const auto neighbors = sensed(bodies, self, senses, of_position, of_velocity, random);
    collect_constraints(robot, neighbors, law, constraints);
    for (int i = 0; i < (anything ? 1 : 5); ++i) {
      Vec2 change = random.below(2) == 0 ? u * random.direction() : in_disc(random, u);
      const Neighbor& other =
          neighbors[static_cast<std::size_t>(random.below(static_cast<int>(neighbors.size())))];
      const Vec2 towards = unit(other.position - robot.position);
      if (i == 1) change = u * towards;
      if (i == 2) change = u * unit(other.position - robot.position - robot.velocity);
      if (i == 3) change = u * unit(change + (3.0 * u) * towards);
      Vec2 wanted = robot.velocity + change;
      if (norm(wanted) > robot.max_speed) wanted = (robot.max_speed / norm(wanted)) * wanted;
      const Vec2 chosen = farthest_admitted(robot, wanted, law, constraints);
      const double clearance = clearance_after(bodies, self, chosen, law.step);
      if (anything || clearance < least) worst = chosen, least = clearance;
    }
  }
  return worst;
}

/// Moves all bodies by one step, deciding bodies to their new velocities.
inline void move(std::vector<Body>& bodies, const std::vector<Vec2>& next, double time_step) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Robot& robot = bodies[k].robot;
    bodies[k].past.push_back(robot);
    const Vec2 v_1 =
        bodies[k].decides ? next[k] : robot.velocity + time_step * bodies[k].acceleration;
    robot.position = robot.position + (0.5 * time_step) * (robot.velocity + v_1);
    robot.velocity = v_1;
  }
}

inline Check judge_of(const std::vector<Body>& bodies) {
  std::vector<CheckedRobot> robots;
  std::vector<CheckedMover> obstacles;
  for (const Body& body : bodies) {
    const Robot& robot = body.robot;
    if (body.decides) {
      robots.push_back({robot.radius, robot.max_acceleration, robot.max_speed, {}, 0.0});
      robots.back().max_braking = robot.max_braking;
    } else {
      obstacles.push_back({robot.position, robot.velocity, body.acceleration, robot.radius});
    }
  }
  return Check(robots, obstacles);
}

/// Deciding bodies come first.
inline void show(Check& check, double time, const std::vector<Body>& bodies) {
  std::vector<CheckedState> rows;
  for (std::size_t k = 0; k < bodies.size() && bodies[k].decides; ++k) {
    rows.push_back(
        {static_cast<std::int64_t>(k), bodies[k].robot.position, bodies[k].robot.velocity});
  }
  check.add(time, rows);
}

/// All decide at the same times, each by worst_choice and senses of its own; judged on the true
/// motion.
inline CheckReport run_adversary(std::vector<Body> bodies, const std::vector<Senses>& senses,
                                 int steps, int calm, Random& random) {
  const StepLaw law = held_law({}).step;
  Check check = judge_of(bodies);
  CertificateConstraints constraints;
  show(check, 0.0, bodies);
  std::vector<Vec2> next(bodies.size());
  for (int step = 1; step <= steps; ++step) {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      if (bodies[k].decides)
        next[k] = worst_choice(bodies, k, senses[k], calm, random, constraints);
    }
    move(bodies, next, law.time_step);
    show(check, step * law.time_step, bodies);
  }
  return check.report();
}

inline CheckReport run_adversary(const std::vector<Body>& bodies, const Senses& senses, int steps,
                                 int calm, Random& random) {
  return run_adversary(bodies, std::vector<Senses>(bodies.size(), senses), steps, calm, random);
}

}  // namespace avo::test
