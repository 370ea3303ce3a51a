// SPDX-License-Identifier: Apache-2.0
// Eqs. (13), (14): the free velocity nearest the preferred one, on the boundary of the union.
#include "planner/methods/passive_obstacles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lp/lens.h"
#include "planner/methods/passive_candidates.h"

namespace avo::inline planner {
namespace {

// Distances that differ by less than this part are equal up to rounding.
constexpr double kTie = 0x1p-40;
constexpr int kRootSteps = 100;
// How finely a piece is searched for a point outside one limit; obstacles cost much more to test.
constexpr int kObstacleHalvings = 4;
constexpr int kDiscHalvings = 12;

struct FreeSearch {
  std::span<const Limit> limits;
  std::span<const Curve> curves;
  Vec2 preferred;
  bool has_free = false;
  Vec2 best{};
  double distance = std::numeric_limits<double>::infinity();  // of best to preferred, m/s
  std::size_t last_violated = 0;                              // most likely to be violated again

  double distance_to(Vec2 u) const { return norm(u - preferred); }
  bool too_far(double d) const { return d > distance * (1.0 + kTie); }

  // The velocity nearest to `preferred` wins; of equally near ones the one farthest to the right of
  // it.
  void offer(Vec2 u) {
    const double d = distance_to(u);
    if (too_far(d)) return;
    const bool tied = has_free && d >= distance * (1.0 - kTie);
    if (tied && !(cross(preferred, u) < cross(preferred, best))) return;
    best = u;
    distance = d;
    has_free = true;
  }

