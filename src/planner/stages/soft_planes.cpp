// SPDX-License-Identifier: Apache-2.0
// From the sensed states to the half-planes of all pairs at once.
#include "planner/stages/soft_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate/pair.h"
#include "planner/decision.h"
#include "planner/methods/buffered_voronoi.h"
#include "planner/rules/margin.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/pair_planes.h"
#include "robots/footprint.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

// Returns the number of pairs.
std::size_t count_pairs(const PlannerOptions& options, const RobotColumns& robots,
                        SoftPlanes& soft) {
  soft.pair_end.clear();
  std::size_t end = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    end += planned_with(options, robots.neighbors[r]);
    soft.pair_end.push_back(end);
  }
  soft.raise.assign(robots.count, 0.0);
  return end;
}

// Adds the effect of movers on a pair, and the largest increase of the offset by it.
void add_movers(const PlannerOptions& options, const Tile& tile, SoftPlanes& soft) {
  const NeighborColumns& neighbors = tile.neighbors;
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r) {
    for (std::size_t k = tile.robots.neighbors[r].first; i < soft.pair_end[r]; ++i, ++k) {
      if (neighbors.kind(k) != NeighborKind::mover) continue;
      const double acceleration = norm(neighbors.motion[k].acceleration);
      soft.pairs.reach[i] = options.control_time * (tile.robots.max_acceleration[r] + acceleration);
      soft.raise[r] = std::max(soft.raise[r], options.control_time * acceleration);
      soft.share[i] = 1.0;
    }
  }
}

// Applies the priorities to the shares of half-planes.
void weigh(const Tile& tile, SoftPlanes& soft) {
  const RobotColumns& robots = tile.robots;
  const NeighborColumns& neighbors = tile.neighbors;
  std::size_t i = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    for (std::size_t k = robots.neighbors[r].first; i < soft.pair_end[r]; ++i, ++k) {
      if (neighbors.kind(k) == NeighborKind::mover) continue;
      soft.share[i] =
          share_of_plane(soft.relative.h[i], robots.max_acceleration[r],
                         neighbors.max_acceleration[k], robots.priority[r], neighbors.priority[k]);
    }
  }
}

bool has_priorities(const Tile& tile) {
  const auto own = tile.robots.priority.begin();
  return tile.neighbors.has_priorities ||
         std::any_of(own, own + static_cast<std::ptrdiff_t>(tile.robots.count),
                     [](double priority) { return priority != 1.0; });
}

// The half-planes of robots that coincide: nothing that robots sense distinguishes them.
void part_coinciding(const PlannerOptions& options, const Horizon& horizon, const Tile& tile,
                     SoftPlanes& soft) {
  const NeighborColumns& neighbors = tile.neighbors;
  PlaneColumns& planes = soft.relative;
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r) {
    for (std::size_t k = tile.robots.neighbors[r].first; i < soft.pair_end[r]; ++i, ++k) {
      if (neighbors.parting[k] == Vec2{} || neighbors.kind(k) == NeighborKind::mover) continue;
      const RelativeHalfPlane plane = parting_plane(options, horizon, soft.pairs.radius[i],
                                                    neighbors.parting[k], soft.pairs.reach[i]);
      planes.n_x[i] = plane.plane.normal.x, planes.n_y[i] = plane.plane.normal.y;
      planes.h[i] = plane.plane.offset, planes.excess[i] = plane.excess;
      planes.state[i] = plane.state;
    }
  }
}

void mark_coinciding(const Tile& tile, SoftPlanes& soft) {
  const PairColumns& pairs = soft.pairs;
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r) {
    for (std::size_t k = tile.robots.neighbors[r].first; i < soft.pair_end[r]; ++i, ++k) {
      if (tile.neighbors.kind(k) != NeighborKind::mover &&
          nearly_coincide(norm(Vec2{pairs.p_x[i], pairs.p_y[i]}), pairs.radius[i]))
        soft.coinciding[r] = 1;
    }
  }
}

// Marks robots in contact. Without an early end, one instruction tests several pairs.
void mark_overlaps(const PlannerOptions& options, const Tile& tile, SoftPlanes& soft) {
  if (soft.workspace.cases.contact == 0) return;
  // only method avo makes detours
  if (method_traits(options.method).has_rules) mark_coinciding(tile, soft);
  const std::vector<PairState>& states = soft.relative.state;
  std::size_t i = 0;
  for (std::size_t r = 0; r < soft.pair_end.size(); ++r) {
    bool overlaps = false;
    for (; i < soft.pair_end[r]; ++i) {
      overlaps |= states[i] == PairState::overlapping || states[i] == PairState::coincident;
    }
    soft.overlapping[r] = overlaps ? 1 : 0;
  }
}

