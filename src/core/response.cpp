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
  switch (kind_) {
    case Kind::velocity:
      return t;
    case Kind::acceleration:
      return 0.5 * t * t;
    case Kind::held:
      return 0.5 * t * (t / control_time_);
    case Kind::proportional:
      break;
  }
  return control_time_ * proportional_gain(t / control_time_);
}

double Response::rate(double t) const {
  switch (kind_) {
    case Kind::velocity:
      return 1.0;
    case Kind::acceleration:
      return t;
    case Kind::held:
      return t / control_time_;
    case Kind::proportional:
      break;
  }
  return -elementary::expm1(-t / control_time_);
}

double Response::lag(double t) const {
  switch (kind_) {
    case Kind::velocity:
      return 0.0;
    case Kind::acceleration:
    case Kind::held:
      return 0.5 * t;
    case Kind::proportional:
      break;
  }
  return t > 0.0 ? t - gain(t) / rate(t) : 0.0;
}

}  // namespace avo
