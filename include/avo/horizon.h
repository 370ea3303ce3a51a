// SPDX-License-Identifier: Apache-2.0
// g, g' and the lag of proportional control, tabulated once per (δ, τ): no exponential per pair.
#pragma once
#include <vector>

namespace avo {

/// One instant of the response, see Response.
struct ResponseAt {
  double time = 0.0;  ///< [t] s
  double gain = 0.0;  ///< [g(t) = t + δ (e^{-t/δ} - 1)] s
  double rate = 0.0;  ///< [g'(t) = 1 - e^{-t/δ}]
  double lag = 0.0;   ///< [s(t) = t - g/g'] s
};

/// Immutable; safe to share between threads.
class Horizon {
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

 private:
  struct Node {
    double time, gain, rate, decay;  // t_k, g(t_k), g'(t_k), e^{-t_k/δ}
  };
  double control_time_;
  double nodes_per_second_;
  std::vector<Node> nodes_;
  ResponseAt end_, step_;
};

}  // namespace avo
