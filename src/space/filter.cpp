// SPDX-License-Identifier: Apache-2.0
// Two equal poles of T/2 behind a reference. With a the acceleration, and a_1, a_2 what one pole
// and both make of it, the filtered position is p - T v + T²/4 (2 a_1 + a_2), and its velocity
// v - T/2 (a_1 + a_2). So the two lags are all that the filter remembers, and nothing adds up.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "avo/error.h"
#include "avo/space/quadrotor.h"
#include "core/elementary.h"
#include "core/ranges.h"

namespace avo::space {
namespace {

constexpr double kMostStepsWaited = 1e6;
constexpr double kOfStep = 1e-6;  // because times are sums of rounded steps

double decay(double lags) {
  return 1.0 + elementary::expm1(-lags);
}

// What the lags are after a time, in units of a pole, of constant acceleration.
struct Lags {
  Vec3 once, twice;
};
Lags lags_after(double time, double left, Vec3 acceleration, const Lags& start) {
  const Vec3 off_once = start.once - acceleration, off_twice = start.twice - acceleration;
  return {acceleration + left * off_once, acceleration + left * (off_twice + time * off_once)};
}

}  // namespace

Filter::Filter(const QuadrotorLimits& limits, double fleet_delay, double time_step)
    : delay_(limits.delay), wait_(fleet_delay - limits.delay), time_step_(time_step) {
  require("delay", delay_, kPositive, "s");
  require("time_step", time_step_, kPositive, "s");
  if (!(wait_ >= 0.0 && wait_ <= kMostStepsWaited * time_step_))
    refuse("fleet_delay", text(fleet_delay),
           text(delay_) + " s, the quadrotor's own delay, to a million steps more");
  decay_ = decay(2.0 * time_step_ / delay_);
  steps_.resize(static_cast<std::size_t>(std::ceil(wait_ / time_step_)) + 2);
}

const Filter::Step& Filter::step(std::int64_t k) const {
  return steps_[static_cast<std::size_t>(k) % steps_.size()];
}

void Filter::add(Vec3 position, Vec3 velocity, Vec3 acceleration) {
  require("position", position, "m");
  require("velocity", velocity, "m/s");
  require("acceleration", acceleration, "m/s^2");
  Step next{position, velocity, acceleration, {}, {}};
  if (count_ > 0) {
    const Step& last = step(count_ - 1);
    const Lags lags =
        lags_after(2.0 * time_step_ / delay_, decay_, last.acceleration, {last.once, last.twice});
    next.once = lags.once, next.twice = lags.twice;
  }
  steps_[static_cast<std::size_t>(count_) % steps_.size()] = next;
  ++count_;
}

double Filter::begin() const {
  return static_cast<double>(std::max<std::int64_t>(count_ - 1, 0)) * time_step_;
}
double Filter::end() const {
  return static_cast<double>(count_) * time_step_ + wait_;
}

SetPoint Filter::at(double time) const {
  const double slack = kOfStep * time_step_;
  if (count_ == 0 || !(time >= begin() - slack && time <= end() + slack))
    refuse("time", text(time), text(begin()) + " to " + text(end()) + " s");
  const double since = time - wait_;  // s, of the reference
  const auto index = static_cast<std::int64_t>(std::floor(since / time_step_));
  const std::int64_t k = std::min(std::max<std::int64_t>(index, 0), count_ - 1);
  const Step& start = step(k);
  const double h = since - static_cast<double>(k) * time_step_;
  if (since < 0.0)  // the reference had no acceleration yet
    return {start.position + (since - delay_) * start.velocity, start.velocity, {}};
  const Vec3 a = start.acceleration;
  const double time_in_poles = 2.0 * h / delay_;
  const Lags lags = lags_after(time_in_poles, decay(time_in_poles), a, {start.once, start.twice});
  const Vec3 velocity = start.velocity + h * a;
  const Vec3 position = start.position + h * start.velocity + (0.5 * h * h) * a;
  return {position - delay_ * velocity + (0.25 * delay_ * delay_) * (2.0 * lags.once + lags.twice),
          velocity - (0.5 * delay_) * (lags.once + lags.twice),
          {a.x, a.y, lags.twice.z}};
}

}  // namespace avo::space
