// SPDX-License-Identifier: Apache-2.0
// What a result has to be, by brute force.
#pragma once
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include "unit/lp/brute_force.h"

namespace avo::test {

// Relative to the size of the program, but for the ulps.
constexpr Real kUlp = 0x1p-52L;
constexpr Real kPlaneUlps = 32;       // by which half-planes may be violated, of the header's m
constexpr Real kDiscUlps = 4;         // by which either disc may be left
constexpr Real kMargin = 1e-13L;      // what is thinner may count as nothing
constexpr Real kNearer = 1e-16L;      // than the point returned
constexpr double kViolation = 1e-14;  // between the one reported and that of the point
constexpr Real kLeast = 1e-9L;        // between the least and that of the point

inline std::string text(const Program& p, const ProgramResult& r) {
  std::ostringstream out;
  out.precision(17);
  const auto discs = {p.acceleration, p.speed};
  for (const Disc& d : discs) {
    out << "disc " << d.center.x << ' ' << d.center.y << ' ' << d.radius << '\n';
  }
  out << "preferred " << p.preferred.x << ' ' << p.preferred.y << '\n';
  for (const HalfPlane& h : p.hard) {
    out << "hard " << h.normal.x << ' ' << h.normal.y << ' ' << h.offset << '\n';
  }
  for (const HalfPlane& h : p.soft) {
    out << "soft " << h.normal.x << ' ' << h.normal.y << ' ' << h.offset << '\n';
  }
  out << "point " << r.point.x << ' ' << r.point.y << " violation " << r.violation << " state "
      << static_cast<int>(r.state);
  return out.str();
}

inline Point wide(Vec2 u) {
  return {u.x, u.y};
}

inline Real gap_of_discs(const Program& p) {
  return std::hypot(static_cast<Real>(p.speed.center.x) - p.acceleration.center.x,
                    static_cast<Real>(p.speed.center.y) - p.acceleration.center.y) -
         p.speed.radius - p.acceleration.radius;
}

// Everything that counts as size in the program.
inline Real extent(const Program& p) {
  Real size = magnitude(p);
  for (const Disc& disc : {p.acceleration, p.speed}) {
    if (!std::isfinite(disc.radius)) continue;
    size = std::max<Real>(size, std::hypot(disc.center.x, disc.center.y) + disc.radius);
  }
  return size > 0 ? size : 1;
}

// Bound (1) of the header.
inline void expect_in(const Disc& disc, Vec2 u) {
  if (!std::isfinite(disc.radius)) return;
  const Real size = std::hypot(disc.center.x, disc.center.y) + disc.radius;
  EXPECT_LE(excess(disc, wide(u)), kDiscUlps * kUlp * size);
}

// The set of `p` with every bound drawn in by `margin` and the given half-planes pushed out.
inline ConvexSet set_of(const Program& p, Real margin, const std::vector<HalfPlane>& kept,
                        const std::vector<HalfPlane>& yielding, Real yield) {
  ConvexSet set;
  set.add(p.acceleration, -margin);
  set.add(p.speed, -margin);
  set.add(kept, -margin);
  set.add(yielding, yield - margin);
  return set;
}

// The worst violation cannot be smaller by more than kLeast of the size, whatever the point.
inline void expect_least(const Program& p, const ProgramResult& r,
                         const std::vector<HalfPlane>& kept,
                         const std::vector<HalfPlane>& yielding) {
  const Real size = std::max<Real>(extent(p), r.violation);
  EXPECT_GT(r.violation, 0.0);
  EXPECT_NEAR(static_cast<double>(worst(yielding, wide(r.point)) / size),
              static_cast<double>(r.violation / size), kViolation);
  const ConvexSet better = set_of(p, kMargin * size, kept, yielding, r.violation - kLeast * size);
  EXPECT_FALSE(better.nearest(wide(p.preferred), 1e-17L * size).has_value());
}

inline void judge(const Program& p, const ProgramResult& r) {
  const Real size = extent(p);
  const Real m = magnitude(p);
  ASSERT_TRUE(is_finite(r.point) && std::isfinite(r.violation));
  expect_in(p.acceleration, r.point);
  if (r.state != ProgramState::discs_disjoint) expect_in(p.speed, r.point);
  if (r.state != ProgramState::hard_infeasible && r.state != ProgramState::discs_disjoint) {
    EXPECT_LE(worst(p.hard, wide(r.point)), kPlaneUlps * kUlp * m);
  }
  std::vector<HalfPlane> all = p.hard;
  all.insert(all.end(), p.soft.begin(), p.soft.end());
  switch (r.state) {
    case ProgramState::optimal: {
      EXPECT_EQ(r.violation, 0.0);
      EXPECT_LE(worst(all, wide(r.point)), kPlaneUlps * kUlp * m);
      const ConvexSet inner = set_of(p, kMargin * size, all, {}, 0);
      const auto best = inner.nearest(wide(p.preferred), 1e-17L * size);
      if (!best) break;  // thinner than that: feasible to rounding is all there is to ask
      EXPECT_LE(distance(wide(r.point), p.preferred),
                distance(*best, p.preferred) + kNearer * size);
      break;
    }
    case ProgramState::least_unsafe:
      expect_least(p, r, p.hard, p.soft);
      break;
    case ProgramState::hard_infeasible:
      expect_least(p, r, {}, p.hard);
      break;
    case ProgramState::discs_disjoint: {
      EXPECT_GT(gap_of_discs(p), 0);
      EXPECT_NEAR(static_cast<double>(gap_of_discs(p) / size),
                  static_cast<double>(r.violation / size), 1e-14);
      break;
    }
  }
}

}  // namespace avo::test
