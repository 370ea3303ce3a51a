// SPDX-License-Identifier: Apache-2.0
// Slow answers by dense sampling and refinement of the definitions. They share no formula with the
// library except the response written out, in long double.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/generators.h"

namespace avo::test {

/// Returns t + δ (e^{-t/δ} - 1) in long double; it uses the series where the subtraction would
/// cancel.
inline long double slow_gain(long double t, long double delta) {
  const long double u = t / delta;
  if (u > 0.7L) return delta * (u + std::expm1(-u));
  long double sum = 0.0L, term = u;
  for (int k = 2; k < 30; ++k) {
    term *= -u / static_cast<long double>(k);
    sum -= term;
  }
  return delta * sum;
}

/// Returns the largest value of f on [low, high], where f is unimodal.
template <typename F>
double golden_section(F&& f, double low, double high, int steps) {
  constexpr double kPart = 0.6180339887498949;
  double a = high - kPart * (high - low), b = low + kPart * (high - low);
  double f_a = f(a), f_b = f(b), best = std::max(f_a, f_b);
  for (int k = 0; k < steps; ++k) {
    if (f_a > f_b) {
      high = b, b = a, f_b = f_a;
      a = high - kPart * (high - low);
      f_a = f(a);
    } else {
      low = a, a = b, f_a = f_b;
      b = low + kPart * (high - low);
      f_b = f(b);
    }
    best = std::max({best, f_a, f_b});
  }
  return best;
}

/// Returns the largest value over [0, end], with refined values between so many samples, which lie
/// closer together where the time is small.
template <typename F>
double largest_over_time(const F& f, double end, int samples) {
  std::vector<double> time, value;
  for (int k = 0; k <= samples; ++k) {
    const double part = static_cast<double>(k) / samples;
    time.push_back(end * part * part);
    value.push_back(f(time.back()));
  }
  double best = std::max(value.front(), value.back());
  for (std::size_t k = 1; k + 1 < time.size(); ++k) {
    if (value[k] >= value[k - 1] && value[k] >= value[k + 1])
      best = std::max(best, golden_section(f, time[k - 1], time[k + 1], 60));
  }
  return best;
}

/// Returns the smallest distance of the centers over (0, τ], with an error of at most about 1e-9 of
/// the distance.
inline double slow_distance(const Situation& s, Vec2 w, int samples = 2000) {
  const auto nearness = [&](double t) {
    const double g = static_cast<double>(slow_gain(t, s.control_time));
    return -norm(s.pair.position + t * s.pair.velocity + g * w);
  };
  return -largest_over_time(nearness, s.time_horizon, samples);
}

/// Returns the unit normal of least support, and that support. It evaluates support(normal,
/// refined) in so many directions and then, refined, around the lowest `tries` of its minima.
template <typename Support>
std::pair<Vec2, double> least_support(const Support& support, int directions, int tries,
                                      int steps) {
  const double step = 2.0 * std::numbers::pi / directions;
  const auto direction = [](double angle) { return Vec2{std::cos(angle), std::sin(angle)}; };
  std::vector<double> value;
  for (int k = 0; k < directions; ++k) value.push_back(support(direction(k * step), false));
  const auto value_at = [&](int k) { return value[static_cast<std::size_t>(k % directions)]; };
  std::vector<std::pair<double, int>> minima;
  for (int k = 0; k < directions; ++k) {
    const double here = value_at(k);
    if (here <= value_at(k + 1) && here <= value_at(k + directions - 1))
      minima.emplace_back(here, k);
  }
  std::sort(minima.begin(), minima.end());
  double best = std::numeric_limits<double>::infinity(), best_angle = 0.0;
  for (std::size_t k = 0; k < std::min(static_cast<std::size_t>(tries), minima.size()); ++k) {
    const double angle = minima[k].second * step;
    const auto f = [&](double x) {
      const double h = support(direction(x), true);
      if (h < best) best = h, best_angle = x;
      return -h;
    };
    golden_section(f, angle - step, angle + step, steps);
  }
  return {direction(best_angle), best};
}

/// Support function of D(0, reach) ∩ AVO about w = 0: the largest n . w over all times of the
/// discs' parts within reach, sampled in time and refined between the samples.
class SlowHull {
 public:
  explicit SlowHull(const Situation& s, int samples = 160) : s_(s) {
    // no disc is within reach before |p| - r = |v| t + R g(t)
    double low = 0.0, high = s.time_horizon;
    for (int k = 0; k < 60; ++k) {
      const double t = 0.5 * (low + high);
      const bool early =
          norm(s.pair.position) - s.pair.radius > t * norm(s.pair.velocity) + s.reach * gain(t);
      (early ? low : high) = t;
    }
    std::vector<double> times;
    const double first = std::max(low, 1e-9 * s.time_horizon);
    for (int k = 0; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      times.push_back(low + (s.time_horizon - low) * part * part);
      times.push_back(1.0 / (1.0 / first + (1.0 / s.time_horizon - 1.0 / first) * part));
      times.push_back(first * std::pow(s.time_horizon / first, part));
    }
    times.push_back(s.time_horizon);
    std::sort(times.begin(), times.end());
    for (const double t : times) {
      if (t > 0.0 && t <= s.time_horizon && (lenses_.empty() || t > lenses_.back().t)) {
        lenses_.push_back(lens(t));
      }
    }
    crowd_the_crossings();
    for (const Lens& at : lenses_) empty_ = empty_ && at.misses;
  }

