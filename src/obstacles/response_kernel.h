// SPDX-License-Identifier: Apache-2.0
// Eq. (9)'s gain from a table: between nodes the response continues as
// g(t_k + h) = g(t_k) + h g'(t_k) + e^{-t_k/δ} g(h), a sum without cancellation.
#ifndef AVO_OBSTACLES_RESPONSE_KERNEL_H
#define AVO_OBSTACLES_RESPONSE_KERNEL_H

#include "avo/horizon.h"
#include "core/scalar.h"
#include "obstacles/constants.h"

AVO_BEGIN_KERNELS

/// 1/a for a >= 0; finite for a = 0: this value is not used, but lanes compute it.
template <typename Real>
AVO_KERNEL Real inverse(Real a) {
  return Real(1.0) / max(a, Real(kTiniest));
}

/// One instant of the response, see Response.
template <typename Real>
struct At {
  Real time, gain, rate, per_rate, lag;
};

/// 2 (u + e^{-u} - 1)/u² for 0 <= u <= 1/32: up to u^7, 2^-58 of it.
template <typename Real>
AVO_KERNEL Real response_series(Real u) {
  const Real u2 = u * u;
  const Real low =
      (Real(1.0) - u * Real(1.0 / 3.0)) + u2 * (Real(1.0 / 12.0) - u * Real(1.0 / 60.0));
  const Real high = (Real(1.0 / 360.0) - u * Real(1.0 / 2520.0)) +
                    u2 * (Real(1.0 / 20160.0) - u * Real(1.0 / 181440.0));
  return low + u2 * u2 * high;
}

/// For t >= 0. Past the table, at 40 δ, g grows like the time itself.
template <typename Real>
AVO_KERNEL At<Real> at(const ResponseTable& table, Real t) {
  const Real k = floor(min(t * Real(table.nodes_per_second), Real(table.last)));
  const Real h = max(t - k * Real(table.seconds_per_node), Real(0.0));
  const Real node_rate = lookup(table.rate, k), decay = Real(1.0) - node_rate;
  // at most 1/32 plus rounding
  const Real u = min(h * Real(table.per_control_time), Real(1.0 / 16.0));
  const Real sum = response_series(u);
  const Real extra = Real(0.5) * u * u * sum;
  At<Real> result;
  result.time = t;
  result.rate = node_rate + decay * (u - extra);
  result.gain = lookup(table.gain, k) + (h * node_rate + decay * Real(table.control_time) * extra);
  result.per_rate = inverse(result.rate);
  result.lag = select(result.rate > Real(0.0), t - result.gain * result.per_rate, Real(0.0));
  return result;
}

template <typename Real>
AVO_KERNEL At<Real> constant(const ResponseAt& instant) {
  At<Real> result;
  result.time = Real(instant.time);
  result.gain = Real(instant.gain);
  result.rate = Real(instant.rate);
  result.per_rate = Real(instant.per_rate);
  result.lag = Real(instant.lag);
  return result;
}

AVO_END_KERNELS

#endif  // once per pass
