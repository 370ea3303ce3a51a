// SPDX-License-Identifier: Apache-2.0
// Membership in an obstacle: the exact closest approach by branch and bound on time (Eqs. 4, 10).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "avo/velocity_obstacle.h"

namespace avo {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// The largest number of open intervals. Each split leaves at most 3/4 of an interval. So this many
// levels reach the spacing of doubles anywhere except next to t = 0, where positions differ by less
// than rounding.
constexpr int kMaxOpen = 160;
// The largest number of splits. Random and degenerate tests need below 100; the bound ensures
// termination.
constexpr int kMaxSplits = 4096;

// The relative motion x(t) = p + t v + g(t) w, Eq. (9).
struct RelativeMotion {
  Vec2 p, v, w;
  const Response& response;
  double bend;  // g''(0)
};

double initial_bend(const Response& response) {
  if (response.is_acceleration()) return 1.0;
  return response.control_time() > 0.0 ? 1.0 / response.control_time() : 0.0;
}

// The motion at one time; slope is half the derivative of the squared distance.
struct MotionAt {
  double t, gain, rate;
  Vec2 position, velocity;
  double slope;
};

MotionAt at(const RelativeMotion& motion, double t) {
  const double gain = t > 0.0 ? motion.response.gain(t) : 0.0;
  const double rate = motion.response.rate(t);
  const Vec2 position = motion.p + t * motion.v + gain * motion.w;
  const Vec2 velocity = motion.v + rate * motion.w;
  return {t, gain, rate, position, velocity, dot(position, velocity)};
}

// The error of a position: a few roundings of its three terms, m.
double position_error(const RelativeMotion& motion, const MotionAt& instant) {
  return kEpsilon * (norm(motion.p) + instant.t * norm(motion.v) + instant.gain * norm(motion.w));
}

double segment_distance(Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double length_squared = norm_squared(d);
  if (!(length_squared > 0.0)) return norm(a);
  const double part = std::clamp(-dot(a, d) / length_squared, 0.0, 1.0);
  return norm(a + part * d);
}

double triangle_distance(Vec2 a, Vec2 b, Vec2 c) {
  const double ab = cross(a, b), bc = cross(b, c), ca = cross(c, a);
  if ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0)) return 0.0;
  return std::min({segment_distance(a, b), segment_distance(b, c), segment_distance(c, a)});
}

// (t, g(t)) is convex and bends no less at its start than at its end. It stays in the triangle of
// both ends and the point where the tangent of the start is at half time. (At t = 0 it is at the
// lag, where the tangents meet, at no extra cost.) The motion does so too, as a linear image of it.
Vec2 apex(const MotionAt& from, const MotionAt& to) {
  const double half = from.t == 0.0 ? to.t - to.gain / to.rate : 0.5 * (to.t - from.t);
  return from.position + half * from.velocity;
}

// Returns whether the squared distance is monotone. Its slope x . x' is bilinear, x in the triangle
// and x' on the segment of the end velocities: the signs at the corners decide.
bool is_monotone(const MotionAt& from, const MotionAt& to, Vec2 corner) {
  const auto [low, high] = std::minmax({from.slope, to.slope, dot(from.position, to.velocity),
                                        dot(to.position, from.velocity), dot(corner, from.velocity),
                                        dot(corner, to.velocity)});
  return low >= 0.0 || high <= 0.0;
}

// Returns whether the squared distance is convex: |x'|² + g'' x . w > 0 with the least |x'|, the
// largest g'' and the least x . w of the interval. g'' does not grow: it is at most that at 0, or
// the mean so far.
bool is_convex(const RelativeMotion& motion, const MotionAt& from, const MotionAt& to,
               Vec2 corner) {
  const double least =
      std::min({dot(from.position, motion.w), dot(to.position, motion.w), dot(corner, motion.w)});
  const double speed = segment_distance(from.velocity, to.velocity);
  double bend = motion.bend;
  if (from.t > 0.0) bend = std::min(bend, from.rate / from.t);
  return speed * speed > bend * std::max(0.0, -least);
}

