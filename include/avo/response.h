// SPDX-License-Identifier: Apache-2.0
// How a new velocity v' = v + w is approached: x(t) = p + t v + g(t) w (paper Eqs. 7-9).
#pragma once
#include "avo/export.h"

namespace avo {

/// The response g of a robot to a change of its commanded velocity (or acceleration). Any response
/// needs g(0) = 0, g' > 0 for t > 0, g convex. It is evaluated to a few ulp at every t, without the
/// cancellation of t + δ (e^{-t/δ} - 1) at small t/δ.
class AVO_API Response {
 public:
  /// g = t: v' is adopted at once (velocity obstacle, ORCA).
  static Response velocity() { return Response(Kind::velocity, 0.0); }
  /// g = t^2 / 2: w is an acceleration that is held (acceleration obstacle).
  static Response acceleration() { return Response(Kind::acceleration, 1.0); }
  /// g = t + δ (e^{-t/δ} - 1): proportional control with δ = control_time > 0 (s), Eqs. (7)-(9).
  static Response proportional(double control_time) {
    return Response(Kind::proportional, control_time);
  }
  /// g = t^2 / (2 δ): the acceleration w / δ is held (§III-C's cycle, within one time step).
  static Response held(double control_time) { return Response(Kind::held, control_time); }

  /// [g] s, or s^2 for the acceleration obstacle.
  double gain(double t) const;
  /// [g'] how much of w has become velocity at t.
  double rate(double t) const;
  /// [s = t - g/g'] s: the tangents of the disc of time t are those seen from p + s v.
  double lag(double t) const;
  /// True where w is an acceleration, false where it is a change of velocity.
  bool is_acceleration() const { return kind_ == Kind::acceleration; }
  /// [δ] s; 0 where there is none.
  double control_time() const { return is_acceleration() ? 0.0 : control_time_; }

 private:
  enum class Kind { velocity, acceleration, proportional, held };
  Response(Kind kind, double control_time) : kind_(kind), control_time_(control_time) {}
  Kind kind_;
  double control_time_;  // s; 1 for an acceleration, which is held as (v' - v)/δ is
};

}  // namespace avo
