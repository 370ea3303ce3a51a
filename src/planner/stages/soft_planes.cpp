// SPDX-License-Identifier: Apache-2.0
// From the pairs of a tile to the half-planes of its robots, all at once.
#include "planner/stages/soft_planes.h"

#include <algorithm>
#include <limits>

#include "certificate/pair.h"
#include "planner/methods/buffered_voronoi.h"
#include "planner/options.h"
#include "planner/stages/disc_pairs.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

// The half-planes of robots that coincide: nothing that robots sense distinguishes them.
void part_coinciding(const PlannerOptions& options, const Horizon& horizon, const Tile& tile,
                     SoftPlanes& soft) {
  const PairColumns& pairs = soft.pairs.columns;
  for_each_pair(tile, soft.pairs, [&](std::size_t, std::size_t k, std::size_t i) {
    const Vec2 direction = tile.neighbors.parting[k];
    if (direction == Vec2{} || tile.neighbors.kind(k) == NeighborKind::mover) return;
    if (disregards_acceleration(options.method))
      soft.relative.set(i, {PairState::overlapping,
                            {direction / norm(direction), pairs.radius[i] / options.time_step}});
    else
      soft.relative.set(i, parting_half_plane(pairs.radius[i], direction, pairs.reach[i], horizon));
  });
}

void find_relative(const PlannerOptions& options, const Horizon& horizon, const Tile& tile,
                   SoftPlanes& soft) {
  if (disregards_acceleration(options.method))
    orca_half_planes(soft.pairs.columns, options.time_horizon, options.time_step, soft.workspace,
                     soft.relative);
  else
    half_planes(soft.pairs.columns, horizon, soft.workspace, soft.relative);
  if (tile.neighbors.has_partings) part_coinciding(options, horizon, tile, soft);
}

bool has_priorities(const Tile& tile) {
  const auto own = tile.robots.priority.begin();
  return tile.neighbors.has_priorities ||
         std::any_of(own, own + static_cast<std::ptrdiff_t>(tile.robots.count),
                     [](double priority) { return priority != 1.0; });
}

// A's share of H = {w | n . w >= h}, Eq. (20): of the change that H asks for, h > 0, or of the
// change that it leaves.
double share_of_plane(double h, double a_A, double a_B, double priority_A, double priority_B) {
  return h > 0.0 ? reciprocal_share(a_A, a_B, priority_A, priority_B)
                 : room_share(a_A, a_B, priority_A, priority_B);
}

// Applies the priorities to the shares of half-planes.
void weigh(const Tile& tile, SoftPlanes& soft) {
  const RobotColumns& robots = tile.robots;
  const NeighborColumns& neighbors = tile.neighbors;
  for_each_pair(tile, soft.pairs, [&](std::size_t r, std::size_t k, std::size_t i) {
    if (neighbors.kind(k) == NeighborKind::mover) return;
    soft.pairs.share[i] =
        share_of_plane(soft.relative.h[i], robots.max_acceleration[r],
                       neighbors.max_acceleration[k], robots.priority[r], neighbors.priority[k]);
  });
}

// Raises offsets by the movers' own accelerations: w = v'_A - v_A - δ a_B (§III-B: v'_B = v_B +
// δ a_B).
void raise_for_movers(const PlannerOptions& options, const Tile& tile, SoftPlanes& soft) {
  const PlaneColumns& planes = soft.relative;
  for_each_pair(tile, soft.pairs, [&](std::size_t, std::size_t k, std::size_t i) {
    if (tile.neighbors.kind(k) != NeighborKind::mover) return;
    soft.shared.offset[i] += options.control_time * dot(Vec2{planes.n_x[i], planes.n_y[i]},
                                                        tile.neighbors.motion[k].acceleration);
  });
}

void mark_coinciding(const Tile& tile, SoftPlanes& soft) {
  for_each_pair(tile, soft.pairs, [&](std::size_t r, std::size_t k, std::size_t i) {
    const Pair pair = soft.pairs.columns[i];
    if (tile.neighbors.kind(k) != NeighborKind::mover &&
        nearly_coincide(norm(pair.position), pair.radius))
      soft.coinciding[r] = 1;
  });
}

