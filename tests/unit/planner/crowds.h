// SPDX-License-Identifier: Apache-2.0
// One robot in a crowd: situations for plan(), dense and degenerate ones on purpose.
#pragma once
#include <algorithm>
#include <limits>
#include <ostream>
#include <vector>

#include "avo/planner.h"
#include "support/generators.h"

namespace avo::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The paper's method with its constants: δ 4 s, τ 10 s.
inline PlannerOptions paper_options() {
  return default_options(Method::avo_paper);
}

struct Crowd {
  PlannerOptions options = paper_options();
  Robot robot;
  std::vector<Neighbor> neighbors;
};

inline std::ostream& operator<<(std::ostream& out, Vec2 a) {
  return out << "{" << a.x << ", " << a.y << "}";
}

inline std::ostream& operator<<(std::ostream& out, const Crowd& crowd) {
  out.precision(17);
  const Robot& A = crowd.robot;
  out << "delta " << crowd.options.control_time << " tau " << crowd.options.time_horizon
      << "\nrobot p " << A.position << " v " << A.velocity << " pref " << A.preferred_velocity
      << " r " << A.radius << " a " << A.max_acceleration << " v_max " << A.max_speed;
  for (const Neighbor& B : crowd.neighbors) {
    out << "\n  p " << B.position << " v " << B.velocity << " r " << B.radius << " a "
        << B.max_acceleration << " observed " << B.acceleration
        << (B.behavior == Behavior::decides ? " decides" : " moves on");
  }
  return out;
}

/// The paper's constants (§VI-A).
inline Robot paper_robot(Vec2 position, Vec2 velocity, Vec2 preferred) {
  return {position, velocity, preferred, 0.5, 1.0, 2.0};
}

inline Neighbor as_neighbor(const Robot& robot) {
  return {.position = robot.position,
          .velocity = robot.velocity,
          .radius = robot.radius,
          .max_acceleration = robot.max_acceleration,
          .priority = robot.priority};
}

inline Vec2 velocity_or_rest(Random& random, double most) {
  return random.below(5) == 0 ? Vec2{} : in_disc(random, most);
}

/// `gap` of the smallest radius away, at least; negative gaps overlap.
inline Neighbor random_neighbor(Random& random, const Robot& robot, double least_gap) {
  Neighbor B;
  B.radius = robot.radius * random.log_uniform(0.3, 3.0);
  const double contact = robot.radius + B.radius;
  const double gap =
      random.below(3) == 0 ? random.uniform(least_gap, 0.3) : random.log_uniform(1e-3, 12.0);
  B.position = robot.position + contact * (1.0 + gap) * random.direction();
  B.velocity = velocity_or_rest(random, robot.max_speed);
  B.max_acceleration = robot.max_acceleration * random.log_uniform(0.3, 3.0);
  switch (random.below(6)) {
    case 0:
      B.behavior = Behavior::moves_on;
      if (random.below(2) == 0) B.acceleration = in_disc(random, robot.max_acceleration);
      break;
    case 1:
      B.velocity = robot.velocity;
      break;
    case 2:  // head-on
      B.velocity = (norm(B.velocity) / (contact * (1.0 + gap))) * (robot.position - B.position);
      break;
    default:
      break;
  }
  return B;
}

/// Up to 12 neighbors with gaps down to `least_gap` of the radii's sum; δ 0.1 to 8 s.
inline Crowd random_crowd(Random& random, double least_gap) {
  Crowd crowd;
  crowd.options.control_time = random.log_uniform(0.1, 8.0);
  crowd.options.time_horizon = random.log_uniform(0.5, 15.0);
  Robot& A = crowd.robot;
  A.radius = random.log_uniform(0.1, 2.0);
  A.max_acceleration = random.log_uniform(0.2, 5.0);
  A.max_speed = random.log_uniform(0.3, 5.0);
  A.position = in_disc(random, 30.0);
  A.velocity = velocity_or_rest(random, A.max_speed);
  A.preferred_velocity = velocity_or_rest(random, 1.2 * A.max_speed);
  const int count = random.below(13);
  for (int k = 0; k < count; ++k) {
    crowd.neighbors.push_back(random_neighbor(random, A, least_gap));
  }
  return crowd;
}

inline constexpr Certificate kCertificates[] = {Certificate::none,
                                                Certificate::braking_trajectories};

/// The same crowd by method avo.
inline Crowd by_avo(Random& random, Crowd crowd, Certificate certificate) {
  crowd.options.method = Method::avo;
  crowd.options.certificate = certificate;
  Robot& A = crowd.robot;
  if (random.below(3) > 0) A.distance_to_goal = A.radius * random.log_uniform(0.1, 30.0);
  return crowd;
}

/// By the paper's method, or by avo under each certificate in turn.
inline Crowd any_crowd(Random& random, int turn, double least_gap) {
  const Crowd crowd = random_crowd(random, least_gap);
  return turn % 3 == 0 ? crowd : by_avo(random, crowd, kCertificates[turn % 3 - 1]);
}

inline Plan plan_of(const Crowd& crowd) {
  PlanWorkspace workspace;
  return Planner(crowd.options).plan(crowd.robot, crowd.neighbors, workspace);
}

}  // namespace avo::test
