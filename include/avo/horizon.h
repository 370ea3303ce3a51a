// SPDX-License-Identifier: Apache-2.0
// g, g' and the lag of proportional control, tabulated once per (δ, τ): no exponential per pair.
#pragma once
#include <vector>

#include "avo/export.h"

namespace avo {

/// One instant of the response, see Response.
struct ResponseAt {
  double time = 0.0;      ///< [t] s
  double gain = 0.0;      ///< [g(t) = t + δ (e^{-t/δ} - 1)] s
  double rate = 0.0;      ///< [g'(t) = 1 - e^{-t/δ}]
  double lag = 0.0;       ///< [s(t) = t - g/g'] s
  double per_rate = 0.0;  ///< [1/g'(t)], t > 0
};

/// The table that the kernels read: g and g' at the nodes k · seconds_per_node, 0 <= k <= last.
struct ResponseTable {
  const double* gain;  ///< s
  const double* rate;
  double nodes_per_second, seconds_per_node, last;
  double control_time, per_control_time;  ///< [δ] s, [1/δ] 1/s
  double end;                             ///< [τ] s
};

/// Immutable; safe to share between threads.
class AVO_API Horizon {
 public:
  /// δ, τ, Δt in s, all > 0.
  Horizon(double control_time, double time_horizon, double time_step);

  /// The response at t in [0, max(τ, Δt)], within a few ulp of Response::proportional.
  [[nodiscard]] ResponseAt at(double t) const noexcept;
  /// The response at τ.
  [[nodiscard]] const ResponseAt& end() const noexcept { return end_; }
  /// The response at Δt, the shortest window that a decision can act in.
  [[nodiscard]] const ResponseAt& step() const noexcept { return step_; }
  [[nodiscard]] double control_time() const noexcept { return control_time_; }

  /// The table is valid as long as the Horizon is.
  [[nodiscard]] ResponseTable table() const noexcept;

 private:
  double control_time_;
  std::vector<double> gain_, rate_;
  ResponseAt end_, step_;
};

}  // namespace avo
