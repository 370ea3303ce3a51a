// SPDX-License-Identifier: Apache-2.0
// An independent judge of the program's results: all vertices in extended precision, no order, no
// increments, no reference frame. Shares no formula with src/lp.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "support/program/linear_program.h"

namespace avo::test {

using Real = long double;
using reference::ProgramResult;
using reference::ProgramState;

struct Point {
  Real x, y;
};

struct Program {
  std::vector<HalfPlane> hard, soft;
  Disc acceleration, speed;
  Vec2 preferred;
};

inline ProgramResult run(const Program& p) {
  std::vector<HalfPlane> scratch;
  return reference::nearest_point(p.hard, p.soft, p.acceleration, p.speed, p.preferred, scratch);
}

/// The m of the header's bound (2).
inline double magnitude(const Program& p) {
  const bool first = p.acceleration.radius <= p.speed.radius;
  const Disc& smaller = first ? p.acceleration : p.speed;
  const Disc& larger = first ? p.speed : p.acceleration;
  const bool crossing =
      std::hypot(larger.center.x - smaller.center.x, larger.center.y - smaller.center.y) >
      larger.radius - smaller.radius;
  const Disc& disc = crossing ? larger : smaller;
  return std::hypot(disc.center.x, disc.center.y) + disc.radius;
}

inline Real distance(Point a, Vec2 b) {
  return std::hypot(a.x - static_cast<Real>(b.x), a.y - static_cast<Real>(b.y));
}

inline Real excess(const HalfPlane& plane, Point u) {
  return static_cast<Real>(plane.offset) - static_cast<Real>(plane.normal.x) * u.x -
         static_cast<Real>(plane.normal.y) * u.y;
}

inline Real excess(const Disc& disc, Point u) {
  return distance(u, disc.center) - static_cast<Real>(disc.radius);
}

inline Real worst(const std::vector<HalfPlane>& planes, Point u) {
  Real largest = -std::numeric_limits<Real>::infinity();
  for (const HalfPlane& plane : planes) largest = std::max(largest, excess(plane, u));
  return largest;
}

/// A closed convex set by its boundaries: lines and circles, each moved by its own amount.
class ConvexSet {
 public:
  /// Half-planes {n . u >= offset - yield}; negative yield shrinks the set.
  void add(const std::vector<HalfPlane>& planes, Real yield) {
    for (const HalfPlane& plane : planes) {
      lines_.push_back({{plane.normal.x, plane.normal.y}, plane.offset - yield});
    }
  }
  void add(const Disc& disc, Real yield) {
    if (!std::isfinite(disc.radius)) return;
    circles_.push_back({{disc.center.x, disc.center.y}, std::max<Real>(disc.radius + yield, 0.0L)});
  }

  [[nodiscard]] bool contains(Point u, Real slack) const {
    for (const Line& line : lines_) {
      if (line.n.x * u.x + line.n.y * u.y < line.offset - slack) return false;
    }
    for (const Circle& circle : circles_) {
      if (std::hypot(u.x - circle.c.x, u.y - circle.c.y) > circle.r + slack) return false;
    }
    return true;
  }

  /// The nearest point to p: p itself, a projection on one boundary, or a crossing of two. Nothing
  /// if none of them lies in the set, hence if it is empty.
  [[nodiscard]] std::optional<Point> nearest(Point p, Real slack) const {
    std::vector<Point> candidates{p};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Line& a = lines_[i];
      const Real gap = a.offset - a.n.x * p.x - a.n.y * p.y;
      candidates.push_back({p.x + gap * a.n.x, p.y + gap * a.n.y});
      for (std::size_t j = 0; j < i; ++j) cross(a, lines_[j], candidates);
      for (const Circle& circle : circles_) cross(a, circle, candidates);
    }
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      const Circle& a = circles_[i];
      const Real d = std::hypot(p.x - a.c.x, p.y - a.c.y);
      candidates.push_back(a.c);
      if (d > 0) {
        candidates.push_back(
            {a.c.x + a.r * ((p.x - a.c.x) / d), a.c.y + a.r * ((p.y - a.c.y) / d)});
      }
      for (std::size_t j = 0; j < i; ++j) cross(a, circles_[j], candidates);
    }
    std::optional<Point> best;
    Real best_distance = std::numeric_limits<Real>::infinity();
    for (const Point& u : candidates) {
      const Real d = std::hypot(u.x - p.x, u.y - p.y);
      if (d < best_distance && contains(u, slack)) best = u, best_distance = d;
    }
    return best;
  }

 private:
  struct Line {
    Point n;
    Real offset;
  };
  struct Circle {
    Point c;
    Real r;
  };

  static void cross(const Line& a, const Line& b, std::vector<Point>& out) {
    const Real det = a.n.x * b.n.y - a.n.y * b.n.x;
    if (det == 0) return;
    out.push_back(
        {(a.offset * b.n.y - b.offset * a.n.y) / det, (b.offset * a.n.x - a.offset * b.n.x) / det});
  }
  static void cross(const Line& a, const Circle& b, std::vector<Point>& out) {
    const Real length = std::hypot(a.n.x, a.n.y);
    const Point n{a.n.x / length, a.n.y / length};
    const Real gap = a.offset / length - n.x * b.c.x - n.y * b.c.y;
    const Real half = std::sqrt(std::max<Real>((b.r - gap) * (b.r + gap), 0.0L));
    out.push_back({b.c.x + gap * n.x - half * n.y, b.c.y + gap * n.y + half * n.x});
    out.push_back({b.c.x + gap * n.x + half * n.y, b.c.y + gap * n.y - half * n.x});
  }
  static void cross(const Circle& a, const Circle& b, std::vector<Point>& out) {
    const Real dx = b.c.x - a.c.x, dy = b.c.y - a.c.y;
    const Real d2 = dx * dx + dy * dy;
    if (d2 == 0) return;
    const Real along = (d2 + (a.r - b.r) * (a.r + b.r)) / (2 * d2);
    const Real up = std::sqrt(std::max<Real>(a.r * a.r / d2 - along * along, 0.0L));
    for (Real side : {-1.0L, 1.0L}) {
      out.push_back({a.c.x + along * dx - side * up * dy, a.c.y + along * dy + side * up * dx});
    }
  }

  std::vector<Line> lines_;
  std::vector<Circle> circles_;
};

/// splitmix64: the same programs on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform(double a, double b) {
    return a + (b - a) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  bool chance(double p) { return uniform(0.0, 1.0) < p; }
  Vec2 unit() {
    const double angle = uniform(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  Vec2 in_square(double half) { return {uniform(-half, half), uniform(-half, half)}; }
  Vec2 vector(double shortest, double longest) {
    const double length = uniform(shortest, longest);  // drawn before the direction
    return length * unit();
  }

 private:
  std::uint64_t state_;
};

}  // namespace avo::test
