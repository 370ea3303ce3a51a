// SPDX-License-Identifier: Apache-2.0
// Eqs. (15), (16) where the present velocity does not lead into a collision: the near side of the
// obstacle, towards w = 0, is concave (docs/half_plane.md, "Three cases"). This search finds any
// number of crossings Q of the near side, for the few horns that the kernels leave. Lemma 8 then
// gives the half-plane, as for all horns: see least_support() in horn_hull_kernel.h.
#include "obstacles/horn.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace avo::inline obstacles {
namespace {

using Real = scalar::Pack<double>;
using Vec = scalar::Vec<Real>;
using Side = scalar::NearSide<Real>;

constexpr double kTurnTolerance = 1e-7;  // relative; every use is of second order in the time

struct HornSearch {
  scalar::Horn<Real> horn;
  ResponseTable table;
  double R, speed;  // m/s
  double t_m;       // s, time of the closest approach, or 0
  double first;     // s, the near side matters only after this time
};

struct Touch {
  Side side;
  double t;       // s
  double length;  // |b|, m/s
  bool outside;   // |b| > R
};

Touch touch_at(const HornSearch& search, double t) {
  const Side side = scalar::near_side(search.horn, scalar::at(search.table, Real(t)), search.table);
  const double length = scalar::length_of(side).value;
  return {side, t, length, length > search.R};
}

// |p + t v|² - r²
double beyond(const HornSearch& search, double t) {
  return (search.horn.gap2 + search.horn.rise(Real(search.speed * t))).value;
}

// The crossing of a piece that has at most one, if there is one.
void cross(const HornSearch& search, const Touch& from, const Touch& to, NearCorners& corners) {
  if (from.outside == to.outside) return;
  // |b|^{-1/2} is nearly linear in time; the limit keeps the step in balance
  const auto f = [&](double length) { return std::sqrt(std::min(search.R / length, 9.0)) - 1.0; };
  const double f_from = f(from.length), f_to = f(to.length);
  const double start = (from.t * f_to - to.t * f_from) / (f_to - f_from);
  const scalar::HornCrossing<Real> crossed = scalar::crossing(
      search.horn, {from.t, to.t, start, from.outside ? 1.0 : -1.0, kCloseTolerance}, search.table,
      scalar::Mask{true});
  const scalar::TwoPoints<Real> ends =
      scalar::circle_points(search.horn, scalar::at(search.table, crossed.time));
  const bool on_near_end = crossed.tangential.value >= 0.0;
  // In contact, the edge of the first disc can be the near side, up to where the others take over.
  if (!on_near_end && corners.count == 0) corners.add(ends.near);
  corners.add(on_near_end ? ends.near : ends.far);
}

// The point where |b| turns as `sign` does, by false position (Illinois), then bisection.
Touch turn(const HornSearch& search, const Touch& from, const Touch& to, Real Side::*sign) {
  double low = from.t, high = to.t, f_low = (from.side.*sign).value, f_high = (to.side.*sign).value;
  const double negligible = 1e-8 * (std::abs(f_low) + std::abs(f_high));
  int kept = 0;
  for (int i = 0;; ++i) {
    double t = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(t > low && t < high) || i > 16) t = 0.5 * (low + high);
    const Touch touch = touch_at(search, t);
    const double f = (touch.side.*sign).value;
    if (std::abs(f) <= negligible || high - low <= kTurnTolerance * high || i == kMaxIterations) {
      return touch;
    }
    if ((f < 0.0) == (f_low < 0.0)) {
      low = t, f_low = f;
      if (kept == 1) f_high *= 0.5;
      kept = 1;
    } else {
      high = t, f_high = f;
      if (kept == 2) f_low *= 0.5;
      kept = 2;
    }
  }
}

bool changes(const Touch& from, const Touch& to, Real Side::*sign) {
  return ((from.side.*sign).value < 0.0) != ((to.side.*sign).value < 0.0);
}

// The crossings of a piece on which |b| may turn once by either sign.
void cross_turning(const HornSearch& search, const Touch& from, const Touch& to,
                   NearCorners& corners) {
  const bool one = changes(from, to, &Side::tangential), other = changes(from, to, &Side::cusp);
  const bool falls = (from.side.tangential.value < 0.0) == (from.side.cusp.value < 0.0);
  // no turn; or one turn that does not pass R and come back: down from outside, or up from inside
  const bool simple = one != other ? from.outside != to.outside || from.outside != falls : !one;
  if (simple) return cross(search, from, to, corners);
  Touch first = one ? turn(search, from, to, &Side::tangential) : from;
  Touch second = other ? turn(search, from, to, &Side::cusp) : from;
  if (second.t < first.t) std::swap(first, second);
  cross(search, from, first, corners);
  cross(search, first, second, corners);
  cross(search, second, to, corners);
}

