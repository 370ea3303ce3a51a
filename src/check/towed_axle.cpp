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

// h' of a heading.
Vec2 turning(const TowedAxle& axle, Vec2 h, double time) {
  const Vec2 n = left_of(h);
  return (dot(n, velocity_at(axle, time)) / axle.offset) * n;
}

// The classical method of Runge and Kutta.
Vec2 turned(const TowedAxle& axle, Vec2 h, double time, double step) {
  const double half = 0.5 * step;
  const Vec2 k1 = turning(axle, h, time);
  const Vec2 k2 = turning(axle, h + half * k1, time + half);
  const Vec2 k3 = turning(axle, h + half * k2, time + half);
  const Vec2 k4 = turning(axle, h + step * k3, time + step);
  const Vec2 next = h + (step / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);
  return next / norm(next);
}

double time_of(const TowedAxle& axle, std::size_t part) {
  return axle.duration * static_cast<double>(part) / static_cast<double>(TowedAxle::kParts);
}

struct Wheels {
  double speed, acceleration;  // m/s, m/s^2, the larger one of both
};

Wheels wheels_at(const TowedAxle& axle, std::size_t part, double track) {
  const Vec2 h = axle.heading[part], n = left_of(h);
  const Vec2 velocity = velocity_at(axle, time_of(axle, part));
  const double speed = dot(h, velocity), rate = dot(n, velocity) / axle.offset;
  const double gain = dot(h, axle.acceleration) + axle.offset * rate * rate;
  const double spin = (dot(n, axle.acceleration) - speed * rate) / axle.offset;
  return {std::abs(speed) + 0.5 * track * std::abs(rate),
          std::abs(gain) + 0.5 * track * std::abs(spin)};
}

// Of the parabola through three values at equal distances, where the middle one is the largest.
double peak(double left, double middle, double right) {
  const double bend = 2.0 * middle - left - right, slope = right - left;
  return bend > 0.0 ? middle + slope * slope / (8.0 * bend) : middle;
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

Knot knot_on(const TowedAxle& axle, std::size_t part) {
  const double time = time_of(axle, part);
  const Vec2 h = axle.heading[part], velocity = velocity_at(axle, time);
  const Vec2 point = axle.from + time * (axle.velocity + (0.5 * time) * axle.acceleration);
  return {point - axle.offset * h, dot(h, velocity) * h};
}

// Each derivative by its bound: s', s'', s''' and ω, ω', ω''.
double fourth_derivative(const TowedAxle& axle) {
  const double length = axle.offset, a = norm(axle.acceleration);
  const double v = std::max(norm(axle.velocity), norm(velocity_at(axle, axle.duration)));
  const double w = v / length, w1 = (a + v * w) / length, s1 = a + length * w * w;
  const double w2 = (w * a + s1 * w + v * w1) / length, s2 = w * a + 2.0 * length * w * w1;
  const double s3 = (w1 + w * w) * a + 2.0 * length * (w1 * w1 + w * w2);
  return s3 + 3.0 * s2 * w + 3.0 * s1 * (w1 + w * w) + v * (w2 + 3.0 * w * w1 + w * w * w);
}

WheelPeaks wheel_peaks(const TowedAxle& axle, double track) {
  constexpr std::size_t kEnd = TowedAxle::kParts;
  std::array<Wheels, kEnd + 1> wheels;
  for (std::size_t k = 0; k <= kEnd; ++k) wheels[k] = wheels_at(axle, k, track);
  const auto largest = [&wheels](double Wheels::*value) {
    double most = std::max(wheels[0].*value, wheels[kEnd].*value);
    for (std::size_t k = 1; k < kEnd; ++k) {
      const double left = wheels[k - 1].*value, middle = wheels[k].*value,
                   right = wheels[k + 1].*value;
      if (middle >= left && middle >= right) most = std::max(most, peak(left, middle, right));
    }
    return most;
  };
  return {largest(&Wheels::speed), largest(&Wheels::acceleration)};
}

}  // namespace avo::judge
