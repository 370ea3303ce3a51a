// SPDX-License-Identifier: Apache-2.0
// The probability that noise hides a violated half-plane.
#include <algorithm>
#include <numbers>
#include <span>

#include "avo/planner.h"
#include "core/elementary.h"
#include "planner/alone.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/soft_planes.h"

namespace avo {
namespace {

constexpr double kMostQuantile = 8.0;  // beyond it the probability is below 1e-15
constexpr int kRiskBisections = 40;
constexpr double kKept = 1e-9;  // m/s, rounding of a choice on the half-plane

// The probability that a standard normal variable exceeds q >= 0: by a series about 0, beyond that
// by a continued fraction.
double tail(double q) {
  const double root = 1.0 + elementary::expm1(-q * q / 16.0);  // in eight parts, none of them tiny
  const double square = root * root, fourth = square * square;
  const double density = fourth * fourth * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
  if (q < 2.0) {
    double sum = 0.0;
    for (double n = 61.0; n >= 3.0; n -= 2.0) sum = q * q / n * (1.0 + sum);
    return 0.5 - density * q * (1.0 + sum);
  }
  double rest = q;
  for (double n = 60.0; n >= 1.0; n -= 1.0) rest = q + n / rest;
  return density / rest;
}

// Returns whether the only robot has no contact, and can have the velocity.
bool keeps_all(const SoftPlanes& soft, Vec2 new_velocity) {
  if (soft.overlapping[0] != 0 || soft.exceeding) return false;
  const std::span<const HalfPlane> planes = soft.of(0);
  return std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
    return dot(plane.normal, new_velocity) >= plane.offset - kKept;
  });
}

}  // namespace

double Planner::half_plane_risk(const Robot& robot, const Neighbor& neighbor,
                                Vec2 new_velocity) const {
  const SensingNoise& noise = options_.sensing_noise;
  if (!(noise.position > 0.0 || noise.velocity > 0.0)) return 0.0;
  PlanWorkspace workspace;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  if (!take_alone(robot, {&neighbor, 1}, {}, scratch)) return 1.0;
  const StepLaw law = certificate_law(*this).step;
  const auto keeps = [&](double quantile) {
    PlannerOptions options = options_;
    options.sensing_noise.quantile = quantile;
    collect_soft_planes(options, *horizon_, law, scratch.alone, scratch.soft, Kept::all);
    return keeps_all(scratch.soft, new_velocity);
  };
  if (!keeps(0.0)) return 1.0;
  double kept = 0.0, broken = kMostQuantile;
  for (int i = 0; i < kRiskBisections; ++i) {
    const double q = 0.5 * (kept + broken);
    (keeps(q) ? kept : broken) = q;
  }
  return tail(kept);
}

}  // namespace avo