void keep(std::size_t robots, SoftPlanes& soft) {
  const PlaneColumns& relative = soft.relative;
  const std::size_t count = robots > 0 ? soft.shared.kept_end[robots - 1] : 0;
  soft.planes.resize(count);
  soft.excess.assign(count, 0.0);
  soft.exceeding = soft.shared.exceeding;
  for (std::size_t k = 0; k < count; ++k) {
    // signed, because processors convert to signed integers
    const auto i = static_cast<std::size_t>(static_cast<std::int64_t>(soft.shared.kept[k]));
    soft.planes[k] = {{relative.n_x[i], relative.n_y[i]}, soft.shared.offset[i]};
    if (!soft.exceeding) continue;
    // near contact it has no bound; keep it finite
    soft.excess[k] =
        std::min(soft.share[i] * relative.excess[i], std::numeric_limits<double>::max());
  }
  soft.first.assign(1, 0);
  soft.first.insert(soft.first.end(), soft.shared.kept_end.begin(),
                    soft.shared.kept_end.begin() + static_cast<std::ptrdiff_t>(robots));
}

void raise_for_movers(const PlannerOptions& options, const RobotColumns& robots, SoftPlanes& soft) {
  std::size_t begin = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    for (std::size_t k = soft.first[r]; k < soft.first[r + 1]; ++k) {
      const std::size_t pair = static_cast<std::size_t>(soft.shared.kept[k]) - begin;
      HalfPlane& plane = soft.planes[k];
      plane.offset += mover_offset(options, robots.neighbors[r][pair], plane.normal);
    }
    begin = soft.pair_end[r];
  }
}

void add_margins(const PlannerOptions& options, const Tile& tile, SoftPlanes& soft) {
  const RobotColumns& robots = tile.robots;
  PairColumns& pairs = soft.pairs;
  std::size_t i = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    const MotionModel* model = robots.model[r];
    const double radius =
        model != nullptr ? way_radius(*model, robots.radius[r]) : robots.radius[r];
    const auto own = [&](double margin) {
      return margin_on_way(margin, radius, robots.distance_to_goal[r]);
    };
    const double margin = own(options.margin), larger = own(mover_margin(options, radius));
    for (std::size_t k = robots.neighbors[r].first; i < soft.pair_end[r]; ++i, ++k) {
      const bool shares = tile.neighbors.kind(k) != NeighborKind::mover;
      pairs.radius[i] = with_margin({{pairs.p_x[i], pairs.p_y[i]}, {}, pairs.radius[i]},
                                    shares ? margin : larger);
    }
  }
}

// The half-planes of pairs with footprints are those of the two nearest discs.
void take_nearest_discs(const Tile& tile, const StepLaw& law, SoftPlanes& soft) {
  PairColumns& pairs = soft.pairs;
  std::size_t i = 0;
  for (std::size_t r = 0; r < tile.robots.count; ++r) {
    const std::size_t first = i;
    i = soft.pair_end[r];
    if (i == first || !has_discs(tile.robots, r)) continue;
    const Robot robot = tile.robots.robot(r);
    const Discs discs = discs_of(robot, law);
    for (std::size_t k = first; k < i; ++k) {
      const Neighbor neighbor = tile.robots.neighbors[r][k - first];
      if (!neighbor.footprint && !has_footprint(robot.model)) continue;
      const DiscPair nearest = nearest_discs(discs, neighbor);
      const Vec2 p = nearest.robot.position - nearest.neighbor.position;
      pairs.p_x[k] = p.x, pairs.p_y[k] = p.y;
      pairs.radius[k] = nearest.robot.radius + nearest.neighbor.radius;
    }
  }
}

void reserve(std::size_t pairs, SoftPlanes& soft) {
  soft.pairs.reserve(pairs);
  if (soft.share.size() < pairs + kSparePairs) soft.share.resize(pairs + kSparePairs, 1.0);
  grow(soft.shared.offset, pairs + kSparePairs);
  grow(soft.shared.kept, pairs + kSparePairs);
}