// Marks robots in contact. Without an early end, one instruction tests several pairs.
void mark_overlaps(const PlannerOptions& options, const Tile& tile, SoftPlanes& soft) {
  if (soft.workspace.cases.contact == 0) return;
  if (goes_through_certificate(options)) mark_coinciding(tile, soft);
  const std::vector<PairState>& states = soft.relative.state;
  std::size_t i = 0;
  for (std::size_t r = 0; r < soft.pairs.end.size(); ++r) {
    bool overlaps = false;
    for (; i < soft.pairs.end[r]; ++i) {
      overlaps |= states[i] == PairState::overlapping || states[i] == PairState::coincident;
    }
    soft.overlapping[r] = overlaps ? 1 : 0;
  }
}

void keep(std::size_t robots, SoftPlanes& soft) {
  const PlaneColumns& relative = soft.relative;
  const std::size_t count = soft.shared.kept_end[robots - 1];
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
        std::min(soft.pairs.share[i] * relative.excess[i], std::numeric_limits<double>::max());
  }
  soft.first.assign(1, 0);
  soft.first.insert(soft.first.end(), soft.shared.kept_end.begin(),
                    soft.shared.kept_end.begin() + static_cast<std::ptrdiff_t>(robots));
}

void collect_of_pairs(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                      const Tile& tile, Kept kept, SoftPlanes& soft) {
  const RobotColumns& robots = tile.robots;
  TilePairs& pairs = soft.pairs;
  soft.overlapping.assign(robots.count, 0);
  soft.coinciding.assign(robots.count, 0);
  if (robots.count == 0) return;
  collect_pairs(options, law, tile, pairs);
  // a velocity that is clamped may lie outside of the limit discs
  const bool keeps_all = kept == Kept::all || disregards_acceleration(options.method);
  if (keeps_all) pairs.raise.assign(robots.count, std::numeric_limits<double>::infinity());
  find_relative(options, horizon, tile, soft);
  if (has_priorities(tile)) weigh(tile, soft);
  share_out(robots, pairs.end, pairs.raise, options.control_time, pairs.share, soft.relative,
            soft.shared);
  if (tile.neighbors.has_movers && !disregards_acceleration(options.method))
    raise_for_movers(options, tile, soft);
  mark_overlaps(options, tile, soft);
  keep(robots.count, soft);
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
  clear(tile.robots.count, soft);
  for (std::size_t i = 0; i < tile.robots.count; ++i)
    soft.overlapping[i] = touches_any(tile, law, i) ? 1 : 0;
}

}  // namespace

void reserve(std::size_t robots, std::size_t pairs, SoftPlanes& soft) {
  reserve(robots, pairs, soft.pairs);
  reserve(pairs, soft.workspace, soft.relative);
  grow(soft.shared.offset, pairs + kSparePairs);
  grow(soft.shared.kept, pairs + kSparePairs);
  grow(soft.shared.kept_end, robots);
  soft.planes.reserve(pairs);
  soft.excess.reserve(pairs);
  soft.first.reserve(robots + 1);
  soft.overlapping.reserve(robots);
  soft.coinciding.reserve(robots);
}

void clear(std::size_t robots, SoftPlanes& soft) {
  soft.planes.clear();
  soft.excess.clear();
  soft.exceeding = false;
  soft.first.assign(robots + 1, 0);
  soft.overlapping.assign(robots, 0);
  soft.coinciding.assign(robots, 0);
}

void collect_soft_planes(const PlannerOptions& options, const Horizon& horizon, const StepLaw& law,
                         const Tile& tile, SoftPlanes& soft, Kept kept) {
  if (is_external(options.method)) {
    collect_none(tile, law, soft);
  } else if (method_traits(options.method).stays_in_cell) {
    collect_cells(options, law, tile, soft);
  } else {
    collect_of_pairs(options, horizon, law, tile, kept, soft);
  }
}

}  // namespace avo::inline planner
