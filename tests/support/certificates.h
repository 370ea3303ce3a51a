// SPDX-License-Identifier: Apache-2.0
// Common parts of the certificate's tests: laws, true motion within a step, the least distance of
// two robots.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "avo/planner.h"
#include "avo/response.h"
#include "certificate/certificate.h"
#include "planner/stages/certify.h"
#include "support/generators.h"

namespace avo::test {

inline PlannerOptions options_of(Certificate kind, Motion motion, double time_step,
                                 double control_time) {
  PlannerOptions options;
  options.certificate = kind;
  options.motion = motion;
  options.time_step = time_step;
  options.control_time = control_time;
  return options;
}

inline CertificateLaw law_of(const PlannerOptions& options) {
  return certificate_law(Planner(options));
}

/// Returns less than a_max or more. For one robot in three it returns none: that robot brakes with
/// all of a_max.
inline std::optional<double> random_braking(Random& random, double max_acceleration) {
  if (random.below(3) == 0) return std::nullopt;
  return random.log_uniform(0.3, 4.0) * max_acceleration;
}

/// Returns options with Δt 0.02 to 0.5 s, δ from Δt to 4 s.
inline PlannerOptions random_options(Random& random, Certificate kind, Motion motion) {
  const double time_step = random.log_uniform(0.02, 0.5);
  return options_of(kind, motion, time_step, random.log_uniform(time_step, 4.0));
}

inline Neighbor seen(const Robot& robot) {
  return {.position = robot.position,
          .velocity = robot.velocity,
          .radius = robot.radius,
          .max_acceleration = robot.max_acceleration,
          .priority = robot.priority,
          .max_braking = robot.max_braking,
          .loiter = robot.loiter};
}

inline std::vector<TrajectoryConstraint> all_constraints(const TrajectoryConstraints& constraints) {
  std::vector<TrajectoryConstraint> all;
  for (std::size_t k = 0; k < constraints.columns.count; ++k) {
    if (constraints.columns.is_constraint(k)) all.push_back(constraint_at(constraints.columns, k));
  }
  return all;
}

/// Returns all robots but one, as that robot sees them. The certificate needs no order.
inline std::vector<Neighbor> others(const std::vector<Robot>& robots, std::size_t self) {
  std::vector<Neighbor> result;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    if (k != self) result.push_back(seen(robots[k]));
  }
  return result;
}

/// One step from v to v_1 within [0, Δt]: position p + t v + g(t)/E(Δt) (v_1 - v), Eqs. (8), (9),
/// or with held acceleration.
struct TrueStep {
  Vec2 position, velocity, next_velocity;

  Vec2 at(double t, const PlannerOptions& options) const {
    const double h = options.time_step;
    const Response response = Response::proportional(options.control_time);
    const double part =
        options.motion == Motion::held ? t * t / (2.0 * h) : response.gain(t) / response.rate(h);
    return position + t * velocity + part * (next_velocity - velocity);
  }
};

/// Returns the real roots within [0, most] of c0 + c1 t + c2 t² + c3 t³, up to rounding. Between
/// the extrema the cubic is monotone.
inline std::vector<double> cubic_roots(const std::array<double, 4>& c, double most) {
  const auto value = [&](double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); };
  std::vector<double> bounds{0.0, most}, roots;
  const double root = 4.0 * c[2] * c[2] - 12.0 * c[3] * c[1];
  if (c[3] != 0.0 && root > 0.0) {
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-2.0 * c[2] + sign * std::sqrt(root)) / (6.0 * c[3]);
      if (t > 0.0 && t < most) bounds.push_back(t);
    }
  } else if (c[3] == 0.0 && c[2] != 0.0) {
    const double t = -c[1] / (2.0 * c[2]);
    if (t > 0.0 && t < most) bounds.push_back(t);
  }
  std::sort(bounds.begin(), bounds.end());
  for (std::size_t k = 0; k + 1 < bounds.size(); ++k) {
    double low = bounds[k], high = bounds[k + 1];
    if ((value(low) < 0.0) == (value(high) < 0.0)) continue;
    const bool at_low = value(low) < 0.0;
    for (int i = 0; i < 80; ++i) {
      const double t = 0.5 * (low + high);
      ((value(t) < 0.0) == at_low ? low : high) = t;
    }
    roots.push_back(low);
  }
  return roots;
}

/// Returns the least value(t) on [0, h]: by samples, then by thirds around the least sample.
template <typename Value>
double refined_least(const Value& value, double h, int samples, int thirds) {
  int nearest = 0;
  for (int k = 0; k <= samples; ++k) {
    if (value(h * k / samples) < value(h * nearest / samples)) nearest = k;
  }
  double low = h * std::max(nearest - 1, 0) / samples;
  double high = h * std::min(nearest + 1, samples) / samples;
  for (int i = 0; i < thirds; ++i) {
    const double third = (high - low) / 3.0;
    if (value(low + third) < value(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return value(0.5 * (low + high));
}

/// Returns half of the slope of |p + v t + c t²/2|² as a cubic of the time.
inline std::array<double, 4> distance_slope(Vec2 p, Vec2 v, Vec2 c) {
  return {dot(p, v), dot(v, v) + dot(p, c), 1.5 * dot(v, c), 0.5 * dot(c, c)};
}

/// Returns the least distance of two robots within one step, m. It is exact for held motion (the
/// distance squared is a quartic), and otherwise sampled and refined.
inline double least_distance(const TrueStep& a, const TrueStep& b, const PlannerOptions& options) {
  const TrueStep relative{a.position - b.position, a.velocity - b.velocity,
                          a.next_velocity - b.next_velocity};
  const double h = options.time_step;
  const auto distance = [&](double t) { return norm(relative.at(t, options)); };
  double least = std::min(distance(0.0), distance(h));
  if (options.motion == Motion::held) {
    const Vec2 p = relative.position, v = relative.velocity;
    const Vec2 c = (relative.next_velocity - v) / h;
    for (const double t : cubic_roots(distance_slope(p, v, c), h))
      least = std::min(least, distance(t));
    return least;
  }
  return std::min(least, refined_least(distance, h, 32, 40));
}

/// Returns whether all pairs keep the certificate's invariant.
inline bool invariant_holds(const std::vector<Robot>& robots, const CertificateLaw& law) {
  CertificateConstraints constraints;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    collect_constraints(robots[k], others(robots, k), law, constraints);
    if (constraints.invariant.broken.any() || constraints.invariant.unknown) return false;
  }
  return true;
}

// Returns the worst constraint of a path, also if it violates none; all constraints are evaluated.
inline WorstConstraint worst_of_all(const TrajectoryConstraints& constraints,
                                    const CandidatePath& path, const StepLaw& law) {
  const ConstraintColumns& columns = constraints.columns;
  WorstConstraint worst = worst_constraint(constraints, path, law, 0, columns.count);
  for (std::size_t k = 0; k < columns.count; ++k)
    worst.coefficient = std::min(worst.coefficient, columns.coefficient[k]);
  return worst;
}

}  // namespace avo::test
