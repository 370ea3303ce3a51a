// SPDX-License-Identifier: Apache-2.0
// Distances in continuous time over one step: paths are halved until the hulls of their parts
// suffice.
#include "metrics/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"

namespace avo::inline metrics {
namespace {

// A piece of a path, in the hull of these points from its start to its end, with its fractions of
// the step.
struct Piece {
  std::array<Vec2, 4> b;
  double from, to;
};

Vec2 middle(Vec2 a, Vec2 b) {
  return 0.5 * (a + b);
}

std::array<Piece, 2> halve_cubic(const Piece& piece) {
  const auto& b = piece.b;
  const Vec2 b01 = middle(b[0], b[1]), b12 = middle(b[1], b[2]), b23 = middle(b[2], b[3]);
  const Vec2 b012 = middle(b01, b12), b123 = middle(b12, b23);
  const Vec2 center = middle(b012, b123);
  const double half = 0.5 * (piece.from + piece.to);
  return {
      {{{b[0], b01, b012, center}, piece.from, half}, {{center, b123, b23, b[3]}, half, piece.to}}};
}

// g is convex: the path lies between its chord and its tangents.
Piece piece_of(const ResponsePath& path, double from, double to) {
  const double start = from * path.time_step, end = to * path.time_step;
  const auto at = [&path](double t) {
    return path.position + t * path.velocity + path.response.gain(t) * path.w;
  };
  const Vec2 first = at(start), last = at(end);
  const Vec2 velocity = path.velocity + path.response.rate(start) * path.w;
  return {{first, first + (end - start) * velocity, last, last}, from, to};
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

// An arc lies between its chord and its tangents; `from` and `to` are parts of its length.
Piece piece_of(const ArcPath& path, double from, double to) {
  const Vec2 first = point_at(path, from), last = point_at(path, to);
  const double half = 0.5 * (to - from) * path.turn;
  const double tangent =
      0.5 * (to - from) * path.length * chord_of_arc(half) / elementary::direction(half).x;
  const Vec2 apex = first + tangent * elementary::direction(path.heading + from * path.turn);
  return {{first, apex, apex, last}, from, to};
}

// A curve lies in the hull of its control points. So in any direction no point of it is nearer to
// the origin than they are. The direction of its middle makes the bound sharp to second order.
double lower_bound(const Piece& piece) {
  const Vec2 towards = piece.b[0] + piece.b[3];
  const double length = norm(towards);
  if (!(length > 0.0)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 point : piece.b) least = std::min(least, dot(towards, point));
  return least / length;
}

// The better one of two bounds. The whole piece is as near to its chord as the points of its hull
// are. In the direction from the segment to the chord, no point of the piece is nearer than theirs.
// This is exact for a motion along the segment; but for two that nearly touch, rounding hides the
// direction.
double lower_bound(const Piece& piece, const Segment& segment) {
  const Segment chord{piece.b[0], piece.b[3]};
  const auto [on_chord, foot, apart] = nearest_points(chord, segment);
  const double off = std::max(distance(piece.b[1], chord), distance(piece.b[2], chord));
  if (!(apart > off)) return 0.0;
  const Vec2 along = segment.b - segment.a, away = on_chord - foot;
  Vec2 direction = away / apart;
  if (foot != segment.a && foot != segment.b) {
    direction = perpendicular(along) / norm(along);
    if (dot(direction, away) < 0.0) direction = -1.0 * direction;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 point : piece.b) least = std::min(least, dot(direction, point - foot));
  const double most =
      std::max({0.0, dot(direction, segment.a - foot), dot(direction, segment.b - foot)});
  return std::max(least - most, apart - off);
}

// Returns whether its hull ends at the line through that end perpendicular to the direction from
// the origin. Then no point of the piece is nearer. This holds for most pairs, which approach each
// other or part.
bool is_nearest(const Piece& piece, Vec2 end) {
  const double square = norm_squared(end);
  return dot(end, piece.b[0]) >= square && dot(end, piece.b[1]) >= square &&
         dot(end, piece.b[2]) >= square && dot(end, piece.b[3]) >= square;
}

double size_of(const Piece& piece, Vec2 origin) {
  double size = 0.0;
  for (const Vec2 point : piece.b) size = std::max(size, norm(point - origin));
  return size;
}

// Least distance(point) of the path, to `resolution`; bound(piece) must not exceed the distance of
// any of its points.
template <typename Halves, typename Distance, typename Bound>
Separation least(const Piece& whole, const Halves& halve, const Distance& distance,
                 const Bound& bound, double cutoff, double resolution) {
  Separation best{distance(whole.b[0]), 0.0};
  const double at_end = distance(whole.b[3]);
  if (at_end < best.distance) best = {at_end, 1.0};
  // depth first, the nearer half first; a halving leaves one piece behind, so 64 are enough
  std::array<Piece, 64> stack;
  std::size_t count = 0;
  stack[count++] = whole;
  while (count > 0) {
    const Piece piece = stack[--count];
    if (bound(piece) >= std::min(best.distance, cutoff) - resolution) continue;
    if (count + 2 > stack.size()) continue;
    const auto [left, right] = halve(piece);
    const double at_half = distance(left.b[3]);
    if (at_half < best.distance) best = {at_half, left.to};
    const bool left_first = bound(left) < bound(right);
    stack[count++] = left_first ? right : left;
    stack[count++] = left_first ? left : right;
  }
  return best;
}

template <typename Halves>
double from_segment(const Piece& whole, const Halves& halve, const Segment& segment,
                    double cutoff) {
  const double size = std::max(size_of(whole, segment.a), size_of(whole, segment.b));
  return least(
             whole, halve, [&](Vec2 point) { return distance(point, segment); },
             [&](const Piece& piece) { return lower_bound(piece, segment); }, cutoff, 1e-13 * size)
      .distance;
}

template <typename Path>
auto halves_of(const Path& path) {
  return [&path](const Piece& piece) {
    const double half = 0.5 * (piece.from + piece.to);
    return std::array<Piece, 2>{piece_of(path, piece.from, half), piece_of(path, half, piece.to)};
  };
}

Piece relative_path(const StepPath& a, const StepPath& b) {
  Piece piece{{}, 0.0, 1.0};
  for (std::size_t k = 0; k < 4; ++k) piece.b[k] = a.control[k] - b.control[k];
  return piece;
}

Vec2 point_at(const Piece& piece, double u) {
  const double q = 1.0 - u;
  const auto& b = piece.b;
  return (q * q * q) * b[0] + (3.0 * q * q * u) * b[1] + (3.0 * q * u * u) * b[2] +
         (u * u * u) * b[3];
}

}  // namespace

StepPath hermite_path(Vec2 position, Vec2 velocity, Vec2 next_position, Vec2 next_velocity,
                      double time_step) {
  const double third = time_step / 3.0;
  return {{position, position + third * velocity, next_position - third * next_velocity,
           next_position}};
}

ArcPath arc_path(Vec2 position, Vec2 next_position, double turn) {
  const Vec2 way = next_position - position;
  const double heading = elementary::atan2(way.y, way.x) - 0.5 * turn;
  return {position, heading, turn, norm(way) / chord_of_arc(0.5 * turn)};
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
  const Vec2 first = point_at({path.control, 0.0, 1.0}, from),
             last = point_at({path.control, 0.0, 1.0}, to);
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

Separation separation(const StepPath& a, const StepPath& b, double cutoff) {
  const Piece whole = relative_path(a, b);
  if (is_nearest(whole, whole.b[0])) return {norm(whole.b[0]), 0.0};
  if (is_nearest(whole, whole.b[3])) return {norm(whole.b[3]), 1.0};
  return least(
      whole, halve_cubic, [](Vec2 point) { return norm(point); },
      [](const Piece& piece) { return lower_bound(piece); }, cutoff, 1e-13 * size_of(whole, {}));
}

double separation(const StepPath& path, const Segment& segment, double cutoff) {
  return from_segment({path.control, 0.0, 1.0}, halve_cubic, segment, cutoff);
}

double separation(const ResponsePath& path, const Segment& segment, double cutoff) {
  return from_segment(piece_of(path, 0.0, 1.0), halves_of(path), segment, cutoff);
}

double separation(const ArcPath& path, const Segment& segment, double cutoff) {
  return from_segment(piece_of(path, 0.0, 1.0), halves_of(path), segment, cutoff);
}

double first_below(const StepPath& a, const StepPath& b, double distance, double fraction) {
  const Piece whole = relative_path(a, b);
  if (norm(whole.b[0]) < distance) return 0.0;
  double low = 0.0, high = fraction;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    (norm(point_at(whole, half)) < distance ? high : low) = half;
  }
  return high;
}

}  // namespace avo::inline metrics
