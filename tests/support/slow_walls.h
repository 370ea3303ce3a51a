// SPDX-License-Identifier: Apache-2.0
// Slow answers about a robot and a wall by dense sampling of times and normals, and situations for
// them. They share no formula with the library except the response written out.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <utility>
#include <vector>

#include "obstacles/wall_half_plane.h"
#include "support/brute_force.h"
#include "support/segment_distance.h"

namespace avo::test {

/// A robot beside a wall, and the parameters of its plan.
struct WallSituation {
  WallPair pair;
  double reach = 0.0;         // m/s
  double control_time = 0.0;  // s
  double time_horizon = 0.0;  // s
};

inline std::ostream& operator<<(std::ostream& out, const WallSituation& s) {
  out.precision(17);
  return out << "from a {" << s.pair.from_a.x << ", " << s.pair.from_a.y << "} from b {"
             << s.pair.from_b.x << ", " << s.pair.from_b.y << "} v {" << s.pair.velocity.x << ", "
             << s.pair.velocity.y << "} r " << s.pair.radius << " reach " << s.reach << " delta "
             << s.control_time << " tau " << s.time_horizon;
}

/// Returns the smallest distance of the robot from the wall over (0, τ].
inline double slow_distance(const WallSituation& s, Vec2 w, int samples = 4000) {
  const Vec2 b = s.pair.from_a - s.pair.from_b;
  const auto nearness = [&](double t) {
    const double g = static_cast<double>(slow_gain(t, s.control_time));
    return -slow_segment_distance(s.pair.from_a + t * s.pair.velocity + g * w, {}, b);
  };
  return -largest_over_time(nearness, s.time_horizon, samples);
}

/// Support function of D(0, reach) ∩ AVO of a wall about w = 0: the largest n . w over all times.
class SlowWallHull {
 public:
  explicit SlowWallHull(const WallSituation& s, int samples = 80) : s_(s) {
    const double first = 1e-5 * s.time_horizon;
    for (int k = 0; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      times_.push_back(s.time_horizon * std::max(part * part, 1e-5));
      times_.push_back(first * std::pow(s.time_horizon / first, part));
    }
    std::sort(times_.begin(), times_.end());
    for (const double t : times_) walls_.push_back(wall_at(t));
  }

  [[nodiscard]] bool empty() const {
    return std::all_of(walls_.begin(), walls_.end(), [](const WallAt& at) { return !at.in_reach; });
  }

  [[nodiscard]] double support(Vec2 n, bool refined = true) const {
    std::vector<double>& value = scratch_;
    value.clear();
    for (const WallAt& at : walls_) value.push_back(support_of(at, n));
    double best = *std::max_element(value.begin(), value.end());
    if (!refined) return best;
    for (std::size_t k = 0; k < value.size(); ++k) {
      const std::size_t left = k > 0 ? k - 1 : k, right = k + 1 < value.size() ? k + 1 : k;
      if (value[k] == -kInfinity || value[k] < value[left] || value[k] < value[right]) continue;
      const auto f = [&](double t) { return support_of(wall_at(t), n); };
      best = std::max(best, golden_section(f, times_[left], times_[right], 32));
    }
    return best;
  }

