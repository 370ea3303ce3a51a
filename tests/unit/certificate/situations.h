// SPDX-License-Identifier: Apache-2.0
// Pairs of robots to derive constraints from, and the rules of docs/certificate.md written out
// plainly.
#pragma once
#include <array>
#include <vector>

#include "support/certificates.h"

namespace avo::test {

inline constexpr Certificate kTrajectories = Certificate::braking_trajectories;
inline constexpr Motion kMotions[] = {Motion::held, Motion::exponential};

/// All that one robot has to keep to beside one other.
inline CertificateConstraints constraints_of(const Robot& self, const Robot& other,
                                             const CertificateLaw& law) {
  CertificateConstraints constraints;
  collect_constraints(self, std::vector<Neighbor>{seen(other)}, law, constraints);
  return constraints;
}

struct PairSituation {
  PlannerOptions options;
  CertificateLaw law;
  Robot a, b;
};

inline Robot random_body(Random& random) {
  Robot robot;
  robot.radius = random.log_uniform(0.1, 2.0);
  robot.max_acceleration = random.log_uniform(0.2, 5.0);
  robot.max_speed = random.log_uniform(0.3, 4.0);
  robot.velocity = random.below(5) == 0 ? Vec2{} : in_disc(random, robot.max_speed);
  return robot;
}

/// Near enough to matter, not in contact; joint braking may collide. unlike: of equal a_max, most
/// of them, unequal priorities, and limits of braking, some of which are equal.
inline PairSituation random_pair(Random& random, Certificate kind, Motion motion,
                                 bool unlike = false) {
  PairSituation s;
  s.options = random_options(random, kind, motion);
  s.law = law_of(s.options);
  s.a = random_body(random);
  s.b = random_body(random);
  if (unlike) {
    if (random.below(4) > 0) s.b.max_acceleration = s.a.max_acceleration;
    s.a.priority = random.log_uniform(0.01, 100.0);
    s.b.priority = random.log_uniform(0.01, 100.0);
    s.a.max_braking = random_braking(random, s.a.max_acceleration);
    s.b.max_braking = random_braking(random, s.b.max_acceleration);
    if (random.below(3) == 0 && s.a.max_acceleration == s.b.max_acceleration) {
      s.b.max_braking = s.a.max_braking;
      if (random.below(2) == 0) s.b.priority = s.a.priority;
    }
  }
  const double gap =
      random.below(3) == 0 ? random.log_uniform(1e-6, 1.0) : random.uniform(0.0, 6.0);
  s.a.position = in_disc(random, 5.0);
  s.b.position = s.a.position + ((s.a.radius + s.b.radius) * 1.000001 + gap) * random.direction();
  return s;
}

/// The invariant of this pair holds.
inline PairSituation sound_pair(Random& random, Certificate kind, Motion motion,
                                bool unlike = false) {
  for (;;) {
    const PairSituation s = random_pair(random, kind, motion, unlike);
    if (invariant_holds({s.a, s.b}, s.law)) return s;
  }
}

/// Within u of v, anywhere.
inline Vec2 random_choice(Random& random, const PairSituation& s) {
  const double u = increment(s.a.max_acceleration, s.law.step);
  return s.a.velocity + (random.below(3) == 0 ? u * random.direction() : in_disc(random, u));
}

using Points = std::array<Vec2, 3>;

/// Bézier points of "to v_1 in one step, then braking", step by step.
inline std::vector<Points> stepped_path(const Robot& robot, Vec2 next, const StepLaw& law,
                                        int count) {
  const double u = decrement_of(robot, law);
  std::vector<Points> path;
  Vec2 p = robot.position, v = robot.velocity;
  for (int m = 0; m < count; ++m) {
    const Vec2 middle = p + law.lag * v, end = middle + (law.time_step - law.lag) * next;
    path.push_back({p, middle, end});
    p = end;
    v = next;
    const double speed = norm(v);
    next = speed > u ? v - (u / speed) * v : Vec2{};
  }
  return path;
}

inline std::vector<Points> stepped_braking(const Robot& robot, const StepLaw& law, int count) {
  const double u = decrement_of(robot, law), speed = norm(robot.velocity);
  return stepped_path(robot, speed > u ? robot.velocity - (u / speed) * robot.velocity : Vec2{},
                      law, count);
}

/// Whether full acceleration towards each other, then braking, leaves a gap.
inline bool out_of_reach(const PairSituation& s) {
  double gap = norm(s.a.position - s.b.position) - s.a.radius - s.b.radius;
  const StepLaw& law = s.law.step;
  for (const Robot* robot : {&s.a, &s.b}) {
    const double u = decrement_of(*robot, law), speed = norm(robot->velocity);
    const double most = speed + increment(robot->max_acceleration, law);
    gap -= law.lag * speed + (law.time_step - law.lag) * most;
    for (double next = most; next > 0.0; next -= u) {
      gap -= law.lag * next + (law.time_step - law.lag) * std::max(next - u, 0.0);
    }
  }
  return gap > 0.0;
}

}  // namespace avo::test
