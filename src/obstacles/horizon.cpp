// SPDX-License-Identifier: Apache-2.0
// Eq. (9)'s gain from a table: between nodes the response continues as
// g(t_k + h) = g(t_k) + h g'(t_k) + e^{-t_k/δ} g(h), a sum without cancellation.
#include "avo/horizon.h"

#include <algorithm>
#include <cmath>

#include "avo/response.h"

namespace avo {
namespace {

constexpr double kNodesPerControlTime = 32.0;
// Past 40 δ the exponential is below 2^-57 of what it is added to.
constexpr double kTableControlTimes = 40.0;

// u + e^{-u} - 1 for 0 <= u <= 1/32 (and a rounding more): the series to u^9, 2^-58 relative.
double short_gain(double u) {
  double sum = 1.0 - u * (1.0 / 9.0);
  sum = 1.0 - u * (1.0 / 8.0) * sum;
  sum = 1.0 - u * (1.0 / 7.0) * sum;
  sum = 1.0 - u * (1.0 / 6.0) * sum;
  sum = 1.0 - u * (1.0 / 5.0) * sum;
  sum = 1.0 - u * (1.0 / 4.0) * sum;
  sum = 1.0 - u * (1.0 / 3.0) * sum;
  return 0.5 * u * u * sum;
}

}  // namespace

Horizon::Horizon(double control_time, double time_horizon, double time_step)
    : control_time_(control_time), nodes_per_second_(kNodesPerControlTime / control_time) {
  const Response response = Response::proportional(control_time);
  const double last =
      std::min(std::max(time_horizon, time_step), kTableControlTimes * control_time);
  const auto count = static_cast<std::size_t>(last * nodes_per_second_) + 2;
  nodes_.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) * control_time / kNodesPerControlTime;
    nodes_.push_back({t, response.gain(t), response.rate(t), std::exp(-t / control_time)});
  }
  end_ = at(time_horizon);
  step_ = at(time_step);
}

ResponseAt Horizon::at(double t) const noexcept {
  const auto k = static_cast<std::size_t>(
      std::min(t * nodes_per_second_, static_cast<double>(nodes_.size() - 1)));
  const Node& node = nodes_[k];
  const double h = std::max(t - node.time, 0.0);
  if (k + 1 == nodes_.size()) {
    // only past 40 δ, where g grows by h itself
    const double gain = node.gain + h;
    return {t, gain, 1.0, t - gain};
  }
  const double u = h / control_time_;
  const double extra = short_gain(u);
  const double rate = node.rate + node.decay * (u - extra);
  const double gain = node.gain + (h * node.rate + node.decay * control_time_ * extra);
  return {t, gain, rate, rate > 0.0 ? t - gain / rate : 0.0};
}

}  // namespace avo
