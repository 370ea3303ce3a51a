// SPDX-License-Identifier: Apache-2.0
// From what robots sense to their half-planes, all pairs at once.
#include "planner/soft_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace avo {
namespace {

std::size_t planned_with(const PlannerOptions& options, const Sensing& sensing) {
  const std::size_t all = sensing.neighbors.size();
  return options.max_neighbors ? std::min(all, static_cast<std::size_t>(*options.max_neighbors))
                               : all;
}

// Does D(0, v_max) or D(v_A, δ a_max) alone keep to the plane?
bool cannot_cut(const PlannerOptions& options, const Robot& robot, const HalfPlane& plane) {
  double least = -robot.max_speed;
  if (!adopts_at_once(options.method)) {
    least = std::max(
        least, dot(plane.normal, robot.velocity) - options.control_time * robot.max_acceleration);
  }
  return plane.offset <= least;
}

void take(const PlannerOptions& options, const Sensing& sensing, std::size_t k,
          const RelativeHalfPlane& relative, SoftPlanes& soft) {
  if (relative.state == PairState::free) return;
  if (relative.state == PairState::overlapping || relative.state == PairState::coincident) {
    soft.overlapping.back() = 1;
    if (relative.state == PairState::coincident) return;
  }
  const NeighborPlane own =
      share_of(options, *sensing.robot, sensing.neighbors[k], static_cast<int>(k), relative);
  if (own.excess <= 0.0 && cannot_cut(options, *sensing.robot, own.plane)) return;
  soft.planes.push_back(own.plane);
  soft.excess.push_back(own.excess);
}

template <typename Number>
RelativeHalfPlane plane_at(const PlaneColumns<Number>& planes, std::size_t i) {
  HalfPlane plane{{planes.n_x[i], planes.n_y[i]}, planes.h[i]};
  if constexpr (std::is_same_v<Number, float>) {
    // the program counts on unit vectors: one step of Newton's iteration for 1/|n|
    const double per_length = 1.5 - 0.5 * dot(plane.normal, plane.normal);
    plane = {per_length * plane.normal, per_length * plane.offset};
  }
  return {planes.state[i], plane, planes.excess[i]};
}

template <typename Number>
void collect_exact(const PlannerOptions& options, const Horizon& horizon,
                   std::span<const Sensing> robots, HalfPlaneBatch<Number>& batch,
                   SoftPlanes& soft) {
  std::size_t pairs = 0;
  for (const Sensing& sensing : robots) pairs += planned_with(options, sensing);
  batch.pairs.count = 0;
  batch.pairs.reserve(std::max(pairs, soft.planes.capacity()));
  for (const Sensing& sensing : robots) {
    const Robot& robot = *sensing.robot;
    for (const Neighbor& neighbor : sensing.neighbors.first(planned_with(options, sensing))) {
      const Pair pair = relative(robot, neighbor);
      batch.pairs.add(pair.position, pair.velocity, pair.radius,
                      pair_reach(options, robot, neighbor));
    }
  }
  half_planes(batch.pairs, horizon, batch.workspace, batch.planes);
  std::size_t i = 0;
  for (const Sensing& sensing : robots) {
    soft.overlapping.push_back(0);
    const std::size_t count = planned_with(options, sensing);
    for (std::size_t k = 0; k < count; ++k, ++i) {
      take(options, sensing, k, plane_at(batch.planes, i), soft);
    }
    soft.first.push_back(soft.planes.size());
  }
}

// ORCA's half-planes, and those of the paper's samples.
void collect_others(const PlannerOptions& options, const Horizon& horizon,
                    std::span<const Sensing> robots, SoftPlanes& soft) {
  for (const Sensing& sensing : robots) {
    soft.overlapping.push_back(0);
    const std::size_t count = planned_with(options, sensing);
    for (std::size_t k = 0; k < count; ++k) {
      take(options, sensing, k,
           relative_half_plane(options, horizon, *sensing.robot, sensing.neighbors[k]), soft);
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
  return options.control_time *
         (robot.max_acceleration + neighbor.max_acceleration +
          (neighbor.max_acceleration > 0.0 ? 0.0 : norm(neighbor.acceleration)));
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
  if (!(neighbor.max_acceleration > 0.0) && !adopts_at_once(options.method)) {
    // w = v'_A - v_A - δ a_B (§III-B: v'_B = v_B + δ a_B)
    plane.offset += options.control_time * dot(plane.normal, neighbor.acceleration);
  }
  // near contact it has no bound; finite all the same
  return {index, plane, std::min(alpha * relative.excess, std::numeric_limits<double>::max())};
}

void reserve(std::size_t robots, std::size_t pairs, SoftPlanes& soft) {
  soft.planes.reserve(pairs);
  soft.excess.reserve(pairs);
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
