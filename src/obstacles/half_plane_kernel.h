// SPDX-License-Identifier: Apache-2.0
// The paper's half-plane H, Eqs. (15), (16), in closed form (§IV-B). It has the unit normal n of
// least support of hull(D(0, R) ∩ AVO), with that support as offset, for as many pairs as Pack has
// lanes. Lemmas 1 to 3 of docs/half_plane.md, which has the figure and the symbols.
#ifndef AVO_OBSTACLES_HALF_PLANE_KERNEL_H
#define AVO_OBSTACLES_HALF_PLANE_KERNEL_H

#include <limits>

#include "obstacles/response_kernel.h"

AVO_BEGIN_KERNELS

/// A pair in its own frame: first axis along p, second across it on v's side: p = (d, 0), v.y >= 0,
/// ties apart. Exchanging the robots turns this frame by 180 degrees and changes no number in it.
template <typename Real>
struct Local {
  Real d;       // |p|, m
  Vec<Real> v;  // m/s
  Real r;       // m
  Real R;       // reach, m/s

  AVO_KERNEL Vec<Real> x(const At<Real>& at) const { return {d + at.time * v.x, at.time * v.y}; }
  AVO_KERNEL Vec<Real> y(const At<Real>& at) const { return {d + at.lag * v.x, at.lag * v.y}; }
};

template <typename Real>
struct SupportLine {
  Vec<Real> n;
  Real h;
};

// ---- tip: lemma 2

template <typename Real>
struct Tip {
  SupportLine<Real> plane;
  decltype(Real() < Real()) nearest;  // the line with n = x(τ)/|x(τ)| is highest at τ
};

// A test without search. With A = r - n·p and B = n·v, the tip decides if A <= 0 and B s(τ) >= A.
template <typename Real>
AVO_KERNEL Tip<Real> tip(const Local<Real>& pair, const ResponseAt& horizon_end) {
  const At<Real> end = constant<Real>(horizon_end);
  const Vec<Real> x = pair.x(end), y = pair.y(end);
  const Real length = norm(x), reach = pair.r * length;
  const auto nearest = (reach > Real(0.0)) & (pair.d * x.x >= reach) & (dot(x, y) >= reach);
  const Real per_length = inverse(length);
  return {{per_length * x, (pair.r - length) * Real(1.0 / horizon_end.gain)}, nearest};
}

// ---- convex: lemma 3

// On a collision course p·v < 0, and the miss distance |c| is below r. With û = -v/|v| and ê
// across û, x(t) = σ û + c ê and σ = |v| (t_m - t), where t_m is the time of the closest approach.
template <typename Real>
struct PairApproach {
  Real speed, per_speed, t_m, c;  // m/s, s/m, s, m; c < 0 only in a tie
  Vec<Real> u, e;                 // û, ê

  AVO_KERNEL Real time(Real sigma, Real tau) const {
    return min(max(t_m - sigma * per_speed, Real(0.0)), tau);
  }
  // μ = |v| (t_m - s): n . y = r reads (σ μ + c²)/|x| = r where n = x/|x|
  AVO_KERNEL Real mu(const At<Real>& at) const { return speed * (t_m - at.lag); }
};

template <typename Real>
AVO_KERNEL PairApproach<Real> approach(const Local<Real>& pair) {
  PairApproach<Real> result;
  result.speed = norm(pair.v);
  result.per_speed = inverse(result.speed);
  result.u = -result.per_speed * pair.v;
  result.e = {-result.u.y, result.u.x};
  result.t_m = result.u.x * pair.d * result.per_speed;
  result.c = pair.d * pair.v.y * result.per_speed;
  return result;
}

// Two starts, each near the root where the other is far. One is the lag of the latest time, the
// other is |x| linear in t at the middle of the disc of radius r.
template <typename Real>
AVO_KERNEL Real first_sigma(const Local<Real>& pair, const PairApproach<Real>& approach,
                            Real cosine, const ResponseTable& table, Real low, Real high) {
  const Real half_chord2 = max((pair.r - approach.c) * (pair.r + approach.c), Real(0.0));
  const Real halfway = Real(0.5) * sqrt(half_chord2) * approach.per_speed;
  const At<Real> middle = at(table, min(max(approach.t_m - halfway, Real(0.0)), Real(table.end)));
  const Real capped = min(cosine, Real(0.95));
  const Real sigma = max(abs(approach.c) * capped / sqrt(Real(1.0) - capped * capped),
                         pair.r - approach.speed * (middle.time - middle.lag));
  return select((sigma > low) & (sigma < high), sigma, Real(0.5) * (low + high));
}

