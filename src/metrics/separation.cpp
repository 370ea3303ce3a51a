// SPDX-License-Identifier: Apache-2.0
#include "metrics/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "avo/velocity_obstacle.h"
#include "check/wall_path.h"
#include "core/elementary.h"

namespace avo::inline metrics {
namespace {

StepPath relative_path(const StepPath& a, const StepPath& b) {
  StepPath path;
  for (std::size_t k = 0; k < 4; ++k) path.control[k] = a.control[k] - b.control[k];
  return path;
}

// Returns whether the hull of the path ends at the line through that end perpendicular to the
// direction from the origin. Then no point of the path is nearer. This holds for most pairs, which
// approach each other or part.
bool is_nearest(const StepPath& path, Vec2 end) {
  const double square = norm_squared(end);
  return std::all_of(path.control.begin(), path.control.end(),
                     [&](Vec2 point) { return dot(end, point) >= square; });
}

Vec2 point_at(const StepPath& path, double u) {
  const double q = 1.0 - u;
  const auto& b = path.control;
  return (q * q * q) * b[0] + (3.0 * q * q * u) * b[1] + (3.0 * q * u * u) * b[2] +
         (u * u * u) * b[3];
}

// The chord of an arc that turns by twice that angle, divided by the arc's length: sin x/x.
double chord_of_arc(double half_turn) {
  return std::abs(half_turn) < 1e-8 ? 1.0 : elementary::sin(half_turn) / half_turn;
}

Vec2 point_at(const ArcPath& path, double part) {
  const double half = 0.5 * part * path.turn;
  const double chord = part * path.length * chord_of_arc(half);
  return path.position + chord * elementary::direction(path.heading + half);
}

// The cubic that touches the arc at both ends and in the middle. `from` and `to` are parts of its
// length.
StepPath cubic_along(const ArcPath& path, double from, double to) {
  const double length = (to - from) * path.length, turn = (to - from) * path.turn;
  const Vec2 quarter = elementary::direction(0.25 * turn);
  const double lever =
      std::abs(turn) < 1e-8 ? length / 3.0 : 4.0 / 3.0 * (quarter.y / quarter.x) * length / turn;
  const auto tangent = [&](double part) {
    return lever * elementary::direction(path.heading + part * path.turn);
  };
  const Vec2 first = point_at(path, from), last = point_at(path, to);
  return {{first, first + tangent(from), last - tangent(to), last}};
}

// The distance of a point from the segment's line, with a sign, over the step.
struct Height {
  const ResponsePath& path;
  const Segment& segment;
  Vec2 normal;  // unit

  [[nodiscard]] Vec2 place(double t) const {
    return path.position + t * path.velocity + path.response.gain(t) * path.w;
  }
  [[nodiscard]] double at(double t) const { return dot(normal, place(t) - segment.a); }
  [[nodiscard]] double rate(double t) const {
    return dot(normal, path.velocity) + path.response.rate(t) * dot(normal, path.w);
  }
  [[nodiscard]] bool is_beside(double t) const {
    const Vec2 along = segment.b - segment.a;
    const double part = dot(along, place(t) - segment.a);
    return part >= 0.0 && part <= dot(along, along);
  }
};

// s: where a value that rises or falls all the time changes its sign; `high` where it does not.
template <typename Value>
double sign_change(const Value& value, double low, double high) {
  const bool starts_below = value(low) < 0.0;
  if ((value(high) < 0.0) == starts_below) return high;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    ((value(half) < 0.0) == starts_below ? low : high) = half;
  }
  return high;
}

}  // namespace

StepPath hermite_path(Vec2 position, Vec2 velocity, Vec2 next_position, Vec2 next_velocity,
                      double time_step) {
  const double third = time_step / 3.0;
  return {{position, position + third * velocity, next_position - third * next_velocity,
           next_position}};
}

ArcPath arc_path(Vec2 position, Vec2 next_position, double turn) {
  const Vec2 chord = next_position - position;
  const double heading = elementary::atan2(chord.y, chord.x) - 0.5 * turn;
  return {position, heading, turn, norm(chord) / chord_of_arc(0.5 * turn)};
}

