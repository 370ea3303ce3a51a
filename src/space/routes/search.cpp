// SPDX-License-Identifier: Apache-2.0
// A* among the places of free cells. A point takes the point before its neighbor, as if it saw that
// point, and only a point that is settled is tested for it. This is Lazy Theta*. Nash, Koenig and
// Tovey: "Lazy Theta*: Any-Angle Path Planning and Path Length Analysis in 3D", AAAI 2010.
#include "space/routes/search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "space/routes/tighten.h"

namespace avo::space {
namespace {

constexpr int kSeesAround = 3;  // cells around a place, in which a place in sight is looked for
constexpr int kSlides = 20;     // bisections of the last piece, to a goal that is not free

class RouteSearch {
 public:
  RouteSearch(const FreeCells& cells, const Solids& solids, const SpaceRoutePoint& from,
              const SpaceRoutePoint& goal, RouteScratch& scratch)
      : cells_(cells),
        solids_(solids),
        from_(from),
        goal_(goal),
        scratch_(scratch),
        start_(static_cast<std::uint32_t>(cells.grid().size())),
        end_(start_ + 1) {
    if (scratch_.reached.size() < end_ + std::size_t{1}) {
      scratch_.reached.assign(end_ + std::size_t{1}, {});
      scratch_.search = 0;
    }
    ++scratch_.search;
    scratch_.open.clear();
  }

  // Requires that the start and a door are in one part.
  std::vector<SpaceRoutePoint> run(const std::vector<std::uint32_t>& seeds) {
    reach(start_, start_, 0.0);
    scratch_.reached[start_].is_settled = true;
    for (const std::uint32_t cell : seeds) offer(cell, start_);
    while (!scratch_.open.empty()) {
      std::pop_heap(scratch_.open.begin(), scratch_.open.end(), std::greater<>());
      const std::uint32_t point = scratch_.open.back().second;
      scratch_.open.pop_back();
      if (scratch_.reached[point].is_settled) continue;
      settle(point);
      if (point == end_) break;
      const std::uint32_t before = scratch_.reached[point].from;
      cells_.for_each_joined(point, [&](std::uint32_t next) { offer(next, before); });
      if (is_door(point)) offer(end_, before);
    }
    return is_reached(end_) ? points() : std::vector<SpaceRoutePoint>{};
  }

 private:
  [[nodiscard]] bool is_reached(std::uint32_t point) const {
    return scratch_.reached[point].search == scratch_.search;
  }
  [[nodiscard]] bool is_settled(std::uint32_t point) const {
    return is_reached(point) && scratch_.reached[point].is_settled;
  }
  [[nodiscard]] bool is_door(std::uint32_t cell) const {
    return std::binary_search(scratch_.doors.begin(), scratch_.doors.end(), cell);
  }
  [[nodiscard]] SpaceRoutePoint point_of(std::uint32_t point) const {
    if (point == start_) return from_;
    return point == end_ ? goal_ : SpaceRoutePoint{cells_.place(point), cells_.room(point)};
  }
  [[nodiscard]] Vec3 place(std::uint32_t point) const {
    return point == start_ ? from_.place : point == end_ ? goal_.place : cells_.place(point);
  }
  void reach(std::uint32_t point, std::uint32_t before, double length) {
    scratch_.reached[point] = {length, before, scratch_.search, false};
  }

  void offer(std::uint32_t point, std::uint32_t before) {
    if (is_settled(point)) return;
    const double length = scratch_.reached[before].length + norm(place(point) - place(before));
    if (is_reached(point) && !(length < scratch_.reached[point].length)) return;
    reach(point, before, length);
    scratch_.open.emplace_back(length + norm(goal_.place - place(point)), point);
    std::push_heap(scratch_.open.begin(), scratch_.open.end(), std::greater<>());
  }

  // A point that does not see the point before it takes the best of its settled neighbors.
  void settle(std::uint32_t point) {
    RouteScratch::Reached& reached = scratch_.reached[point];
    if (!is_free_between(solids_, point_of(reached.from), point_of(point))) {
      reached.length = std::numeric_limits<double>::infinity();
      const auto consider = [&](std::uint32_t other) {
        if (!is_settled(other)) return;
        const double length = scratch_.reached[other].length + norm(place(point) - place(other));
        if (length < reached.length) reached.length = length, reached.from = other;
      };
      if (point == end_)
        for (const std::uint32_t door : scratch_.doors) consider(door);
      else
        cells_.for_each_joined(point, consider);
    }
    reached.is_settled = true;
  }

