// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/pairs.h"

#include <algorithm>

#include "core/plane.h"
#include "planner/decision.h"
#include "planner/rules/margin.h"
#include "planner/stages/disc_pairs.h"
#include "robots/footprint.h"

namespace avo::inline planner {

Pair relative(const Robot& robot, const Neighbor& neighbor) {
  return {robot.position - neighbor.position, robot.velocity - neighbor.velocity,
          robot.radius + neighbor.radius};
}

Reserve reserve_of(const PlannerOptions& options) {
  const SensingNoise& noise = options.sensing_noise;
  return {noise.position, noise.velocity, noise.quantile, options.time_horizon};
}

double with_margin(const Pair& pair, double margin) {
  return pair.radius + margin_in_gap(margin, norm(pair.position) - pair.radius);
}

namespace {

bool has_noise(const SensingNoise& noise) {
  return noise.quantile > 0.0 && (noise.position > 0.0 || noise.velocity > 0.0);
}

// Returns the number of pairs.
std::size_t count_pairs(const PlannerOptions& options, const RobotColumns& robots,
                        TilePairs& pairs) {
  pairs.end.clear();
  std::size_t end = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    end += planned_with(options, robots.neighbors[r]);
    pairs.end.push_back(end);
  }
  pairs.raise.assign(robots.count, 0.0);
  return end;
}

void reserve(std::size_t count, TilePairs& pairs) {
  pairs.columns.reserve(count);
  if (pairs.share.size() < count + kSparePairs) pairs.share.resize(count + kSparePairs, 1.0);
}

// The half-planes of pairs with footprints are those of the two nearest discs.
void take_nearest_discs(const Tile& tile, const StepLaw& law, TilePairs& pairs) {
  PairColumns& columns = pairs.columns;
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r) {
    const std::size_t first = i;
    i = pairs.end[r];
    if (i == first || !has_discs(tile.robots, r)) continue;
    const Robot robot = tile.robots.robot(r);
    const Discs discs = discs_of(robot, law);
    for (std::size_t k = first; k < i; ++k) {
      const Neighbor neighbor = tile.robots.neighbors[r][k - first];
      if (!neighbor.footprint && !has_footprint(robot.model)) continue;
      const DiscPair nearest = nearest_discs(discs, neighbor);
      const Vec2 p = nearest.robot.position - nearest.neighbor.position;
      columns.p_x[k] = p.x, columns.p_y[k] = p.y;
      columns.radius[k] = nearest.robot.radius + nearest.neighbor.radius;
    }
  }
}

// Adds the effect of movers on a pair, and the largest increase of the offset by it.
void add_movers(const PlannerOptions& options, const Tile& tile, TilePairs& pairs) {
  for_each_pair(tile, pairs, [&](std::size_t r, std::size_t k, std::size_t i) {
    if (tile.neighbors.kind(k) != NeighborKind::mover) return;
    const double acceleration = norm(tile.neighbors.motion[k].acceleration);
    pairs.columns.reach[i] =
        options.control_time * (tile.robots.max_acceleration[r] + acceleration);
    pairs.raise[r] = std::max(pairs.raise[r], options.control_time * acceleration);
    pairs.share[i] = 1.0;
  });
}

void add_margins(const PlannerOptions& options, const Tile& tile, TilePairs& pairs) {
  const RobotColumns& robots = tile.robots;
  PairColumns& columns = pairs.columns;
  std::size_t i = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    const MotionModel* model = robots.model[r];
    const double radius =
        model != nullptr ? route_radius(*model, robots.radius[r]) : robots.radius[r];
    const auto own = [&](double margin) {
      return margin_on_route(margin, radius, robots.distance_to_goal[r]);
    };
    const double margin = own(options.margin), larger = own(mover_margin(options, radius));
    for (std::size_t k = robots.neighbors[r].first; i < pairs.end[r]; ++i, ++k) {
      const bool shares = tile.neighbors.kind(k) != NeighborKind::mover;
      columns.radius[i] = with_margin(columns[i], shares ? margin : larger);
    }
  }
}

}  // namespace

void reserve(std::size_t robots, std::size_t pairs, TilePairs& tile_pairs) {
  reserve(pairs, tile_pairs);
  tile_pairs.end.reserve(robots);
  tile_pairs.raise.reserve(robots);
}

void collect_pairs(const PlannerOptions& options, const StepLaw& law, const Tile& tile,
                   TilePairs& pairs) {
  reserve(count_pairs(options, tile.robots, pairs), pairs);
  relate(tile.robots, tile.neighbors, pairs.end, options.control_time, pairs.columns, pairs.share);
  if (tile.robots.has_models || tile.neighbors.has_footprints) take_nearest_discs(tile, law, pairs);
  if (tile.neighbors.has_movers) add_movers(options, tile, pairs);
  if (has_noise(options.sensing_noise)) reserve_room(reserve_of(options), pairs.columns);
  if (options.margin > 0.0 || tile.neighbors.has_movers) add_margins(options, tile, pairs);
}

}  // namespace avo::inline planner
