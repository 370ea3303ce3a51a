// SPDX-License-Identifier: Apache-2.0
#include "guidance/places.h"

#include <algorithm>
#include <cmath>

#include "guidance/crowd.h"
#include "guidance/routes.h"
#include "walls/segment.h"

namespace avo::inline guidance {
namespace {

// The point at that distance from one point towards another.
Vec2 point_towards(Vec2 from, Vec2 to, double length) {
  const Vec2 line = to - from;
  const double distance = norm(line);
  return distance > 0.0 ? from + (length / distance) * line : from;
}

double place_reach(const Resting& other) {
  return (1.0 + kPlaceGap) * other.reach;
}

// The free place in sight of least cost. The cost is the distance from the place to the next point
// of the route, the goal or a corner. A part of the distance to the place is added. Where the next
// point is taken, the nearest free place lies on a circle around a robot at rest. It is where the
// circle is nearest to the next point, where it meets another circle or a wall, or where it is last
// seen.
class PlaceSearch {
 public:
  PlaceSearch(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls)
      : seeker_(seeker),
        resting_(occupied.resting),
        worth_(occupied.worth),
        walls_(walls),
        best_(seeker.position) {
    const double gain = (seeker.has_stood ? kGainAtRest : kGain) * seeker.radius;
    cost_ = norm(seeker.next - seeker.position) - gain;
  }

  // Places only get better, so that a robot that is not worth a test never will be.
  Vec2 best() && {
    worth_.clear();
    if (seeker_.next != seeker_.goal) try_place(seeker_.next);
    for (std::size_t i = 0; i < resting_.size(); ++i) {
      const Resting& other = resting_[i];
      if (!may_be_worth(other)) continue;
      const double reach = place_reach(other);
      if (std::sqrt(other.from_next_squared) < cost_ + reach) try_circle(other, reach);
      worth_.push_back(static_cast<std::uint32_t>(i));
    }
    return best_;
  }

 private:
  // Tries the points where the circle is nearest to the next point, is last seen, or meets earlier
  // circles, or a wall.
  void try_circle(const Resting& other, double reach) {
    try_place(point_towards(other.position, seeker_.next, reach));
    try_tangents(other);
    std::size_t kept = 0;
    for (const std::uint32_t k : worth_) {
      const Resting& before = resting_[k];
      if (!may_be_worth(before)) continue;
      worth_[kept++] = k;
      try_crossings(other, before);
    }
    worth_.resize(kept);
    for (const Wall& wall : walls_) try_beside(other, wall);
  }

  // Returns whether a place on its circle may be better, for any rounding.
  bool may_be_worth(const Resting& other) const {
    const double most = (1.0 + kRoundedOff) * (cost_ + place_reach(other));
    return other.from_next_squared <= most * most;
  }

  void try_tangents(const Resting& other) {
    const Vec2 line = other.position - seeker_.position;
    const double d2 = norm_squared(line), reach = place_reach(other);
    const double square = d2 - reach * reach;
    if (!(square > 0.0)) return;
    const Vec2 along = (square / d2) * line;
    const Vec2 across = (reach * std::sqrt(square) / d2) * perpendicular(line);
    try_place(seeker_.position + along + across);
    try_place(seeker_.position + along - across);
  }

  void try_crossings(const Resting& first, const Resting& second) {
    const Vec2 between = second.position - first.position;
    const double d2 = norm_squared(between), a = place_reach(first), b = place_reach(second);
    if (!(d2 > 0.0) || d2 >= (a + b) * (a + b) || d2 <= (a - b) * (a - b)) return;
    const double along = (d2 + a * a - b * b) / (2.0 * d2);
    const double across = std::sqrt(std::max(a * a / d2 - along * along, 0.0));
    const Vec2 foot = first.position + along * between;
    try_place(foot + across * perpendicular(between));
    try_place(foot - across * perpendicular(between));
  }

  void try_beside(const Resting& other, const Wall& wall) {
    const Vec2 along = wall.b - wall.a;
    const double length = norm(along), reach = place_reach(other);
    if (!(length > 0.0)) return;
    const Vec2 across = perpendicular(along / length);
    const double contact = (1.0 + kRoundedOff) * (seeker_.radius + wall.radius);
    for (const double side : {-contact, contact}) {
      const double off = side - dot(other.position - wall.a, across);
      const double square = reach * reach - off * off;
      if (!(square > 0.0)) continue;
      const Vec2 foot = other.position + off * across;
      try_place(foot + (std::sqrt(square) / length) * along);
      try_place(foot - (std::sqrt(square) / length) * along);
    }
  }

  void try_place(Vec2 place) {
    const double left = norm(place - seeker_.next);
    if (!(left < cost_)) return;
    const double cost = left + kWorth * norm(place - seeker_.position);
    if (!(cost < cost_) || !is_free(place)) return;
    cost_ = cost, best_ = place;
  }

