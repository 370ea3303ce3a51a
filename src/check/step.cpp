// SPDX-License-Identifier: Apache-2.0
// The bodies that move over one step of a recording, and their pairs as relative paths.
#include "check/step.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "check/course.h"
#include "check/demand.h"
#include "core/elementary.h"

namespace avo::judge {
namespace {

// A disc from one knot to the next.
struct Span {
  CourseKnot from, to;
};

// Differences are formed first: far from the origin the rows are coarse, their differences are
// exact.
RelativePath cubic(const Span& span, double duration) {
  const double third = duration / 3.0;
  return {{span.from.position, span.from.position + third * span.from.velocity,
           span.to.position - third * span.to.velocity, span.to.position}};
}

CourseKnot difference(const CourseKnot& a, const CourseKnot& b) {
  return {a.position - b.position, a.velocity - b.velocity};
}

CourseKnot knot_within(const Span& span, double duration, double u) {
  const auto& [b0, b1, b2, b3] = cubic(span, duration).control;
  const auto between = [u](Vec2 from, Vec2 to) { return (1.0 - u) * from + u * to; };
  const Vec2 b01 = between(b0, b1), b12 = between(b1, b2), b23 = between(b2, b3);
  const Vec2 b012 = between(b01, b12), b123 = between(b12, b23);
  return {between(b012, b123), (3.0 / duration) * (b123 - b012)};
}

// Part k of the disc's own parts.
Span own_span(const MovingDisc& disc, std::size_t k) {
  if (disc.knots.empty()) return {{disc.from, disc.from_velocity}, {disc.to, disc.to_velocity}};
  return {disc.knots[k], disc.knots[k + 1]};
}

// Part k of as many parts as its own, or a multiple of them.
Span span_of(const MovingDisc& disc, double duration, std::size_t k, std::size_t parts) {
  const std::size_t finer = parts / disc.parts(), i = k % finer;
  const Span span = own_span(disc, k / finer);
  const auto at = [&](std::size_t end) {
    return knot_within(span, duration / static_cast<double>(disc.parts()),
                       static_cast<double>(end) / static_cast<double>(finer));
  };
  return {i == 0 ? span.from : at(i), i + 1 == finer ? span.to : at(i + 1)};
}

// The largest distance of the cubic from the arc of a car with rows without headings, m: see
// arc.cpp and course.cpp. At rest there is no heading to determine the curvature. But the
// acceleration is a_max at most, and ∫|K(u, s)| ds of the interpolation's Peano kernel is at most
// 1/16, at u = 1/2.
double arc_error(const CheckedState& before, const CheckedState& now, double max_acceleration,
                 double duration) {
  const double any = max_acceleration * duration * duration / 16.0;
  const double from = norm(before.velocity), to = norm(now.velocity);
  if (!(from > 0.0 && to > 0.0)) return any;
  const double turn =
      elementary::atan2(cross(before.velocity, now.velocity), dot(before.velocity, now.velocity));
  const double change = std::abs(to - from) * duration;  // a Δt², m
  const double top = std::max(from, to);
  const double rate = std::abs(turn) * top / (0.5 * (from + to));  // v κ Δt, rad
  const double along = 6.0 * change * rate * rate;
  const double length = top * duration;
  const double across = 3.0 * change * change * rate / length + length * rate * rate * rate;
  return std::min(any, (along + across) / 384.0);
}

// Within one cubic; its velocity is the quadratic with control points 3d, blossomed: with its
// control points over the part.
double speed_within(const Span& span, double from, double to, double duration) {
  const double third = duration / 3.0;
  const Vec2 d0 = third * span.from.velocity, d2 = third * span.to.velocity;
  const Vec2 d1 = (span.to.position - span.from.position) - (d0 + d2);
  const auto blossom = [&](double s, double t) {
    return (1.0 - s) * ((1.0 - t) * d0 + t * d1) + s * ((1.0 - t) * d1 + t * d2);
  };
  const double longest =
      std::max({norm(blossom(from, from)), norm(blossom(from, to)), norm(blossom(to, to))});
  return 3.0 * longest / duration;
}

}  // namespace

MovingDisc robot_disc(const CheckedRobot& robot, std::size_t disc, const CheckedState& before,
                      const CheckedState& now, double duration) {
  MovingDisc moved{center_of(robot, before, disc),
                   before.velocity,
                   center_of(robot, now, disc),
                   now.velocity,
                   robot.radius,
                   robot.interpolation_error,
                   now.robot};
  if (std::optional<DiscCourse> course = course_of(robot, disc, before, now, duration)) {
    moved.error += course->error;
    moved.knots = std::move(course->knots);
  } else if (!is_holonomic(robot.kinematics)) {
    moved.error += arc_error(before, now, braking_of(robot), duration);
  }
  if (robot.straight)
    moved.from_velocity = moved.to_velocity = (now.position - before.position) / duration;
  return moved;
}

MovingDisc newcomer(const CheckedRobot& robot, std::size_t disc, const CheckedState& now) {
  const Vec2 center = center_of(robot, now, disc);
  MovingDisc moved{center,       now.velocity, center,
                   now.velocity, robot.radius, robot.interpolation_error,
                   now.robot};
  moved.newcomer = true;
  return moved;
}

PlacedMover place_of(const CheckedMover& mover, double time) {
  const double t = time;
  return {mover.position + t * (mover.velocity + (0.5 * t) * mover.acceleration),
          mover.velocity + t * mover.acceleration};
}

MovingDisc mover_disc(const PlacedMover& from, const PlacedMover& to, double radius,
                      std::int64_t index) {
  MovingDisc disc{from.position, from.velocity, to.position, to.velocity, radius, 0.0, index};
  disc.is_mover = true;
  return disc;
}

RelativePath path_of(const MovingDisc& disc, double duration, Vec2 origin, std::size_t k,
                     std::size_t parts) {
  const Vec2 to = disc.to - origin;
  if (disc.newcomer) return {{to, to, to, to}};
  Span span = span_of(disc, duration, k, parts);
  span.from.position = span.from.position - origin;
  span.to.position = span.to.position - origin;
  return cubic(span, duration / static_cast<double>(parts));
}

RelativePath relative_path(const MovingDisc& a, const MovingDisc& b, double duration, std::size_t k,
                           std::size_t parts) {
  const Vec2 to = a.to - b.to;
  if (end_only(a, b)) return {{to, to, to, to}};
  const Span one = span_of(a, duration, k, parts), other = span_of(b, duration, k, parts);
  return cubic({difference(one.from, other.from), difference(one.to, other.to)},
               duration / static_cast<double>(parts));
}

BoundingBox box_of(const MovingDisc& disc, std::size_t owner, double duration) {
  const std::size_t parts = disc.parts();
  const auto box_of_part = [&](std::size_t k) {
    return box_around(path_of(disc, duration, {}, k, parts).control, disc.radius, owner);
  };
  BoundingBox box = box_of_part(0);
  for (std::size_t k = 1; k < parts; ++k) box = hull(box, box_of_part(k));
  return box;
}

double speed_bound(const MovingDisc& disc, double from_fraction, double to_fraction,
                   double duration) {
  if (disc.newcomer) return norm(disc.to_velocity);
  const auto parts = static_cast<double>(disc.parts());
  const auto last = disc.parts() - 1;
  const auto part_at = [&](double fraction) {
    return std::min(static_cast<std::size_t>(parts * fraction), last);
  };
  double most = 0.0;
  for (std::size_t k = part_at(from_fraction); k <= part_at(to_fraction); ++k) {
    const double from = std::max(parts * from_fraction - static_cast<double>(k), 0.0);
    const double to = std::min(parts * to_fraction - static_cast<double>(k), 1.0);
    most = std::max(most, speed_within(own_span(disc, k), from, to, duration / parts));
  }
  return most;
}

}  // namespace avo::judge
