// SPDX-License-Identifier: Apache-2.0
// From what robots sense to their half-planes, all pairs at once.
#include "planner/soft_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace avo {
namespace {

template <typename T>
void grow(std::vector<T>& column, std::size_t size) {
  if (column.size() < size) column.resize(size);
}

std::size_t planned_with(const PlannerOptions& options, const Sensing& sensing) {
  const std::size_t all = sensing.neighbors.size();
  return options.max_neighbors ? std::min(all, static_cast<std::size_t>(*options.max_neighbors))
                               : all;
}

OwnLimits limits_of(const PlannerOptions& options, const Robot& robot) {
  const double change = adopts_at_once(options.method)
                            ? std::numeric_limits<double>::infinity()
                            : options.control_time * robot.max_acceleration;
  return {robot.velocity, change, robot.max_speed};
}

// Returns the number of pairs.
template <typename Number>
std::size_t fill_pairs(const PlannerOptions& options, std::span<const Sensing> robots,
                       PairColumns<Number>& pairs, SoftPlanes& soft) {
  std::size_t count = 0;
  for (const Sensing& sensing : robots) {
    const std::size_t begin = count;
    count += planned_with(options, sensing);
    OwnLimits own = limits_of(options, *sensing.robot);
    own.end = count;
    for (std::size_t i = begin; i < count; ++i) {
      const Neighbor& neighbor = sensing.neighbors[i - begin];
      const Pair pair = relative(*sensing.robot, neighbor);
      pairs.put(i, pair.position, pair.velocity, pair.radius,
                pair_reach(options, *sensing.robot, neighbor));
      soft.share[i] = reciprocal_share(sensing.robot->max_acceleration, neighbor.max_acceleration);
      if (soft.share[i] == 1.0) {
        own.raise = std::max(own.raise, options.control_time * norm(neighbor.acceleration));
      }
    }
    soft.limits.push_back(own);
  }
  return count;
}

const PlaneColumns<double>& widened(const PlaneColumns<double>& planes, std::size_t,
                                    PlaneColumns<double>&) {
  return planes;
}
// The program counts on unit normals: one step of Newton's iteration for 1/|n|.
const PlaneColumns<double>& widened(const PlaneColumns<float>& planes, std::size_t count,
                                    PlaneColumns<double>& wide) {
  for (auto* column : {&wide.n_x, &wide.n_y, &wide.h, &wide.excess}) grow(*column, planes.h.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 n{planes.n_x[i], planes.n_y[i]};
    const double per_length = 1.5 - 0.5 * dot(n, n);
    wide.n_x[i] = per_length * n.x;
    wide.n_y[i] = per_length * n.y;
    wide.h[i] = per_length * planes.h[i];
    wide.excess[i] = planes.excess[i];
  }
  return wide;
}

// Robots in contact. Without an early end, several pairs are looked at in one instruction.
template <typename Number>
void mark_overlaps(const HalfPlaneBatch<Number>& batch, SoftPlanes& soft) {
  if (batch.workspace.cases.contact == 0) return;
  const std::vector<PairState>& states = batch.planes.state;
  std::size_t i = 0;
  for (std::size_t r = 0; r < soft.limits.size(); ++r) {
    bool found = false;
    for (; i < soft.limits[r].end; ++i) {
      found |= states[i] == PairState::overlapping || states[i] == PairState::coincident;
    }
    soft.overlapping[r] = found ? 1 : 0;
  }
}

// w = v'_A - v_A - δ a_B (§III-B: v'_B = v_B + δ a_B)
double mover_offset(const PlannerOptions& options, const Neighbor& neighbor, Vec2 normal) {
  return neighbor.max_acceleration > 0.0
             ? 0.0
             : options.control_time * dot(normal, neighbor.acceleration);
}

void keep(const PlannerOptions& options, std::span<const Sensing> robots,
          const PlaneColumns<double>& relative, SoftPlanes& soft) {
  std::size_t next = 0, begin = 0;
  for (std::size_t r = 0; r < robots.size(); ++r) {
    for (; next < soft.shared.kept_end[r]; ++next) {
      const std::size_t i = soft.shared.kept[next];
      const double share = soft.share[i];
      const Vec2 normal{relative.n_x[i], relative.n_y[i]};
      double offset = soft.shared.offset[i];
      if (share == 1.0) offset += mover_offset(options, robots[r].neighbors[i - begin], normal);
      soft.planes.push_back({normal, offset});
      // near contact it has no bound; finite all the same
      soft.excess.push_back(
          std::min(share * relative.excess[i], std::numeric_limits<double>::max()));
    }
    begin = soft.limits[r].end;
    soft.first.push_back(soft.planes.size());
  }
}

template <typename Number>
void reserve(std::size_t pairs, HalfPlaneBatch<Number>& batch, SoftPlanes& soft) {
  if (batch.pairs.p_x.size() >= pairs + kSparePairs) return;
  batch.pairs.reserve(pairs);
  reserve(pairs, batch.workspace, batch.planes);
  soft.share.resize(pairs + kSparePairs, 1.0);
  soft.shared.offset.resize(pairs + kSparePairs);
}

template <typename Number>
void collect_exact(const PlannerOptions& options, const Horizon& horizon,
                   std::span<const Sensing> robots, HalfPlaneBatch<Number>& batch,
                   SoftPlanes& soft) {
  std::size_t pairs = 0;
  for (const Sensing& sensing : robots) pairs += planned_with(options, sensing);
  reserve(pairs, batch, soft);
  soft.limits.clear();
  batch.pairs.count = fill_pairs(options, robots, batch.pairs, soft);
  half_planes(batch.pairs, horizon, batch.workspace, batch.planes);
  const PlaneColumns<double>& relative =
      widened(batch.planes, batch.pairs.count, soft.in_double.planes);
  share_out(soft.limits, soft.share, relative, soft.shared);
  soft.overlapping.assign(robots.size(), 0);
  mark_overlaps(batch, soft);
  keep(options, robots, relative, soft);
}

// ORCA's half-planes, and those of the paper's samples.
void collect_others(const PlannerOptions& options, const Horizon& horizon,
                    std::span<const Sensing> robots, SoftPlanes& soft) {
  for (const Sensing& sensing : robots) {
    soft.overlapping.push_back(0);
    const std::size_t count = planned_with(options, sensing);
    for (std::size_t k = 0; k < count; ++k) {
      const Neighbor& neighbor = sensing.neighbors[k];
      const RelativeHalfPlane relative =
          relative_half_plane(options, horizon, *sensing.robot, neighbor);
      if (relative.state == PairState::free) continue;
      if (relative.state == PairState::overlapping || relative.state == PairState::coincident) {
        soft.overlapping.back() = 1;
        if (relative.state == PairState::coincident) continue;
      }
      const NeighborPlane own =
          share_of(options, *sensing.robot, neighbor, static_cast<int>(k), relative);
      soft.planes.push_back(own.plane);
      soft.excess.push_back(own.excess);
    }
    soft.first.push_back(soft.planes.size());
  }
}

}  // namespace