  // A robot in contact with a robot at rest, or a wall, may leave it.
  static bool is_clear(double on_line, double needed, double before) {
    return on_line >= std::min(needed, (1.0 - kRoundedOff) * before);
  }

  bool is_free_of(const Resting& other, const Segment& line) const {
    return norm(line.b - other.position) >= (1.0 - kRoundedOff) * place_reach(other) &&
           is_clear(distance(other.position, line), (1.0 + kLineGap) * other.reach,
                    norm(seeker_.position - other.position));
  }

  // A robot that blocks the line to a place often blocks the line to the next one.
  bool is_free(Vec2 place) {
    const Segment line{seeker_.position, place};
    if (!is_free_of(resting_[blocker_], line)) return false;
    for (std::size_t k = 0; k < resting_.size(); ++k) {
      if (is_free_of(resting_[k], line)) continue;
      blocker_ = k;
      return false;
    }
    return std::all_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
      const Segment segment{wall.a, wall.b};
      const double contact = seeker_.radius + wall.radius;
      return distance(place, segment) >= contact &&
             is_clear(distance(line, segment), contact, distance(seeker_.position, segment));
    });
  }

  const Seeker& seeker_;
  std::span<const Resting> resting_;
  std::vector<std::uint32_t>& worth_;  // the elements of resting_ so far that were worth a test
  std::span<const Wall> walls_;
  Vec2 best_;
  double cost_ = 0.0;        // m
  std::size_t blocker_ = 0;  // the last place that was found
};

void note(const Seeker& seeker, Vec2 position, Vec2 velocity, double radius, Occupied& seen) {
  const double reach = seeker.radius + radius;
  const double distance = norm(position - seeker.position);
  if (!(distance <= std::max(seeker.range, kBesideReach * reach))) return;
  const Vec2 out = position - seeker.goal;
  if (norm(velocity) <= kStill * seeker.max_speed) {
    seen.resting.push_back(
        {position, reach, norm_squared(out), norm_squared(position - seeker.next)});
    seen.is_on_goal = seen.is_on_goal || stands_on_goal(seen.resting.back());
    seen.is_near = seen.is_near || distance - reach <= kNearResting * seeker.radius;
  }
  if (distance >= kBesideReach * reach) return;
  const double from_goal = norm(out);
  seen.comes_out =
      seen.comes_out || (from_goal < norm(seeker.position - seeker.goal) &&
                         dot(velocity, out) > kComesOut * seeker.max_speed * from_goal);
}

}  // namespace

void Occupied::add(const Seeker& seeker, const Neighbor& neighbor) {
  has_movers = has_movers || is_predicted(neighbor);
  note(seeker, neighbor.position, neighbor.velocity, neighbor.radius, *this);
}

void Occupied::add(const Seeker& seeker, const Neighbors& neighbors) {
  const NeighborColumns& columns = *neighbors.columns;
  const std::size_t first = neighbors.first, last = first + neighbors.count;
  for (std::size_t k = first; k < last && columns.has_movers && !has_movers; ++k)
    has_movers = columns.is_predicted(k);
  const double *x = columns.x.data(), *y = columns.y.data(), *radius = columns.radius.data();
  const double *v_x = columns.v_x.data(), *v_y = columns.v_y.data();
  for (std::size_t k = first; k < last; ++k)
    note(seeker, {x[k], y[k]}, {v_x[k], v_y[k]}, radius[k], *this);
}

Vec2 place_near(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls) {
  if (!is_taken(occupied)) return seeker.next;
  return PlaceSearch(seeker, occupied, walls).best();
}

bool is_at_crowd(const Seeker& seeker, Occupied& occupied, const Routes* routes) {
  const auto first = occupied.resting.begin(), last = occupied.resting.end();
  if (!occupied.is_on_goal) return false;
  const auto leads_on = [routes](Vec2 from, double reach) {
    return [routes, from, reach](const Resting& next) {
      return norm(next.position - from) < reach + next.reach &&
             (routes == nullptr || routes->is_in_sight(from, next.position));
    };
  };
  // reach is the sum of two radii: so two robots leave room for one seeker between their surfaces
  return leads_to_goal(first, last, leads_on(seeker.position, 2.0 * seeker.radius),
                       [&](const Resting& one) { return leads_on(one.position, one.reach); });
}

Vec2 place_of(const Seeker& seeker, const Occupied& occupied, std::span<const Wall> walls,
              bool stays, Detour& detour) {
  const Vec2 place = place_near(seeker, occupied, walls);
  detour.goal_taken = place != seeker.goal && is_taken(occupied) && !occupied.comes_out;
  return stays ? seeker.position : place;
}

}  // namespace avo::inline guidance
