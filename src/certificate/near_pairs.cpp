// SPDX-License-Identifier: Apache-2.0
// Beyond which distance nobody need be looked at.
#include "certificate/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate/kernels.h"

namespace avo {

FarBound far_bound_of(const Robot& robot, const StepLaw& law) {
  const double h = law.time_step, u = braking_decrement(robot.max_acceleration, law);
  const double per_u = 1.0 / u, top = law.sensing_error.velocity + u;  // that one at rest may have
  const double lost = std::abs(law.lag - 0.5 * h);
  // at least what one step and stopping take: v²/2a and what is lost by stopping in steps
  const std::array<double, 3> reach{
      (h - law.lag + lost) * top + h * (0.5 * top * top * per_u + 0.125 * u),
      h + h * top * per_u + lost, 0.5 * h * per_u};
  const auto reach_at = [&reach](double v) { return reach[0] + v * (reach[1] + v * reach[2]); };
  const double own = norm(robot.velocity);
  const double speed = kFarther * std::max(robot.max_speed, own);
  const double intervals = 3.0 + (speed + top) * per_u;
  const double error = law.sensing_error.position + law.sensing_error.velocity * h * intervals;
  // of the rounding margin, what does not grow with the distance
  const double places = std::abs(robot.position.x) + std::abs(robot.position.y);
  const double lengths = robot.radius + reach_at(own);
  const double margin = 0x1p-46 * (places + lengths + robot.radius + reach_at(speed)) * intervals;
  const bool is_known = intervals <= kMostIntervals;
  return {is_known ? lengths + error + margin : std::numeric_limits<double>::infinity(), reach,
          robot.max_acceleration, speed * speed};
}

}  // namespace avo