// The zero of the slope between `from` (slope < 0) and `to` (slope > 0). It uses regula falsi with
// the weights of Anderson and Björck, and a bisection wherever three steps did not halve the
// bracket.
MotionAt bottom(const RelativeMotion& motion, MotionAt from, MotionAt to) {
  double low = from.slope, high = to.slope;  // weighted
  double width = to.t - from.t;
  int side = 0;  // of the last step
  MotionAt middle = to;
  for (int k = 1; k < 200; ++k) {
    double t = from.t - low * ((to.t - from.t) / (high - low));
    if (k % 3 == 0) {
      if (!(to.t - from.t <= 0.5 * width)) t = from.t + 0.5 * (to.t - from.t);
      width = to.t - from.t;
    }
    if (!(t > from.t && t < to.t)) t = from.t + 0.5 * (to.t - from.t);
    if (!(t > from.t && t < to.t)) break;  // neighboring doubles
    middle = at(motion, t);
    if (std::abs(middle.slope) <= position_error(motion, middle) * norm(middle.velocity)) break;
    const int now = middle.slope < 0.0 ? -1 : 1;
    const double weight = 1.0 - middle.slope / (now < 0 ? low : high);
    const double shrink = side != now ? 1.0 : weight > 0.0 ? weight : 0.5;
    if (now < 0) {
      from = middle;
      low = middle.slope;
      high *= shrink;
    } else {
      to = middle;
      high = middle.slope;
      low *= shrink;
    }
    side = now;
    if (to.t - from.t <= 2.0 * kEpsilon * to.t) break;
  }
  return middle;
}

// The time of the split: at the zero of the slope's chord if there is one, not too near the ends.
double split_time(const MotionAt& from, const MotionAt& to) {
  double part = 0.5;
  if (from.slope < 0.0 && to.slope > 0.0) part = from.slope / (from.slope - to.slope);
  return from.t + std::clamp(part, 0.25, 0.75) * (to.t - from.t);
}

// Keeps the smallest distance so far; of equal ones the earliest.
void keep_nearer(const MotionAt& instant, ClosestApproach& best) {
  const double distance = norm(instant.position);
  if (distance < best.distance || (distance == best.distance && instant.t < best.time)) {
    best = {instant.t, distance};
  }
}

// Returns whether nothing in the interval is nearer than `limit`, or than `best` by more than 2^-46
// of it or than rounding.
bool is_farther(const RelativeMotion& motion, const MotionAt& from, const MotionAt& to, Vec2 corner,
                const ClosestApproach& best, double limit) {
  const double least = triangle_distance(from.position, to.position, corner);
  return !(least < limit) ||
         !(least < best.distance * (1.0 - 0x1p-46) - position_error(motion, to));
}

// Intervals are settled from left to right. Their right ends wait on a stack, all of them already
// compared. The right end of a settled interval becomes the left end of the next. With a limit,
// only distances below it matter and the first of them ends the search.
ClosestApproach search(const Obstacle& obstacle, Vec2 u, double limit) {
  const RelativeMotion motion{obstacle.pair.position, obstacle.pair.velocity, change(obstacle, u),
                              obstacle.response, initial_bend(obstacle.response)};
  const bool any_will_do = std::isfinite(limit);
  MotionAt from = at(motion, 0.0);
  ClosestApproach best{0.0, norm(from.position)};
  std::array<MotionAt, kMaxOpen> open;
  std::size_t count = 1;
  open[0] = at(motion, obstacle.time_horizon);
  keep_nearer(open[0], best);
  for (int splits = 0; count > 0 && !(any_will_do && best.distance < limit);) {
    const MotionAt& to = open[count - 1];
    const Vec2 corner = apex(from, to);
    bool settled =
        is_monotone(from, to, corner) || is_farther(motion, from, to, corner, best, limit);
    if (!settled && is_convex(motion, from, to, corner)) {
      if (from.slope < 0.0 && to.slope > 0.0) keep_nearer(bottom(motion, from, to), best);
      settled = true;
    }
    const double t = split_time(from, to);
    if (settled || count == kMaxOpen || splits == kMaxSplits || !(t > from.t && t < to.t)) {
      from = to;
      --count;
    } else {
      open[count] = at(motion, t);
      keep_nearer(open[count], best);
      ++count;
      ++splits;
    }
  }
  return best;
}

}  // namespace

ClosestApproach closest_approach(const Obstacle& obstacle, Vec2 u) {
  return search(obstacle, u, std::numeric_limits<double>::infinity());
}

// Eqs. (4), (10), decided as early as possible. A distance below r at an end of the window is one
// inside it as well.
bool contains(const Obstacle& obstacle, Vec2 u) {
  return search(obstacle, u, obstacle.pair.radius).distance < obstacle.pair.radius;
}

}  // namespace avo