void collect_exact(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                   const Tile& tile, SoftPlanes& soft) {
  const RobotColumns& robots = tile.robots;
  soft.overlapping.assign(robots.count, 0);
  soft.coinciding.assign(robots.count, 0);
  if (robots.count == 0) return;
  reserve(count_pairs(options, robots, soft), soft);
  relate(robots, tile.neighbors, soft.pair_end, options.control_time, soft.pairs, soft.share);
  if (tile.robots.has_models || tile.neighbors.has_footprints) take_nearest_discs(tile, law, soft);
  if (tile.neighbors.has_movers) add_movers(options, tile, soft);
  if (has_noise(options.sensing_noise)) reserve_room(reserve_of(options), soft.pairs);
  if (options.margin > 0.0 || tile.neighbors.has_movers) add_margins(options, tile, soft);
  half_planes(soft.pairs, horizon, soft.workspace, soft.relative);
  if (tile.neighbors.has_partings) part_coinciding(options, horizon, tile, soft);
  if (has_priorities(tile)) weigh(tile, soft);
  share_out(robots, soft.pair_end, soft.raise, options.control_time, soft.share, soft.relative,
            soft.shared);
  mark_overlaps(options, tile, soft);
  keep(robots.count, soft);
  if (tile.neighbors.has_movers) raise_for_movers(options, robots, soft);
}

// Collects half-planes of the methods that disregard accelerations, and of Voronoi cells.
void collect_others(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                    const Tile& tile, SoftPlanes& soft) {
  soft.planes.clear();
  soft.excess.clear();
  soft.exceeding = false;
  soft.first.assign(1, 0);
  soft.overlapping.clear();
  soft.coinciding.assign(tile.robots.count, 0);
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    const Robot robot = tile.robots.robot(i);
    const Neighbors& neighbors = tile.robots.neighbors[i];
    const std::size_t count = planned_with(options, neighbors);
    const bool are_covered = has_discs(tile.robots, i);
    const Discs discs = are_covered ? discs_of(robot, law) : Discs{};
    bool overlapping = false;
    for (std::size_t k = 0; k < count; ++k) {
      Neighbor neighbor = neighbors[k];
      Robot disc = robot;
      if (are_covered) {
        const DiscPair nearest = nearest_discs(discs, neighbor);
        disc = nearest.robot, neighbor = nearest.neighbor;
      }
      const auto own =
          own_half_plane(options, horizon, disc, neighbor, static_cast<int>(k), overlapping);
      if (shares(neighbor) &&
          nearly_coincide(norm(disc.position - neighbor.position), disc.radius + neighbor.radius))
        soft.coinciding[i] = 1;
      if (!own) continue;
      grow(soft.shared.kept, soft.planes.size() + 1);
      soft.shared.kept[soft.planes.size()] = static_cast<double>(k);
      soft.planes.push_back(own->plane);
      soft.excess.push_back(own->excess);
      soft.exceeding |= own->excess > 0.0;
    }
    soft.overlapping.push_back(overlapping ? 1 : 0);
    soft.first.push_back(soft.planes.size());
  }
}

bool touches_any(const Tile& tile, const StepLaw& law, std::size_t i) {
  const Discs discs = discs_of(tile.robots.robot(i), law);
  const Neighbors& neighbors = tile.robots.neighbors[i];
  for (std::size_t k = 0; k < neighbors.size(); ++k)
    if (nearest_discs(discs, neighbors[k]).gap < 0.0) return true;
  const std::span<const Wall> walls = tile.walls_of(i);
  return std::any_of(walls.begin(), walls.end(), [&](const Wall& wall) {
    const std::span<const Robot> all = discs.all();
    return std::any_of(all.begin(), all.end(), [&](const Robot& disc) {
      return distance(disc.position, {wall.a, wall.b}) < disc.radius + wall.radius;
    });
  });
}

// An external method has no half-planes; robots in contact are marked all the same.
void collect_none(const Tile& tile, const StepLaw& law, SoftPlanes& soft) {
  soft.planes.clear();
  soft.excess.clear();
  soft.exceeding = false;
  soft.first.assign(tile.robots.count + 1, 0);
  soft.coinciding.assign(tile.robots.count, 0);
  soft.overlapping.clear();
  for (std::size_t i = 0; i < tile.robots.count; ++i)
    soft.overlapping.push_back(touches_any(tile, law, i) ? 1 : 0);
}

}  // namespace

void reserve(std::size_t robots, std::size_t pairs, SoftPlanes& soft) {
  reserve(pairs, soft);
  reserve(pairs, soft.workspace, soft.relative);
  soft.planes.reserve(pairs);
  soft.excess.reserve(pairs);
  grow(soft.shared.kept_end, robots);
  soft.pair_end.reserve(robots);
  soft.raise.reserve(robots);
  soft.first.reserve(robots + 1);
  soft.overlapping.reserve(robots);
  soft.coinciding.reserve(robots);
}

void collect_soft_planes(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                         const Tile& tile, SoftPlanes& soft) {
  if (is_external(options.method)) {
    collect_none(tile, law, soft);
  } else if (disregards_acceleration(options.method) ||
             method_traits(options.method).stays_in_cell) {
    collect_others(options, horizon, law, tile, soft);
  } else {
    collect_exact(options, horizon, law, tile, soft);
  }
}

}  // namespace avo::inline planner
