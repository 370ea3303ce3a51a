// SPDX-License-Identifier: Apache-2.0
// How likely it is that noise hides a broken half-plane.
#include <cmath>
#include <numbers>

#include "avo/planner.h"
#include "planner/decision.h"
#include "planner/soft_planes.h"

namespace avo {
namespace {

constexpr double kMostQuantile = 8.0;  // beyond it the probability is below 1e-15
constexpr int kBisections = 40;
constexpr double kKept = 1e-9;  // m/s, rounding of a choice on the half-plane

// Of a standard normal variable to exceed q.
double tail(double q) {
  return 0.5 * std::erfc(q / std::numbers::sqrt2);
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
  for (int i = 0; i < kBisections; ++i) {
    const double q = 0.5 * (kept + broken);
    (keeps(q) ? kept : broken) = q;
  }
  return tail(kept);
}

}  // namespace avo