// The σ at which n . y = r, where (σ μ + c²)/|x| increases in σ (in t it would have a kink near
// t_m): Newton's iteration, guarded by bisection; excess and slope are times |x|.
template <typename Real>
AVO_KERNEL Real solve_approach(const Local<Real>& pair, const PairApproach<Real>& approach,
                               Real cosine, const ResponseTable& table) {
  const Real tau = table.end, c2 = approach.c * approach.c;
  Real low = max(Real(0.0), approach.speed * (approach.t_m - tau));
  Real high = approach.speed * approach.t_m;
  Real sigma = first_sigma(pair, approach, cosine, table, low, high);
  auto active = pair.r > Real(0.0);
  for (int i = 0; i < kMaxIterations; ++i) {
    const At<Real> crossing = at(table, approach.time(sigma, tau));
    const Real mu = approach.mu(crossing);
    const Real x2 = sigma * sigma + c2;
    const Real excess = sigma * mu + c2 - pair.r * sqrt(x2);
    low = select(excess < Real(0.0), sigma, low);
    high = select(excess < Real(0.0), high, sigma);
    const Real lag_rate = select(crossing.rate > Real(0.0),
                                 crossing.gain * crossing.per_rate * (Real(1.0) - crossing.rate) *
                                     crossing.per_rate * Real(table.per_control_time),
                                 Real(0.5));  // at t = 0
    const Real slope = c2 * (mu - sigma) * inverse(x2) + sigma * lag_rate;
    const auto rises = slope > Real(0.0);
    const Real newton = sigma - excess / select(rises, slope, Real(1.0));
    // the last step is taken too, except a step of the guard, where only rounding is left
    const auto moves = (!rises) | (abs(newton - sigma) > Real(kConvexTolerance) * sigma);
    const Real next = select(rises & (newton > low) & (newton < high), newton,
                             select(moves, Real(0.5) * (low + high), sigma));
    sigma = select(active, next, sigma);
    active = active & moves;
    if (!any(active)) break;
  }
  return sigma;
}

template <typename Real>
AVO_KERNEL SupportLine<Real> convex(const Local<Real>& pair, const ResponseTable& table) {
  const PairApproach<Real> course = approach(pair);
  const Real tau = table.end;
  const At<Real> latest = at(table, min(course.t_m, tau));
  const Real per_mu = Real(1.0) / course.mu(latest), cosine = pair.r * per_mu;

  const Real sigma =
      solve_approach(pair, course, min((pair.r - abs(course.c)) * per_mu, Real(0.95)), table);
  const Real x = sqrt(sigma * sigma + course.c * course.c), per_x = inverse(x);
  // F(t), stationary here. In contact t, and with it r - |x|, is known only to rounding. There the
  // equal -n . v/g' keeps the demand high, and the least time above rounding keeps it finite.
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  const At<Real> crossing = at(table, max(course.time(sigma, tau), Real(kRounding) * course.t_m));
  Real h = (pair.r - x) / crossing.gain;
  const auto touching = pair.r - x < Real(1e-7) * pair.r;
  h = select(touching, max(h, course.speed * (sigma * per_x) * crossing.per_rate), h);
  Vec<Real> n = per_x * (sigma * course.u + course.c * course.e);

  // head-on, both sides are equally near, and n is where n . y = r at t_m itself. The same holds
  // where a miss distance, of either side, comes from rounding
  const Real rounding = Real(std::numeric_limits<double>::epsilon()) * pair.d;
  const auto head_on = (course.c <= rounding) & (course.t_m <= tau) & (cosine < Real(1.0));
  const Real sine = sqrt(max(Real(1.0) - cosine * cosine, Real(0.0)));
  const Vec<Real> side = cosine * course.u + sine * course.e;
  n.x = select(head_on, side.x, n.x);
  n.y = select(head_on, side.y, n.y);
  h = select(head_on, (pair.r - sine * course.c) / latest.gain, h);
  return {n, h};
}

AVO_END_KERNELS

#endif  // once per pass
