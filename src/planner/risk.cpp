// SPDX-License-Identifier: Apache-2.0
// The probability that noise hides a violated half-plane.
#include <numbers>

#include "avo/planner.h"
#include "core/elementary.h"
#include "planner/decision.h"
#include "planner/stages/pair_planes.h"
#include "planner/validity.h"

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

}  // namespace

double Planner::half_plane_risk(const Robot& robot, const Neighbor& neighbor,
                                Vec2 new_velocity) const {
  PlannerOptions options = options_;
  const SensingNoise& noise = options.sensing_noise;
  if (!(noise.position > 0.0 || noise.velocity > 0.0)) return 0.0;
  if (!is_valid(robot) || !is_valid(neighbor)) return 1.0;
  const auto keeps = [&](double quantile) {
    options.sensing_noise.quantile = quantile;
    bool overlapping = false;
    const auto own = own_half_plane(options, *horizon_, robot, neighbor, 0, overlapping);
    return !overlapping && (!own || (!(own->excess > 0.0) && dot(own->plane.normal, new_velocity) >=
                                                                 own->plane.offset - kKept));
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
