// SPDX-License-Identifier: Apache-2.0
// With q' = s h + L ω n and q'' = a, held,
//   s' = h·a + L ω²,  ω' = (n·a - s ω)/L,  h' = ω n,  n' = -ω h,
// and wheels b apart have the speeds s ± b ω/2.
#include "check/towed_axle.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace avo::judge {
namespace {

Vec2 left_of(Vec2 h) {
  return {-h.y, h.x};
}

Vec2 velocity_at(const TowedAxle& axle, double time) {
  return axle.velocity + time * axle.acceleration;
}

// As complex numbers.
Vec2 times(Vec2 a, Vec2 b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

Vec2 conjugate(Vec2 a) {
  return {a.x, -a.y};
}

// As a complex number h follows Riccati's equation h' = (z - h² z*)/(2L), z = q'. h = u/w with u' =
// z w/(2L), w' = z* u/(2L), a linear equation; its power series is that of an entire function.
Vec2 turned(const TowedAxle& axle, Vec2 h, double time, double step) {
  constexpr int kTerms = 14;
  const double scale = 0.5 * step / axle.offset;
  const Vec2 z = scale * velocity_at(axle, time), z_gain = (scale * step) * axle.acceleration;
  Vec2 u = h, w{1.0, 0.0}, u_before, w_before, u_sum = u, w_sum = w;
  for (int k = 1; k <= kTerms; ++k) {
    const Vec2 next_u = (times(z, w) + times(z_gain, w_before)) / k;
    const Vec2 next_w = (times(conjugate(z), u) + times(conjugate(z_gain), u_before)) / k;
    u_before = u, w_before = w, u = next_u, w = next_w;
    u_sum = u_sum + u, w_sum = w_sum + w;
  }
  const Vec2 next = times(u_sum, conjugate(w_sum));
  return next / norm(next);
}

double time_of(const TowedAxle& axle, std::size_t part) {
  return axle.duration * static_cast<double>(part) / static_cast<double>(TowedAxle::kParts);
}

// The wheel on the left, or for a negative track the wheel on the right.
struct Wheel {
  double speed, acceleration;  // m/s, m/s^2, signed
};

// `beyond` parts from the end of a part.
Wheel wheel_at(const TowedAxle& axle, std::size_t part, double beyond, double track) {
  const double past = beyond * axle.duration / static_cast<double>(TowedAxle::kParts);
  const double time = time_of(axle, part);
  const Vec2 h = beyond == 0.0 ? axle.heading[part] : turned(axle, axle.heading[part], time, past);
  const Vec2 n = left_of(h), velocity = velocity_at(axle, time + past);
  const double speed = dot(h, velocity), rate = dot(n, velocity) / axle.offset;
  const double gain = dot(h, axle.acceleration) + axle.offset * rate * rate;
  const double spin = (dot(n, axle.acceleration) - speed * rate) / axle.offset;
  return {speed - 0.5 * track * rate, gain - 0.5 * track * spin};
}

// The largest |value(part, beyond)|: at the ends of parts, and at the vertices of parabolas through
// three ends.
template <typename Value>
double peak(const Value& value) {
  double left = value(0, 0.0), middle = value(1, 0.0);
  double most = std::max(std::abs(left), std::abs(middle));
  for (std::size_t k = 2; k <= TowedAxle::kParts; ++k) {
    const double right = value(k, 0.0), bend = 2.0 * middle - left - right, slope = right - left;
    most = std::max(most, std::abs(right));
    if (std::abs(slope) < 2.0 * std::abs(bend))
      most = std::max(most, std::abs(value(k - 1, 0.5 * slope / bend)));
    left = middle, middle = right;
  }
  return most;
}

}  // namespace

TowedAxle towed_axle(const CheckedState& before, const CheckedState& now, double offset,
                     double duration) {
  const Vec2 h = elementary::direction(before.heading->angle);
  TowedAxle axle{before.position + offset * h,
                 before.velocity,
                 (now.velocity - before.velocity) / duration,
                 offset,
                 duration,
                 {}};
  const double step = duration / static_cast<double>(TowedAxle::kParts);
  axle.heading[0] = h;
  for (std::size_t k = 0; k < TowedAxle::kParts; ++k)
    axle.heading[k + 1] = turned(axle, axle.heading[k], time_of(axle, k), step);
  return axle;
}

CourseKnot knot_on(const TowedAxle& axle, double ahead, std::size_t part) {
  const double time = time_of(axle, part);
  const Vec2 h = axle.heading[part], velocity = velocity_at(axle, time);
  const Vec2 point = axle.from + time * (axle.velocity + (0.5 * time) * axle.acceleration);
  const CourseKnot knot{point - axle.offset * h, dot(h, velocity) * h};
  if (ahead == 0.0) return knot;
  const Vec2 n = left_of(h);
  return {knot.position + ahead * h, knot.velocity + (ahead * dot(n, velocity) / axle.offset) * n};
}

// Each derivative is replaced by its bound: s', s'', s''' and ω, ω', ω''. The length of h'''' is at
// most |ω'''| + 4 |ω| |ω''| + 3 ω'² + 6 ω² |ω'| + ω⁴, where ω''' is that of (n·a - s ω)/L.
double fourth_derivative(const TowedAxle& axle, double ahead) {
  const double length = axle.offset, a = norm(axle.acceleration);
  const double v = std::max(norm(axle.velocity), norm(velocity_at(axle, axle.duration)));
  const double w = v / length, w1 = (a + v * w) / length, s1 = a + length * w * w;
  const double w2 = (w * a + s1 * w + v * w1) / length, s2 = w * a + 2.0 * length * w * w1;
  const double s3 = (w1 + w * w) * a + 2.0 * length * (w1 * w1 + w * w2);
  const double of_axle =
      s3 + 3.0 * s2 * w + 3.0 * s1 * (w1 + w * w) + v * (w2 + 3.0 * w * w1 + w * w * w);
  const double w3 = ((w1 + w * w) * a + s2 * w + 2.0 * s1 * w1 + v * w2) / length;
  const double of_heading = w3 + 4.0 * w * w2 + 3.0 * w1 * w1 + 6.0 * w * w * w1 + w * w * w * w;
  return of_axle + std::abs(ahead) * of_heading;
}

WheelPeaks wheel_peaks(const TowedAxle& axle, double track) {
  WheelPeaks peaks;
  for (const double side : {track, -track}) {
    const auto speed = [&](std::size_t part, double beyond) {
      return wheel_at(axle, part, beyond, side).speed;
    };
    const auto pull = [&](std::size_t part, double beyond) {
      return wheel_at(axle, part, beyond, side).acceleration;
    };
    peaks = {std::max(peaks.speed, peak(speed)), std::max(peaks.acceleration, peak(pull))};
  }
  return peaks;
}

}  // namespace avo::judge
