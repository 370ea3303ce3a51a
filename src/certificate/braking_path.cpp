// SPDX-License-Identifier: Apache-2.0
// Straight full braking in steps.
#include "certificate/braking_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace avo {

double braking_steps(double speed, double decrement) {
  return std::floor(speed / decrement) + 1.0;
}

double stopping_length(double speed, double decrement, const StepLaw& law) {
  // speed = (k + f) u: k full steps and a last one from f u to rest
  const double k = std::floor(speed / decrement);
  const double rest = std::max(speed - k * decrement, 0.0);  // f u
  return law.time_step * k * (0.5 * (k - 1.0) * decrement + rest) +
         law.lag * (k * decrement + rest);
}

void BrakingDistances::brake(double speed, double decrement, const StepLaw& law, int intervals) {
  const auto count = static_cast<std::size_t>(intervals);
  if (start.size() < count) start.resize(count), middle.resize(count), end.resize(count);
  const double lead = law.time_step - law.lag;
  double distance = 0.0;
  for (std::size_t m = 0; m < count; ++m) {
    start[m] = distance;
    middle[m] = distance + law.lag * speed;
    const double next = std::max(speed - decrement, 0.0);
    distance = middle[m] + lead * next;
    end[m] = distance;
    speed = next;
  }
}

}  // namespace avo