// Earlier than this a pair in contact looks like a pair that touches at rest. To first order in t,
// its discs have tended to a half-plane.
double contact_time(const HornSearch& search) {
  return 1e-7 * std::min(search.horn.pair.r.value / search.speed, search.table.control_time);
}

// Returns whether |b| stays below R from here on: |b| <= |x|/g, and |x|/g <= R stays true once |v|
// <= R g'.
bool stays_in_reach(const HornSearch& search, const Touch& touch) {
  const scalar::At<Real>& at = touch.side.at;
  return !touch.outside && search.speed <= search.R * at.rate.value &&
         norm(search.horn.pair.x(at)).value <= search.R * at.gain.value;
}

// All crossings of the near side. |b| falls up to the closest approach t_m. Past the cusps it can
// cross R outwards only while R g' < |v|, and then falls wherever it exceeds R. So only times
// between those two are searched for turning points.
void find_crossings(const HornSearch& search, NearCorners& corners) {
  const double tau = search.table.end, first = std::min(search.first, tau);
  Touch from = touch_at(search, first);
  if (search.R * from.side.at.gain.value * (2.0 * search.horn.pair.r.value) >
      beyond(search, first)) {
    // in contact from the start: the first disc's edge is a half-plane's
    corners.add(scalar::circle_points(search.horn, from.side.at));
  }
  const scalar::Strides<Real> stride = scalar::strides(search.horn, Real(search.t_m), search.table);
  while (from.t < tau && !stays_in_reach(search, from)) {
    const bool settled = search.R * from.side.at.rate.value >= search.speed &&
                         from.side.at.lag.value >= search.t_m && from.side.cusp.value >= 0.0;
    const double next = from.t < search.t_m ? search.t_m : stride.next(Real(from.t)).value;
    const Touch to = touch_at(search, !settled && next > from.t && next < tau ? next : tau);
    settled ? cross(search, from, to, corners) : cross_turning(search, from, to, corners);
    from = to;
  }
}

// With a distance of at least `closest`, everything is out of reach while R t²/(2 δ) < closest - r.
// A pair in contact with a miss distance of r up to rounding has the present distance again at 2
// t_m. Before that, its discs demand more than any reach, only to prevent an overlap of rounding.
HornSearch search_of(const scalar::Local<Real>& pair, const Horizon& horizon) {
  const scalar::Horn<Real> horn = scalar::horn_of(pair);
  const double speed = horn.speed.value, R = pair.R.value;
  HornSearch search{horn, horizon.table(), R, speed, 0.0, 0.0};
  const double contact = contact_time(search), clear = (horn.closest - pair.r).value;
  const double t_m = std::max(0.0, -(horn.z * horn.per_speed).value);
  const double r = pair.r.value;
  const bool grazes = pair.d.value - r <= kContact * r && !(horn.gap2.value > 0.0);
  search.t_m = t_m < contact || grazes ? 0.0 : t_m;
  const double out_of_reach = std::sqrt(std::max(0.0, 2.0 * search.table.control_time * clear / R));
  search.first = std::max(
      {out_of_reach, search.t_m > 0.0 ? 0.5 * contact : contact, grazes ? 2.0 * t_m : 0.0});
  return search;
}

}  // namespace

NearCorners near_corners(const scalar::Local<Real>& pair, const Horizon& horizon) {
  NearCorners corners;
  find_crossings(search_of(pair, horizon), corners);
  return corners;
}

scalar::HornPlane<Real> searched_horn(const scalar::Local<Real>& pair, const Horizon& horizon) {
  const scalar::At<Real> end = scalar::constant<Real>(horizon.end());
  auto hull = scalar::hull_of<NearCorners::kMost>(scalar::horn_of(pair), end, horizon.end());
  const NearCorners corners = near_corners(pair, horizon);
  hull.crossing = corners.points;
  for (std::size_t k = 0; k < NearCorners::kMost; ++k) hull.has_crossing[k] = {k < corners.count};
  return {scalar::least_support(hull), {true}, !(hull.disc_in_reach | hull.has_crossing[0])};
}

}  // namespace avo::inline obstacles