  /// Returns the unit normal of least support, and that support.
  [[nodiscard]] std::pair<Vec2, double> least() const {
    return least_support([this](Vec2 n, bool refined) { return support(n, refined); }, 120, 3, 32);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // All w that collide at one time: they are within `radius` of the segment between two centers.
  struct WallAt {
    Vec2 a, b;
    double radius;
    bool in_reach;
  };

  [[nodiscard]] WallAt wall_at(double t) const {
    const double g = static_cast<double>(slow_gain(t, s_.control_time));
    const Vec2 a = (-1.0 / g) * (s_.pair.from_a + t * s_.pair.velocity);
    const Vec2 b = (-1.0 / g) * (s_.pair.from_b + t * s_.pair.velocity);
    const double radius = s_.pair.radius / g;
    return {a, b, radius, slow_segment_distance({}, a, b) < radius + s_.reach};
  }

  [[nodiscard]] double support_of(const WallAt& at, Vec2 n) const {
    if (!at.in_reach) return -kInfinity;
    const double R = s_.reach;
    double best = -kInfinity;
    const auto try_point = [&](Vec2 w) {
      if (norm(w) <= R * (1.0 + 1e-12) &&
          slow_segment_distance(w, at.a, at.b) <= at.radius * (1.0 + 1e-9))
        best = std::max(best, dot(n, w));
    };
    try_point(at.a + at.radius * n);
    try_point(at.b + at.radius * n);
    try_point(R * n);
    if (best >= R) return best;
    // where the circle |w| = R cuts the edge
    for (const Vec2 center : {at.a, at.b}) {
      const double c = norm(center);
      const double along = (c * c + R * R - at.radius * at.radius) / (2.0 * c);
      if (!(std::abs(along) <= R)) continue;
      const double across = std::sqrt(R * R - along * along);
      for (const double sign : {1.0, -1.0})
        try_point((along / c) * center + (sign * across / c) * perpendicular(center));
    }
    const Vec2 d = (1.0 / norm(at.b - at.a)) * (at.b - at.a);
    for (const double side : {at.radius, -at.radius}) {
      const double miss = cross(d, at.a) + side;
      if (!(std::abs(miss) <= R)) continue;
      const double half = std::sqrt(R * R - miss * miss);
      for (const double sign : {half, -half}) try_point(sign * d + miss * perpendicular(d));
    }
    return best;
  }

  WallSituation s_;
  std::vector<double> times_;
  std::vector<WallAt> walls_;
  mutable std::vector<double> scratch_;
};

/// Returns a robot apart from the wall, over wide ranges of all numbers.
inline WallSituation any_wall_situation(Random& random) {
  WallSituation s;
  s.control_time = random.log_uniform(0.05, 10.0);
  s.time_horizon = random.log_uniform(0.2, 20.0);
  s.reach = random.below(2) == 0 ? s.control_time * random.uniform(0.3, 6.0)
                                 : random.log_uniform(0.05, 40.0);
  s.pair.radius = random.log_uniform(0.03, 3.0);
  const double length = random.below(3) == 0 ? s.pair.radius * random.log_uniform(1e-3, 2.0)
                                             : random.log_uniform(0.3, 50.0);
  // a point of the wall, and the robot away from it in some direction
  const Vec2 along = random.direction();
  const double gap = random.below(2) == 0 ? s.pair.radius * random.log_uniform(1e-3, 30.0)
                                          : random.uniform(0.0, 14.0);
  const double part = random.below(3) == 0 ? 0.0 : random.uniform(0.0, 1.0);
  const Vec2 out = part == 0.0 ? random.direction() : perpendicular(along);
  const Vec2 from_place = (s.pair.radius + gap) * out;
  s.pair.from_a = from_place + (part * length) * along;
  s.pair.from_b = from_place - ((1.0 - part) * length) * along;
  s.pair.velocity = in_disc(random, 5.0);
  if (random.below(2) == 0) std::swap(s.pair.from_a, s.pair.from_b);
  return s;
}

inline bool is_apart(const WallSituation& s, double margin = 0.0) {
  const double d = slow_segment_distance(s.pair.from_a, {}, s.pair.from_a - s.pair.from_b);
  return d >= s.pair.radius * (1.0 + margin);
}

/// Returns a situation next to a special case, or exactly in it.
inline WallSituation degenerate_wall_situation(Random& random) {
  for (;;) {
    WallSituation s = any_wall_situation(random);
    WallPair& pair = s.pair;
    const Vec2 along = pair.from_a - pair.from_b;
    const double length = norm(along), speed = norm(pair.velocity);
    const Vec2 e = along / length, n = perpendicular(e);
    const double near = random.near_zero();
    switch (random.below(8)) {
      case 0:
        pair.velocity = {};
        break;
      case 1:  // along the wall
        pair.velocity = speed * (e + near * n);
        break;
      case 2:  // straight at it, in front of its middle
        pair.from_a = (pair.radius + random.uniform(0.1, 5.0)) * n + (0.5 * length) * e;
        pair.from_b = pair.from_a - along;
        pair.velocity = speed * (near * e - n);
        break;
      case 3:  // on the extension of its line
        pair.from_b = (pair.radius + random.uniform(0.1, 5.0)) * e + (near * pair.radius) * n;
        pair.from_a = pair.from_b + along;
        break;
      case 4: {  // in contact beside it, with any velocity
        const double beside = pair.radius * (1.0 + std::abs(near));
        pair.from_a = beside * n + (random.uniform(0.0, 1.0) * length) * e;
        pair.from_b = pair.from_a - along;
        if (random.below(2) == 0) pair.velocity = speed * (e + random.near_zero() * n);
        break;
      }
      case 5: {  // straight at an end, or past the end at a miss distance of r
        const Vec2 to_end = -pair.from_a;
        const double d = norm(to_end);
        const double sine =
            std::min(1.0, random.below(2) == 0 ? std::abs(near) : pair.radius / d * (1.0 + near));
        pair.velocity =
            (speed / d) * (std::sqrt(1.0 - sine * sine) * to_end + sine * perpendicular(to_end));
        break;
      }
      case 6:  // away from an end
        pair.velocity =
            (speed / norm(pair.from_a)) * (pair.from_a + near * perpendicular(pair.from_a));
        break;
      default:
        s.reach = random.below(2) == 0 ? 1e-3 : 1e3;
        break;
    }
    if (is_apart(s)) return s;
  }
}

}  // namespace avo::test
