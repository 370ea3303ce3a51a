// SPDX-License-Identifier: Apache-2.0
#include "space/routes/tighten.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace avo::space {
namespace {

constexpr double kSightRounding = 1e-9;  // of the room
constexpr int kSweeps = 6;
constexpr int kPulls = 8;
constexpr double kSharp = 0.95;   // cosine of a bend that is split
constexpr double kSplit = 0.3;    // of the room, from the bend to both points
constexpr double kLittle = 1e-4;  // of the length: less is not worth another sweep

void leave_out(const Solids& solids, const SpaceRoutePoint& from,
               std::vector<SpaceRoutePoint>& points) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (is_free_between(solids, kept == 0 ? from : points[kept - 1], points[k + 1])) continue;
    points[kept++] = points[k];
  }
  points[kept++] = points.back();
  points.resize(kept);
}

/// A bend of the route and its neighbors.
struct Bend {
  SpaceRoutePoint before;
  SpaceRoutePoint& at;
  SpaceRoutePoint after;
};

// Moves the bend as far towards the place as the route stays clear and gets shorter.
void move_towards(const Solids& solids, double most_room, Vec3 target, const Bend& bend) {
  const Vec3 start = bend.at.place;
  const auto sum = [&](Vec3 p) { return norm(p - bend.before.place) + norm(bend.after.place - p); };
  double moved = 0.0, step = 1.0;
  for (int k = 0; k < kPulls; ++k) {
    const double part = moved + step;
    step *= 0.5;
    if (part > 1.0) continue;
    const Vec3 place = start + part * (target - start);
    const SpaceRoutePoint point{place, std::min(bend.at.room, room_at(solids, place, most_room))};
    if (!(sum(place) < sum(bend.at.place)) || point.room < bend.at.room ||
        !is_free_between(solids, bend.before, point) || !is_free_between(solids, point, bend.after))
      continue;
    bend.at = point, moved = part;
  }
}

// The place of a line through the bend from which both neighbors are nearest together.
Vec3 nearest_on_line(const Bend& bend, Vec3 direction) {
  const Vec3 a = bend.before.place - bend.at.place, c = bend.after.place - bend.at.place;
  const double at_a = dot(a, direction), at_c = dot(c, direction);
  const double off_a = norm(a - at_a * direction), off_c = norm(c - at_c * direction);
  if (!(off_a + off_c > 0.0)) return bend.at.place;
  return bend.at.place + ((at_a * off_c + at_c * off_a) / (off_a + off_c)) * direction;
}

// Towards the straight line, and where a box is in between, along its surface.
void pull(const Solids& solids, double most_room, const Bend& bend) {
  const Vec3 chord = bend.after.place - bend.before.place;
  const double squared = norm_squared(chord);
  if (!(squared > 0.0)) return;
  const Vec3 off = bend.at.place - bend.before.place;
  const double part = std::clamp(dot(off, chord) / squared, 0.0, 1.0);
  move_towards(solids, most_room, bend.before.place + part * chord, bend);
  const Vec3 a = bend.before.place - bend.at.place, c = bend.after.place - bend.at.place;
  const double length_a = norm(a), length_c = norm(c);
  const Away near = solids.away(bend.at.place, 2.0 * most_room);
  if (!(length_a > 0.0) || !(length_c > 0.0) || near.normal == Vec3{}) return;
  const Vec3 inwards = a / length_a + c / length_c;
  const Vec3 along = inwards - dot(inwards, near.normal) * near.normal;
  // across the surface and the bend: along an edge
  const Vec3 edge = cross(near.normal, cross(a, c));
  for (const Vec3 line : {along, cross(near.normal, along), edge}) {
    const double length = norm(line);
    if (length > 0.0) move_towards(solids, most_room, nearest_on_line(bend, line / length), bend);
  }
}

}  // namespace

double route_length(Vec3 from, std::span<const SpaceRoutePoint> points) {
  double length = 0.0;
  for (const SpaceRoutePoint& point : points)
    length += norm(point.place - from), from = point.place;
  return length;
}

bool is_free_between(const Solids& solids, const SpaceRoutePoint& a, const SpaceRoutePoint& b) {
  return solids.is_clear(a.place, b.place, (1.0 - kSightRounding) * std::min(a.room, b.room));
}

namespace {

void sweep_all(const Solids& solids, const SpaceRoutePoint& from, double most_room,
               std::vector<SpaceRoutePoint>& points) {
  double length = route_length(from.place, points);
  for (int sweep = 0; sweep < kSweeps && points.size() > 1; ++sweep) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      pull(solids, most_room, {k == 0 ? from : points[k - 1], points[k], points[k + 1]});
    leave_out(solids, from, points);
    const double shorter = route_length(from.place, points);
    if (!(shorter < (1.0 - kLittle) * length)) break;
    length = shorter;
  }
}

// Two points for each sharp bend, on both legs: so that the route leads round an edge.
void split(const SpaceRoutePoint& from, double most_room, std::vector<SpaceRoutePoint>& points) {
  std::vector<SpaceRoutePoint> more;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 at = points[k].place;
    const Vec3 before = (k == 0 ? from.place : points[k - 1].place) - at;
    const Vec3 after = k + 1 < points.size() ? points[k + 1].place - at : Vec3{};
    const double lengths = norm(before) * norm(after);
    if (!(lengths > 0.0) || dot(before, after) < -kSharp * lengths) {
      more.push_back(points[k]);
      continue;
    }
    for (const Vec3 leg : {before, after}) {
      const double part = std::min(0.5, kSplit * most_room / norm(leg));
      more.push_back({at + part * leg, points[k].room});
    }
  }
  points = std::move(more);
}

}  // namespace

void tighten(const Solids& solids, const SpaceRoutePoint& from, double most_room,
             std::vector<SpaceRoutePoint>& points) {
  if (points.empty()) return;
  leave_out(solids, from, points);
  sweep_all(solids, from, most_room, points);
  split(from, most_room, points);
  sweep_all(solids, from, most_room, points);
}

}  // namespace avo::space
