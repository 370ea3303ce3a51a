// SPDX-License-Identifier: Apache-2.0
// The table of Eq. (9)'s gain, once per (δ, τ); see response_kernel.h for values between nodes.
#include "avo/horizon.h"

#include <algorithm>
#include <cmath>

#include "avo/response.h"
#include "obstacles/response_kernel.h"

namespace avo {
namespace {

constexpr double kNodesPerControlTime = 32.0;
// Past 40 δ the exponential is below 2^-57 of the other terms.
constexpr double kTableControlTimes = 40.0;

}  // namespace

Horizon::Horizon(double control_time, double time_horizon, double time_step)
    : control_time_(control_time) {
  const Response response = Response::proportional(control_time);
  const double last =
      std::min(std::max(time_horizon, time_step), kTableControlTimes * control_time);
  const double seconds_per_node = control_time / kNodesPerControlTime;
  const auto count = static_cast<std::size_t>(last / seconds_per_node) + 2;
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) * seconds_per_node;
    gain_.push_back(response.gain(t));
    rate_.push_back(response.rate(t));
  }
  end_.time = time_horizon;
  end_ = at(time_horizon);
  step_ = at(time_step);
}

ResponseTable Horizon::table() const noexcept {
  const double seconds_per_node = control_time_ / kNodesPerControlTime;
  return {gain_.data(),
          rate_.data(),
          1.0 / seconds_per_node,
          seconds_per_node,
          static_cast<double>(gain_.size() - 1),
          control_time_,
          1.0 / control_time_,
          end_.time};
}

ResponseAt Horizon::at(double t) const noexcept {
  const auto result = scalar::at(table(), scalar::Pack<double>(t));
  return {t, result.gain.value, result.rate.value, result.lag.value, result.per_rate.value};
}

}  // namespace avo