  // The index of a limit that the point violates, or kFree. Discs and lines are tested quickly; of
  // the obstacles the last violated one is tried first.
  int violated(Vec2 u) {
    const std::size_t count = limits.size();
    for (std::size_t k = 0; k < count; ++k) {
      if (limits[k].kind != Limit::Kind::obstacle && violates(limits[k], u)) {
        return static_cast<int>(k);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = (last_violated + i) % count;
      if (limits[k].kind == Limit::Kind::obstacle && violates(limits[k], u)) {
        last_violated = k;
        return static_cast<int>(k);
      }
    }
    return CurvePoint::kFree;
  }

  int violated(CurvePoint& point) {
    if (point.violated == CurvePoint::kUnknown) point.violated = violated(point.position);
    return point.violated;
  }
};

// The point where f changes sign; f is negative at one of the two points of the curve and not at
// the other. The result is the end of the last bracket where f is not negative. It uses false
// position with halved weights (Illinois), and bisection where that does not halve the bracket in
// three steps.
template <typename F>
CurvePoint crossing(const FreeSearch& search, const Curve& curve, CurvePoint negative, double f_low,
                    CurvePoint positive, double f_high, F&& f) {
  double width = std::abs(positive.parameter - negative.parameter);
  int side = 0;
  for (int k = 1; k < kRootSteps; ++k) {
    const double a = negative.parameter, b = positive.parameter;
    double t = a - f_low * ((b - a) / (f_high - f_low));
    if (k % 3 == 0) {
      if (!(std::abs(b - a) <= 0.5 * width)) t = a + 0.5 * (b - a);
      width = std::abs(b - a);
    }
    if (!(t > std::min(a, b) && t < std::max(a, b))) t = a + 0.5 * (b - a);
    if (!(t > std::min(a, b) && t < std::max(a, b))) break;  // neighboring doubles
    const CurvePoint middle = point_at(curve, search.limits, t);
    const double f_middle = f(middle);
    if (f_middle < 0.0) {
      negative = middle;
      f_low = f_middle;
      if (side == -1) f_high *= 0.5;
      side = -1;
    } else {
      positive = middle;
      f_high = f_middle;
      if (f_middle == 0.0) break;
      if (side == 1) f_low *= 0.5;
      side = 1;
    }
  }
  return positive;
}

// A point between a and b at which the limit holds, although both violate it; the first one found
// from a on. Halves are given up where the clearance cannot rise to 0 at the rate that `steepness`
// allows, or after `depth` halvings.
std::optional<CurvePoint> release(const FreeSearch& search, const Curve& curve, const Limit& limit,
                                  const CurvePoint& a, double f_a, const CurvePoint& b, double f_b,
                                  int depth) {
  // the curve turns so little in a piece that it is at most a quarter longer than its chord
  const double length = 1.25 * norm(b.position - a.position);
  if (depth == 0 || f_a + f_b + steepness(limit) * length < 0.0) return std::nullopt;
  const CurvePoint middle = point_at(curve, search.limits, 0.5 * (a.parameter + b.parameter));
  const double f_middle = clearance(limit, middle.position);
  if (f_middle >= 0.0) return middle;
  const auto first = release(search, curve, limit, a, f_a, middle, f_middle, depth - 1);
  if (first) return first;
  return release(search, curve, limit, middle, f_middle, b, f_b, depth - 1);
}

// Walks a stretch on which the distance to `preferred` only grows: its first free point is offered.
void walk(FreeSearch& search, const Curve& curve, CurvePoint& first, const CurvePoint& last) {
  if (search.too_far(search.distance_to(first.position))) return;
  int k = search.violated(first);
  CurvePoint from = first;
  for (std::size_t turns = 0; k != CurvePoint::kFree; ++turns) {
    if (turns > search.limits.size()) return;
    // continue to where that limit no longer is violated, at the end or in between
    const Limit& limit = search.limits[static_cast<std::size_t>(k)];
    const auto f = [&](const CurvePoint& point) { return clearance(limit, point.position); };
    const double f_from = f(from), f_last = f(last);
    CurvePoint free = last;
    if (f_last < 0.0) {
      const int depth = limit.kind == Limit::Kind::obstacle ? kObstacleHalvings : kDiscHalvings;
      const auto between = release(search, curve, limit, from, f_from, last, f_last, depth);
      if (!between) return;
      free = *between;
    }
    from = crossing(search, curve, from, f_from, free, f(free), f);
    if (search.too_far(search.distance_to(from.position))) return;
    k = search.violated(from.position);
  }
  search.offer(from.position);
}

// Tries a piece of a boundary: it is cut at the projection of `preferred`, and each part is walked
// outwards.
void try_piece(FreeSearch& search, const Curve& curve, CurvePoint& a, CurvePoint& b) {
  const auto side = [&](const CurvePoint& point) {
    return cross(point.normal, search.preferred - point.position);
  };
  const double at_a = side(a), at_b = side(b);
  if ((at_a < 0.0) != (at_b < 0.0)) {
    CurvePoint foot = at_a < 0.0 ? crossing(search, curve, a, at_a, b, at_b, side)
                                 : crossing(search, curve, b, at_b, a, at_a, side);
    // the foot may be the nearest point of the piece, or the farthest
    if (search.distance_to(foot.position) <= search.distance_to(a.position)) {
      walk(search, curve, foot, a);
      walk(search, curve, foot, b);
    } else {
      walk(search, curve, a, foot);
      walk(search, curve, b, foot);
    }
  } else if (search.distance_to(a.position) <= search.distance_to(b.position)) {
    walk(search, curve, a, b);
  } else {
    walk(search, curve, b, a);
  }
}

// A lower bound of the distance of the piece from p: the distance to its chord, less half its
// length. A piece that turns by less than a half circle bulges by less than that.
double piece_bound(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a;
  const double length = norm(along);
  if (!(length > 0.0)) return norm(a - p);
  const double part = std::clamp(dot(p - a, along) / (length * length), 0.0, 1.0);
  return std::max(0.0, norm(a + part * along - p) - 0.5 * length);
}

// The largest violation, or any violation that is not below `enough`. `worst` is the limit that was
// the worst last time, and is likely to be so again; it is replaced.
double worst_violation(std::span<const Limit> limits, Vec2 u, double enough, std::size_t& worst) {
  const std::size_t first = worst;
  double largest = violation(limits[first], u);
  for (std::size_t k = 0; k < limits.size() && largest < enough; ++k) {
    if (k == first || limits[k].kind == Limit::Kind::disc) continue;
    const double here = violation(limits[k], u);
    if (here > largest) {
      largest = here;
      worst = k;
    }
  }
  return largest;
}

// The least violation among the preferred velocity, a fan of velocities and the boundary points,
// all brought into the discs. Then it descends from there by compass steps.
PassiveChoice least_unsafe(std::span<const Limit> limits, std::span<const CurvePoint> points,
                           const Lens& lens, Vec2 preferred) {
  PassiveChoice choice{{}, std::numeric_limits<double>::infinity(), PassiveState::least_unsafe};
  std::size_t worst = 0;  // the first limit is no disc
  const auto offer = [&](Vec2 u) {
    const Vec2 allowed = nearest(lens, u);
    const double largest = worst_violation(limits, allowed, choice.violation, worst);
    if (!(largest < choice.violation)) return false;
    choice.velocity = allowed;
    choice.violation = largest;
    return true;
  };
  try_candidates({limits, points, lens, preferred}, choice.velocity, offer);
  return choice;
}

}  // namespace

PassiveChoice choose_among_movers(std::span<const PassiveObstacle> obstacles,
                                  const Disc& acceleration, const Disc& speed, Vec2 preferred,
                                  PassiveWorkspace& workspace, std::span<const HalfPlane> walls) {
  const Lens lens = make_lens(acceleration, speed.radius);
  if (lens.empty) return {{}, lens.gap, PassiveState::discs_disjoint};
  auto& [limits, curves, points, pieces] = workspace;
  limits.clear();
  curves.clear();
  points.clear();
  pieces.clear();
  for (const PassiveObstacle& mover : obstacles) append_limit(mover, acceleration, speed, limits);
  for (const HalfPlane& wall : walls) append_limit(wall, limits);

  // the preferred velocity itself, or its projection on the discs
  const Vec2 allowed = nearest(lens, preferred);
  FreeSearch search{limits, curves, preferred};
  if (limits.empty() || search.violated(allowed) == CurvePoint::kFree) {
    return {allowed, 0.0, PassiveState::free};
  }

  append_limit(acceleration, limits);
  append_limit(speed, limits);
  for (std::size_t k = 0; k < limits.size(); ++k) {
    append_boundary(static_cast<int>(k), acceleration, speed, workspace);
  }
  const auto point = [&workspace](int k) -> CurvePoint& {
    return workspace.points[static_cast<std::size_t>(k)];
  };
  for (CurvePiece& piece : pieces) {
    piece.bound = piece_bound(point(piece.first).position, point(piece.second).position, preferred);
  }
  std::sort(pieces.begin(), pieces.end(), [](const CurvePiece& a, const CurvePiece& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.first < b.first;
  });
  search.limits = limits;
  search.curves = curves;
  for (const CurvePiece& piece : pieces) {
    if (search.too_far(piece.bound)) break;
    try_piece(search, curves[static_cast<std::size_t>(piece.curve)], point(piece.first),
              point(piece.second));
  }
  if (search.has_free) return {search.best, 0.0, PassiveState::free};
  return least_unsafe(limits, points, lens, preferred);
}

}  // namespace avo::inline planner