Pair relative(const Robot& robot, const Neighbor& neighbor) {
  return {robot.position - neighbor.position, robot.velocity - neighbor.velocity,
          robot.radius + neighbor.radius};
}

double pair_reach(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor) {
  double acceleration = robot.max_acceleration + neighbor.max_acceleration;
  if (!(neighbor.max_acceleration > 0.0)) acceleration += norm(neighbor.acceleration);
  return options.control_time * acceleration;
}

RelativeHalfPlane relative_half_plane(const PlannerOptions& options, const Horizon& horizon,
                                      const Robot& robot, const Neighbor& neighbor) {
  const Pair pair = relative(robot, neighbor);
  if (options.method == Method::orca) {
    return orca_half_plane(pair, options.time_horizon, options.time_step);
  }
  const double reach = pair_reach(options, robot, neighbor);
  return options.samples > 0 ? sampled_half_plane(pair, reach, horizon, options.samples)
                             : half_plane(pair, reach, horizon);
}

NeighborPlane share_of(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor,
                       int index, const RelativeHalfPlane& relative) {
  const double alpha = reciprocal_share(robot.max_acceleration, neighbor.max_acceleration);
  HalfPlane plane = apportion(relative.plane, robot.velocity, alpha);
  if (!adopts_at_once(options.method)) {
    plane.offset += mover_offset(options, neighbor, plane.normal);
  }
  // near contact it has no bound; finite all the same
  return {index, plane, std::min(alpha * relative.excess, std::numeric_limits<double>::max())};
}

void reserve(std::size_t robots, std::size_t pairs, Precision precision, SoftPlanes& soft) {
  if (precision == Precision::single_precision) {
    reserve(pairs, soft.in_single, soft);
    PlaneColumns<double>& wide = soft.in_double.planes;
    for (auto* column : {&wide.n_x, &wide.n_y, &wide.h, &wide.excess}) {
      grow(*column, pairs + kSparePairs);
    }
  } else {
    reserve(pairs, soft.in_double, soft);
  }
  soft.planes.reserve(pairs);
  soft.excess.reserve(pairs);
  soft.shared.kept.reserve(pairs);
  soft.shared.kept_end.reserve(robots);
  soft.limits.reserve(robots);
  soft.first.reserve(robots + 1);
  soft.overlapping.reserve(robots);
}

void collect_soft_planes(const PlannerOptions& options, const Horizon& horizon,
                         std::span<const Sensing> robots, SoftPlanes& soft) {
  soft.planes.clear();
  soft.excess.clear();
  soft.first.assign(1, 0);
  soft.overlapping.clear();
  if (options.method == Method::orca || options.samples > 0) {
    collect_others(options, horizon, robots, soft);
  } else if (options.precision == Precision::single_precision) {
    collect_exact(options, horizon, robots, soft.in_single, soft);
  } else {
    collect_exact(options, horizon, robots, soft.in_double, soft);
  }
}

}  // namespace avo
