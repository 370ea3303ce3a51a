// SPDX-License-Identifier: Apache-2.0
#include "sim/host/nearby.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/scene/assumptions.h"
#include "sim/world.h"
#include "walls/segment.h"

namespace avo::inline sim {
namespace {

// m: rays do not pass between two walls that have an end in common, nor along a wall.
constexpr double kThin = 1e-9;

using Ranked = std::pair<double, std::size_t>;  // m, from a point to the disc, and its rank

double distance_to(const Wall& disc, Vec2 p) {
  return norm(p - disc.a) - disc.radius;
}

void take_discs(const World& world, Nearby& nearby) {
  const Fleet& fleet = world.fleet;
  std::vector<Wall> discs;
  discs.reserve(fleet.size() + world.movers.setup.size());
  for (const std::uint32_t slot : fleet.slot_of)
    discs.push_back({fleet.position[slot], fleet.position[slot], fleet.traits[slot].radius});
  nearby.robots = discs.size();
  for (std::size_t k = 0; k < world.movers.setup.size(); ++k)
    discs.push_back(
        {world.movers.position[k], world.movers.position[k], world.movers.setup[k].radius});
  nearby.discs = ClearanceGrid(discs, 0.0);
}

void take_walls(const World& world, Nearby& nearby) {
  std::vector<Wall> walls;
  nearby.obstacle.clear();
  const std::vector<StaticObstacle>& obstacles = world.statics.obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const std::vector<Wall> own = walls_of(std::span(obstacles).subspan(k, 1));
    walls.insert(walls.end(), own.begin(), own.end());
    nearby.obstacle.resize(walls.size(), static_cast<std::uint32_t>(k));
  }
  nearby.walls = ClearanceGrid(walls, 0.0);
}

// The robots among the discs that come within the radius, each once.
std::vector<Ranked> within(const Nearby& nearby, Vec2 center, double radius) {
  std::vector<Ranked> found;
  const Vec2 reach{radius, radius};
  nearby.discs.all_in(center - reach, center + reach, [&](std::size_t k) {
    if (k < nearby.robots) {
      const double distance = distance_to(nearby.discs.walls()[k], center);
      if (distance <= radius) found.emplace_back(distance, k);
    }
    return true;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<std::size_t> ranks_of(const std::vector<Ranked>& found, std::size_t most) {
  std::vector<std::size_t> ranks;
  for (std::size_t k = 0; k < found.size() && k < most; ++k) ranks.push_back(found[k].second);
  return ranks;
}

// The part of the displacement at which a point comes within `room` of the other point; infinite
// where it does not.
double enters_disc(Vec2 from, Vec2 move, Vec2 center, double room) {
  const Vec2 away = from - center;
  const double a = norm_squared(move), b = dot(away, move), c = norm_squared(away) - room * room;
  if (c <= 0.0) return 0.0;
  const double root = b * b - a * c;
  if (!(b < 0.0 && root >= 0.0)) return std::numeric_limits<double>::infinity();
  return c / (std::sqrt(root) - b);
}

// The same of the wall's middle line: its ends, or one of its sides.
double enters(Vec2 from, Vec2 move, const Wall& wall, double room) {
  double first =
      std::min(enters_disc(from, move, wall.a, room), enters_disc(from, move, wall.b, room));
  const Vec2 along = wall.b - wall.a;
  const double length = norm(along);
  if (!(length > 0.0)) return first;
  if (distance(from, {wall.a, wall.b}) <= room) return 0.0;
  const Vec2 across{-along.y / length, along.x / length};
  const double side = dot(from - wall.a, across), speed = dot(move, across);
  const double part = (std::abs(side) - room) / std::abs(speed);
  if (!(side * speed < 0.0 && part >= 0.0)) return first;
  const double place = dot(from + part * move - wall.a, along) / (length * length);
  if (place >= 0.0 && place <= 1.0) first = std::min(first, part);
  return first;
}

// Which discs and walls a query counts.
struct Counted {
  const World& world;
  const Nearby& nearby;
  LayerSet layers;

  [[nodiscard]] bool disc(std::size_t k) const {
    if (layers == kAllLayers || k >= nearby.robots) return true;
    const Conduct& robot = world.fleet.conduct[world.fleet.slot_of[k]];
    return robot.behavior == Behavior::parked || (robot.layers.bits & layers.bits) != 0;
  }
  [[nodiscard]] bool wall(std::size_t k) const {
    return layers == kAllLayers || heeds(layers, world.statics.obstacles[nearby.obstacle[k]]);
  }
};

// The first of the grid's walls that the disc comes to touch, and the part of the displacement
// until then.
template <typename Counts>
std::pair<double, std::size_t> first_in(const ClearanceGrid& grid, Vec2 from, Vec2 move,
                                        double radius, const Counts& counts) {
  std::pair<double, std::size_t> first{std::numeric_limits<double>::infinity(), 0};
  const Vec2 reach{radius, radius}, to = from + move;
  const Vec2 low{std::min(from.x, to.x), std::min(from.y, to.y)};
  const Vec2 high{std::max(from.x, to.x), std::max(from.y, to.y)};
  const auto look = [&](std::size_t k) {
    const Wall& wall = grid.walls()[k];
    if (counts(k))
      first = std::min(first, {enters(from, move, wall, std::max(radius + wall.radius, kThin)), k});
    return true;
  };
  if (radius == 0.0)
    grid.all_near(from, to, look);
  else
    grid.all_in(low - reach, high + reach, look);
  return first;
}

}  // namespace

void look_at_walls(const World& world, Nearby& nearby) {
  // what throws in the midst is made anew
  if (!nearby.has_walls) take_walls(world, nearby);
  nearby.has_walls = true;
}

void look_around(const World& world, Nearby& nearby) {
  look_at_walls(world, nearby);
  if (!nearby.has_discs) take_discs(world, nearby);
  nearby.has_discs = true;
}

std::vector<std::size_t> robots_within(const Nearby& nearby, Vec2 center, double radius) {
  const std::vector<Ranked> found = within(nearby, center, radius);
  return ranks_of(found, found.size());
}

std::vector<std::size_t> nearest_robots(const Nearby& nearby, Vec2 position, std::size_t count) {
  const std::size_t wanted = std::min(count, nearby.robots);
  double radius = nearby.discs.side();  // m
  std::vector<Ranked> found;
  while (wanted > 0 && (found = within(nearby, position, radius)).size() < wanted) radius *= 2.0;
  return ranks_of(found, wanted);
}

bool is_free(const World& world, const Nearby& nearby, Vec2 position, double radius,
             LayerSet layers) {
  const Vec2 reach{radius, radius};
  const Counted counted{world, nearby, layers};
  const auto is_clear = [&](const ClearanceGrid& grid, const auto& counts) {
    return grid.all_in(position - reach, position + reach, [&](std::size_t k) {
      const Wall& wall = grid.walls()[k];
      return distance(position, {wall.a, wall.b}) > radius + wall.radius || !counts(k);
    });
  };
  if (!is_clear(nearby.discs, [&](std::size_t k) { return counted.disc(k); }) ||
      !is_clear(nearby.walls, [&](std::size_t k) { return counted.wall(k); }))
    return false;
  const std::vector<StaticObstacle>& obstacles = world.statics.obstacles;
  return std::all_of(obstacles.begin(), obstacles.end(), [&](const StaticObstacle& obstacle) {
    return !heeds(layers, obstacle) || leaves_room(position, obstacle);
  });
}

std::optional<Simulation::Hit> first_hit(const World& world, const Nearby& nearby, Vec2 from,
                                         Vec2 to, double radius, LayerSet layers) {
  const Vec2 move = to - from;
  const Counted counted{world, nearby, layers};
  const auto [disc_at, disc] =
      first_in(nearby.discs, from, move, radius, [&](std::size_t k) { return counted.disc(k); });
  const auto [wall_at, wall] =
      first_in(nearby.walls, from, move, radius, [&](std::size_t k) { return counted.wall(k); });
  const double first = std::min(disc_at, wall_at);
  if (!(first <= 1.0)) return std::nullopt;
  Simulation::Hit hit{.distance = first * norm(move), .center = from + first * move};
  if (wall_at < disc_at) {
    hit.obstacle = world.statics.id[nearby.obstacle[wall]];
  } else if (disc < nearby.robots) {
    hit.robot = world.fleet.id[world.fleet.slot_of[disc]];
  } else {
    hit.moving_obstacle = world.movers.id[disc - nearby.robots];
  }
  return hit;
}

bool is_in_sight(const World& world, const Nearby& nearby, Vec2 from, Vec2 to, double radius,
                 LayerSet layers) {
  const Counted counted{world, nearby, layers};
  return first_in(nearby.walls, from, to - from, radius, [&](std::size_t k) {
           return counted.wall(k);
         }).first > 1.0;
}

}  // namespace avo::inline sim