  [[nodiscard]] std::vector<SpaceRoutePoint> points() const {
    std::vector<SpaceRoutePoint> points;
    for (std::uint32_t point = end_; point != start_; point = scratch_.reached[point].from)
      points.push_back(point_of(point));
    std::reverse(points.begin(), points.end());
    return points;
  }

  const FreeCells& cells_;
  const Solids& solids_;
  SpaceRoutePoint from_, goal_;
  RouteScratch& scratch_;
  std::uint32_t start_, end_;
};

// The cells around a place to which a straight line leads, in ascending order.
std::vector<std::uint32_t> seen_from(const FreeCells& cells, const Solids& solids,
                                     const SpaceRoutePoint& point, int around) {
  std::vector<std::uint32_t> seen;
  cells.for_each_around(point.place, around, [&](std::uint32_t cell) {
    if (is_free_between(solids, point, {cells.place(cell), cells.room(cell)})) seen.push_back(cell);
  });
  return seen;
}

bool is_of_part(const FreeCells& cells, std::uint32_t cell,
                const std::vector<std::uint32_t>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](std::uint32_t other) { return cells.part(other) == cells.part(cell); });
}

// The cell with the place nearest to the goal, of the parts of others.
std::uint32_t nearest_of(const FreeCells& cells, const std::vector<std::uint32_t>& others,
                         Vec3 goal) {
  std::uint32_t nearest = others.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t cell = 0; cell < cells.grid().size(); ++cell) {
    const double squared = norm_squared(cells.place(cell) - goal);
    if (cells.room(cell) == 0.0 || !(squared < least) || !is_of_part(cells, cell, others)) continue;
    least = squared, nearest = cell;
  }
  return nearest;
}

// From a place straight towards a goal that is not free, as far as the robot gets.
SpaceRoutePoint slid(const Solids& solids, const SpaceRoutePoint& from, Vec3 goal) {
  double free = 0.0, blocked = 1.0;
  for (int k = 0; k < kSlides; ++k) {
    const double part = 0.5 * (free + blocked);
    const Vec3 place = from.place + part * (goal - from.place);
    (solids.is_clear(from.place, place, from.room) ? free : blocked) = part;
  }
  return {from.place + free * (goal - from.place), from.room};
}

}  // namespace

double room_at(const Solids& solids, Vec3 place, double most) {
  return std::max(0.0, std::min(most, solids.away(place, most).distance));
}

FoundRoute find_route(const FreeCells& cells, const Solids& solids, Vec3 from, Vec3 goal,
                      double radius, RouteScratch& scratch) {
  const double most = cells.most_room();
  const SpaceRoutePoint start{from, room_at(solids, from, most)};
  SpaceRoutePoint end{goal, room_at(solids, goal, most)};
  FoundRoute route;
  route.is_in_box = !(end.room >= kLeastRoom * radius);
  std::vector<std::uint32_t> seeds;
  scratch.doors.clear();
  // a cell beside a robot that is squeezed may be a part of its own
  for (int around = 1; around <= kSeesAround && scratch.doors.empty(); ++around) {
    seeds = seen_from(cells, solids, start, around);
    if (route.is_in_box && !seeds.empty()) break;
    if (!route.is_in_box) scratch.doors = seen_from(cells, solids, end, around);
    std::erase_if(scratch.doors,
                  [&](std::uint32_t door) { return !is_of_part(cells, door, seeds); });
  }
  if (seeds.empty()) return route;
  route.reaches = !scratch.doors.empty();
  if (!route.reaches) {
    const std::uint32_t nearest = nearest_of(cells, seeds, goal);
    end = slid(solids, {cells.place(nearest), kLeastRoom * radius}, goal);
    scratch.doors.assign(1, nearest);
  }
  route.points = RouteSearch(cells, solids, start, end, scratch).run(seeds);
  tighten(solids, start, most, route.points);
  return route;
}

}  // namespace avo::space