StepPath hermite_path(const ArcMotion& arc, double time_step) {
  const auto& [path, speed, next_speed] = arc;
  const double half_turn = 0.5 * path.turn, chord = path.length * chord_of_arc(half_turn);
  const Vec2 next = path.position + chord * elementary::direction(path.heading + half_turn);
  // in proportion to the robot's speed all the time
  const double lever = path.length / (0.5 * (speed + next_speed) * time_step);
  return hermite_path(path.position, lever * speed * elementary::direction(path.heading), next,
                      lever * next_speed * elementary::direction(path.heading + path.turn),
                      time_step);
}

StepPath part_of(const StepPath& path, double from, double to) {
  const Vec2 first = point_at(path, from), last = point_at(path, to);
  const auto velocity_at = [&](double u) {
    const double q = 1.0 - u;
    const auto& b = path.control;
    return 3.0 *
           ((q * q) * (b[1] - b[0]) + (2.0 * q * u) * (b[2] - b[1]) + (u * u) * (b[3] - b[2]));
  };
  return hermite_path(first, velocity_at(from), last, velocity_at(to), to - from);
}

ArcMotion part_of(const ArcMotion& arc, double from, double to) {
  const double speed = arc.speed, next_speed = arc.next_speed;
  const ArcPath& path = arc.path;
  const auto speed_at = [&](double u) { return speed + u * (next_speed - speed); };
  const auto covered_at = [&](double u) {  // part of the path
    return u * (speed + speed_at(u)) / (speed + next_speed);
  };
  const double first = covered_at(from), part = covered_at(to) - first;
  return {{point_at(path, first), path.heading + first * path.turn, part * path.turn,
           part * path.length},
          speed_at(from),
          speed_at(to)};
}

judge::Instant separation(const StepPath& a, const StepPath& b, double cutoff) {
  const StepPath path = relative_path(a, b);
  const judge::Instant first{0.0, norm(path.control[0])}, last{1.0, norm(path.control[3])};
  if (is_nearest(path, path.control[0])) return first;
  if (is_nearest(path, path.control[3])) return last;
  if (judge::lower_bound(path) > cutoff) return last.distance < first.distance ? last : first;
  return judge::nearest_instant(path);
}

double separation(const StepPath& path, const Segment& segment, double cutoff) {
  const StepPath at_start{{segment.a, segment.a, segment.a, segment.a}};
  const judge::WallPath wall{relative_path(path, at_start), segment.b - segment.a};
  if (judge::lower_bound(wall) > cutoff)
    return std::min(distance(path.control[0], segment), distance(path.control[3], segment));
  return judge::nearest_instant(wall).distance;
}

// The nearest point of the segment is an end, or the path is beside the segment there. Then its
// distance from the line is least: at an end of the step, where it turns, or where it is zero.
double separation(const ResponsePath& path, const Segment& segment) {
  const auto from = [&path](Vec2 end) {
    const Obstacle obstacle{
        {path.position - end, path.velocity, 0.0}, path.response, path.time_step};
    return closest_approach(obstacle, path.velocity + path.w).distance;
  };
  double least = from(segment.a);
  const Vec2 along = segment.b - segment.a;
  const double length = norm(along);
  if (!(length > 0.0)) return least;
  least = std::min(least, from(segment.b));
  const Height height{path, segment, perpendicular(along) / length};
  const double end = path.time_step;
  const double turn = sign_change([&](double t) { return height.rate(t); }, 0.0, end);
  const auto is_zero = [&](double low, double high) {
    return sign_change([&](double t) { return height.at(t); }, low, high);
  };
  for (const double t : {0.0, is_zero(0.0, turn), turn, is_zero(turn, end), end})
    if (height.is_beside(t)) least = std::min(least, std::abs(height.at(t)));
  return least;
}

double separation(const ArcPath& path, const Segment& segment, double cutoff) {
  constexpr double kMostTurn = 0.1;  // rad: the error grows with its sixth power
  const double parts = std::max(1.0, std::ceil(std::abs(path.turn) / kMostTurn));
  double least = std::numeric_limits<double>::infinity();
  for (double k = 0.0; k < parts; k += 1.0) {
    const StepPath part = cubic_along(path, k / parts, (k + 1.0) / parts);
    least = std::min(least, separation(part, segment, std::min(cutoff, least)));
  }
  return least;
}

std::optional<double> first_below(const StepPath& a, const StepPath& b, double distance) {
  return judge::first_below(relative_path(a, b), distance);
}

}  // namespace avo::inline metrics
