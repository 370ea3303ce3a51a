// SPDX-License-Identifier: Apache-2.0
#include "space/half_spaces.h"

#include <algorithm>
#include <numeric>

#include "avo/half_plane.h"

namespace avo::space {
namespace {

// m: p_A - p_B from the ball of B's and A's downwash that the relative course comes nearest to.
Vec3 relative_place(const Robot& robot, const Neighbor& neighbor, Vec3 v, double time_horizon) {
  Vec3 p = robot.position - neighbor.position;
  if (robot.downwash == 0.0 && neighbor.downwash == 0.0) return p;
  const double squared = norm_squared(v);
  const double nearest = squared > 0.0 ? std::max(-dot(p, v), 0.0) / squared : 0.0;
  const double height = p.z + std::min(nearest, time_horizon) * v.z;
  p.z -= std::clamp(height, -neighbor.downwash, robot.downwash);
  return p;
}

// The indices of the neighbors that get half-spaces, in `index`.
void choose_nearest(const Robot& robot, std::span<const Neighbor> neighbors,
                    const PlannerOptions& options, std::vector<std::size_t>& index) {
  index.resize(neighbors.size());
  std::iota(index.begin(), index.end(), std::size_t{0});
  if (!options.max_neighbors) return;
  const auto most = static_cast<std::size_t>(*options.max_neighbors);
  if (neighbors.size() <= most) return;
  const auto nearer = [&](std::size_t a, std::size_t b) {
    const double to_a = norm_squared(neighbors[a].position - robot.position);
    const double to_b = norm_squared(neighbors[b].position - robot.position);
    return to_a != to_b ? to_a < to_b : a < b;
  };
  std::nth_element(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(most), index.end(),
                   nearer);
  index.resize(most);
  std::sort(index.begin(), index.end());
}

}  // namespace

void collect_half_spaces(const Robot& robot, std::span<const Neighbor> neighbors,
                         const PlannerOptions& options, const Horizon& horizon,
                         HalfSpaces& half_spaces) {
  half_spaces.soft.clear();
  half_spaces.frames.clear();
  half_spaces.overlapping = false;
  choose_nearest(robot, neighbors, options, half_spaces.index);
  std::vector<std::size_t>& index = half_spaces.index;
  half_spaces.pairs.count = 0;
  half_spaces.pairs.reserve(index.size());
  std::size_t kept = 0;
  for (const std::size_t k : index) {
    const Neighbor& neighbor = neighbors[k];
    const Vec3 v = robot.velocity - neighbor.velocity;
    const Vec3 p = relative_place(robot, neighbor, v, options.time_horizon);
    if (p == Vec3{}) {
      half_spaces.overlapping = true;
      continue;
    }
    const PairFrame& frame = half_spaces.frames.emplace_back(frame_of(p, v));
    half_spaces.pairs.add(
        {frame.distance, 0.0}, frame.velocity, robot.radius + neighbor.radius,
        options.control_time * (robot.max_acceleration + neighbor.max_acceleration));
    index[kept++] = k;
  }
  if (kept == 0) return;
  reserve(kept, half_spaces.workspace, half_spaces.planes);
  half_planes(half_spaces.pairs, horizon, half_spaces.workspace, half_spaces.planes);
  const PlaneColumns& planes = half_spaces.planes;
  for (std::size_t i = 0; i < kept; ++i) {
    const PairState state = planes.state[i];
    if (state == PairState::overlapping) half_spaces.overlapping = true;
    if (state == PairState::free || state == PairState::coincident) continue;
    const Neighbor& neighbor = neighbors[index[i]];
    const Vec3 normal = turned_back(half_spaces.frames[i], {planes.n_x[i], planes.n_y[i]});
    const double share = reciprocal_share(robot.max_acceleration, neighbor.max_acceleration,
                                          robot.priority, neighbor.priority);
    half_spaces.soft.push_back({normal, dot(normal, robot.velocity) + share * planes.h[i]});
  }
}

}  // namespace avo::space
