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

/// All but the ulps relative to the size of the program.
struct Allowed {
  Real ulp = 0x1p-52L;
  Real ulps = 32;           ///< by which half-planes may be violated, of the header's m
  bool narrowed = false;    ///< the input was: m is that of the larger disc
  Real disc_ulps = 4;       ///< by which either disc may be left
  Real margin = 1e-13L;     ///< what is thinner may count as nothing
  Real nearer = 1e-16L;     ///< than the point returned
  Real violation = 1e-14L;  ///< between the one reported and that of the point
  Real least = 1e-9L;       ///< between the least and that of the point
};

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
inline void expect_in(const Disc& disc, Vec2 u, const Allowed& allowed) {
  if (!std::isfinite(disc.radius)) return;
  const Real size = std::hypot(disc.center.x, disc.center.y) + disc.radius;
  EXPECT_LE(excess(disc, wide(u)), allowed.disc_ulps * allowed.ulp * size);
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

// The worst violation cannot be smaller by more than allowed.least of the size, whatever the point.
inline void expect_least(const Program& p, const ProgramResult& r, const Allowed& allowed,
                         const std::vector<HalfPlane>& kept,
                         const std::vector<HalfPlane>& yielding) {
  const Real size = std::max<Real>(extent(p), r.violation);
  EXPECT_GT(r.violation, 0.0);
  EXPECT_NEAR(static_cast<double>(worst(yielding, wide(r.point)) / size),
              static_cast<double>(r.violation / size), static_cast<double>(allowed.violation));
  const ConvexSet better =
      set_of(p, allowed.margin * size, kept, yielding, r.violation - allowed.least * size);
  EXPECT_FALSE(better.nearest(wide(p.preferred), 1e-17L * size).has_value());
}

inline void judge(const Program& p, const ProgramResult& r, const Allowed& allowed) {
  const Real size = extent(p);
  const Real m = allowed.narrowed ? size : magnitude(p);
  ASSERT_TRUE(is_finite(r.point) && std::isfinite(r.violation));
  expect_in(p.acceleration, r.point, allowed);
  if (r.state != ProgramState::discs_disjoint) expect_in(p.speed, r.point, allowed);
  if (r.state != ProgramState::hard_infeasible && r.state != ProgramState::discs_disjoint) {
    EXPECT_LE(worst(p.hard, wide(r.point)), allowed.ulps * allowed.ulp * m);
  }
  std::vector<HalfPlane> all = p.hard;
  all.insert(all.end(), p.soft.begin(), p.soft.end());
  switch (r.state) {
    case ProgramState::optimal: {
      EXPECT_EQ(r.violation, 0.0);
      EXPECT_LE(worst(all, wide(r.point)), allowed.ulps * allowed.ulp * m);
      const ConvexSet inner = set_of(p, allowed.margin * size, all, {}, 0);
      const auto best = inner.nearest(wide(p.preferred), 1e-17L * size);
      if (!best) break;  // thinner than that: feasible to rounding is all there is to ask
      EXPECT_LE(distance(wide(r.point), p.preferred),
                distance(*best, p.preferred) + allowed.nearer * size);
      break;
    }
    case ProgramState::least_unsafe:
      expect_least(p, r, allowed, p.hard, p.soft);
      break;
    case ProgramState::hard_infeasible:
      expect_least(p, r, allowed, {}, p.hard);
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
