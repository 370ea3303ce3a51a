// SPDX-License-Identifier: Apache-2.0
// Eqs. (7)-(9): g, g' and the lag of every response, without cancellation at small t/δ.
#include "avo/response.h"

#include "core/elementary.h"

namespace avo {
namespace {

// u + e^{-u} - 1 for u >= 0. Below 1/2 the subtraction would lose up to all digits: the series
// u²/2 - u³/6 + ... is summed instead, to 2^-54 relative at u = 1/2 with 14 terms.
double proportional_gain(double u) {
  if (u > 0.5) return u + elementary::expm1(-u);
  double sum = 0.0;
  for (int k = 16; k >= 3; --k) sum = -(u / k) * (1.0 + sum);
  return 0.5 * u * u * (1.0 + sum);
}

}  // namespace

double Response::gain(double t) const {
  if (kind_ == Kind::velocity) return t;
  const double u = t / control_time_;
  return kind_ == Kind::proportional ? control_time_ * proportional_gain(u) : 0.5 * t * u;
}

double Response::rate(double t) const {
  if (kind_ == Kind::velocity) return 1.0;
  const double u = t / control_time_;
  return kind_ == Kind::proportional ? -elementary::expm1(-u) : u;
}

double Response::lag(double t) const {
  if (kind_ == Kind::velocity) return 0.0;
  if (kind_ != Kind::proportional) return 0.5 * t;
  return t > 0.0 ? t - gain(t) / rate(t) : 0.0;
}

}  // namespace avo