  /// Returns whether no velocity within reach collides, as far as the samples tell.
  [[nodiscard]] bool empty() const { return empty_; }

  [[nodiscard]] double support(Vec2 n, bool refined = true) const {
    std::vector<double>& value = scratch_;
    value.clear();
    for (const Lens& at : lenses_) value.push_back(support_of(at, n));
    double best = *std::max_element(value.begin(), value.end());
    if (!refined || best >= s_.reach) return best;
    for (std::size_t k = 0; k < value.size(); ++k) {
      const double left = k > 0 ? value[k - 1] : -kInfinity;
      const double right = k + 1 < value.size() ? value[k + 1] : -kInfinity;
      if (value[k] == -kInfinity || value[k] < left || value[k] < right) continue;
      const double low = lenses_[k > 0 ? k - 1 : k].t;
      const double high = lenses_[k + 1 < value.size() ? k + 1 : k].t;
      const auto f = [&](double t) { return support_of(lens(t), n); };
      best = std::max(best, golden_section(f, low, high, 36));
    }
    return best;
  }

  /// Returns the unit normal of least support, and that support.
  [[nodiscard]] std::pair<Vec2, double> least() const {
    return least_support([this](Vec2 n, bool refined) { return support(n, refined); }, 96, 2, 36);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  struct Lens {
    double t;
    Vec2 center;
    double radius;
    bool misses, covers, inside;  // the disc of reach: misses it, covers it, lies inside it
    Vec2 corner[2];
  };

  [[nodiscard]] double gain(double t) const {
    return static_cast<double>(slow_gain(t, s_.control_time));
  }

  // Adds samples: a small disc crosses the circle of reach in a short time, in which its corners
  // are the support. Where one sample misses the reach and the next does not, that time is found
  // and sampled.
  void crowd_the_crossings() {
    std::vector<Lens> all;
    for (std::size_t k = 0; k + 1 < lenses_.size(); ++k) {
      const Lens &a = lenses_[k], &b = lenses_[k + 1];
      all.push_back(a);
      if (a.misses == b.misses && a.inside == b.inside) continue;
      const double touch =
          a.misses == b.misses ? a.t : change(a.t, b.t, [](const Lens& at) { return at.misses; });
      const double enter = a.misses ? touch : a.t, leave = b.misses ? touch : b.t;
      const double within = a.inside == b.inside
                                ? (a.misses ? leave : enter)
                                : change(enter, leave, [](const Lens& at) { return at.inside; });
      for (const auto& [low, high] : {std::pair{enter, within}, std::pair{within, leave}}) {
        for (int i = 0; i <= 16; ++i) {
          const double t = low + (high - low) * i / 16;
          if (t > all.back().t && t < b.t) all.push_back(lens(t));
        }
      }
    }
    all.push_back(lenses_.back());
    lenses_ = all;
  }

  template <typename Is>
  [[nodiscard]] double change(double low, double high, Is&& is) const {
    const bool at_low = is(lens(low));
    for (int k = 0; k < 60; ++k) {
      const double t = 0.5 * (low + high);
      (is(lens(t)) == at_low ? low : high) = t;
    }
    return 0.5 * (low + high);
  }

  [[nodiscard]] Lens lens(double t) const {
    const double g = gain(t), R = s_.reach;
    Lens at{};
    at.t = t;
    at.center = -1.0 / g * (s_.pair.position + t * s_.pair.velocity);
    at.radius = s_.pair.radius / g;
    const double d = norm(at.center);
    at.misses = d >= at.radius + R;
    at.covers = d <= at.radius - R;
    at.inside = d <= R - at.radius;
    if (at.misses || at.covers || at.inside) return at;
    const double along = ((R - at.radius) * (R + at.radius) + d * d) / (2.0 * d);
    const double across = std::sqrt(std::max(0.0, (R - along) * (R + along)));
    const Vec2 u = at.center / d;
    at.corner[0] = along * u + across * perpendicular(u);
    at.corner[1] = along * u - across * perpendicular(u);
    return at;
  }

  [[nodiscard]] double support_of(const Lens& at, Vec2 n) const {
    if (at.misses) return -kInfinity;
    // square roots would take most of the time
    const double reach = s_.reach, r = at.radius;
    if (at.covers || norm_squared(reach * n - at.center) <= r * r) return reach;
    if (at.inside || norm_squared(at.center + r * n) <= reach * reach) {
      return dot(n, at.center) + r;
    }
    return std::max(dot(n, at.corner[0]), dot(n, at.corner[1]));
  }

  Situation s_;
  std::vector<Lens> lenses_;
  bool empty_ = true;
  mutable std::vector<double> scratch_;
};

}  // namespace avo::test
