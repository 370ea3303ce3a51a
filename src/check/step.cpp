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

// A mover from one knot to the next.
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

// Part k of the mover's own parts.
Span own_span(const MovingDisc& mover, std::size_t k) {
  if (mover.knots.empty())
    return {{mover.from, mover.from_velocity}, {mover.to, mover.to_velocity}};
  return {mover.knots[k], mover.knots[k + 1]};
}

// Part k of as many parts as its own, or a multiple of them.
Span span_of(const MovingDisc& mover, double duration, std::size_t k, std::size_t parts) {
  const std::size_t finer = parts / mover.parts(), i = k % finer;
  const Span span = own_span(mover, k / finer);
  const auto at = [&](std::size_t end) {
    return knot_within(span, duration / static_cast<double>(mover.parts()),
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

MovingDisc robot_mover(const CheckedRobot& robot, std::size_t disc, const CheckedState& before,
                       const CheckedState& now, double duration) {
  MovingDisc mover{center_of(robot, before, disc),
                   before.velocity,
                   center_of(robot, now, disc),
                   now.velocity,
                   robot.radius,
                   robot.interpolation_error,
                   now.robot};
  if (std::optional<DiscCourse> course = course_of(robot, disc, before, now, duration)) {
    mover.error += course->error;
    mover.knots = std::move(course->knots);
  } else if (!is_holonomic(robot.kinematics)) {
    mover.error += arc_error(before, now, braking_of(robot), duration);
  }
  if (robot.straight)
    mover.from_velocity = mover.to_velocity = (now.position - before.position) / duration;
  return mover;
}

MovingDisc newcomer(const CheckedRobot& robot, std::size_t disc, const CheckedState& now) {
  const Vec2 center = center_of(robot, now, disc);
  MovingDisc mover{center,       now.velocity, center,
                   now.velocity, robot.radius, robot.interpolation_error,
                   now.robot};
  mover.newcomer = true;
  return mover;
}

PlacedObstacle place_of(const CheckedMover& obstacle, double time) {
  const double t = time;
  return {obstacle.position + t * (obstacle.velocity + (0.5 * t) * obstacle.acceleration),
          obstacle.velocity + t * obstacle.acceleration};
}

MovingDisc obstacle_mover(const PlacedObstacle& from, const PlacedObstacle& to, double radius,
                          std::int64_t index) {
  MovingDisc mover{from.position, from.velocity, to.position, to.velocity, radius, 0.0, index};
  mover.obstacle = true;
  return mover;
}

RelativePath path_of(const MovingDisc& mover, double duration, Vec2 origin, std::size_t k,
                     std::size_t parts) {
  const Vec2 to = mover.to - origin;
  if (mover.newcomer) return {{to, to, to, to}};
  Span span = span_of(mover, duration, k, parts);
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

BoundingBox box_of(const MovingDisc& mover, std::size_t owner, double duration) {
  const std::size_t parts = mover.parts();
  const auto box_of_part = [&](std::size_t k) {
    return box_around(path_of(mover, duration, {}, k, parts).control, mover.radius, owner);
  };
  BoundingBox box = box_of_part(0);
  for (std::size_t k = 1; k < parts; ++k) box = hull(box, box_of_part(k));
  return box;
}

double speed_bound(const MovingDisc& mover, double from_fraction, double to_fraction,
                   double duration) {
  if (mover.newcomer) return norm(mover.to_velocity);
  const auto parts = static_cast<double>(mover.parts());
  const auto last = mover.parts() - 1;
  const auto part_at = [&](double fraction) {
    return std::min(static_cast<std::size_t>(parts * fraction), last);
  };
  double most = 0.0;
  for (std::size_t k = part_at(from_fraction); k <= part_at(to_fraction); ++k) {
    const double from = std::max(parts * from_fraction - static_cast<double>(k), 0.0);
    const double to = std::min(parts * to_fraction - static_cast<double>(k), 1.0);
    most = std::max(most, speed_within(own_span(mover, k), from, to, duration / parts));
  }
  return most;
}

}  // namespace avo::judge
