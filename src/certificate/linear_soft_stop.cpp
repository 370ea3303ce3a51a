// SPDX-License-Identifier: Apache-2.0
// S2: z = p + (d_s - Δt/2) v obeys z' = z + Δt (v + d_s a), so that a constraint on v + d_s a keeps
// it on its side.
#include "certificate/linear_soft_stop.h"

#include <algorithm>
#include <cstddef>

#include "avo/half_plane.h"

namespace avo {

void collect_soft_stops(const Robot& robot, const Neighbors& neighbors, double time_step,
                        double soft_stop_time, std::vector<SoftStopWall>& walls,
                        Invariant& invariant) {
  const double ahead = soft_stop_time - 0.5 * time_step;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    const Vec2 p = robot.position - neighbor.position;
    const Vec2 to_z = ahead * (robot.velocity - neighbor.velocity);
    const Vec2 z = p + to_z;
    const double length_squared = norm_squared(to_z);
    const double part =
        length_squared > 0.0 ? std::clamp(-dot(p, to_z) / length_squared, 0.0, 1.0) : 0.0;
    const Vec2 nearest = p + part * to_z;
    const double d = norm(nearest);
    const Vec2 n = d > 0.0 ? nearest / d : Vec2{};
    const double distance = std::min(dot(n, p), dot(n, z));
    const double share = reciprocal_share(robot.max_acceleration, neighbor.max_acceleration);
    const double contact = robot.radius + neighbor.radius;
    invariant.slack = std::min(invariant.slack, distance - contact);
    const bool broken = distance < contact;
    if (broken) invariant.broken = static_cast<int>(k);
    // each step keeps z's distance up to its rounding, which a share of it cannot use up
    const double lengths = norm(robot.position) + norm(neighbor.position) + norm(to_z) + contact;
    const double shrinks = neighbor.max_acceleration > 0.0 ? std::min(share, 1.0 - share) : 1.0;
    const double held = broken ? distance : contact + 0x1p-40 * lengths / shrinks;
    walls.push_back({static_cast<int>(k), {n, -share * (dot(n, z) - held) / time_step}});
  }
}

Vec2 softly_braked(Vec2 velocity, double time_step, double soft_stop_time) {
  return (1.0 - time_step / soft_stop_time) * velocity;
}

Vec2 soft_stop_velocity(Vec2 velocity, Vec2 next_velocity, double time_step,
                        double soft_stop_time) {
  return velocity + (soft_stop_time / time_step) * (next_velocity - velocity);
}

bool keeps(std::span<const SoftStopWall> walls, Vec2 soft_stop_velocity) {
  return std::all_of(walls.begin(), walls.end(), [&](const SoftStopWall& wall) {
    return violation(wall.half_plane, soft_stop_velocity) <= 0.0;
  });
}

void append_half_planes(std::span<const SoftStopWall> walls, Vec2 velocity, double time_step,
                        double soft_stop_time, std::vector<HalfPlane>& half_planes) {
  const double ratio = soft_stop_time / time_step;
  for (const SoftStopWall& wall : walls) {
    const auto& [n, offset] = wall.half_plane;
    if (n == Vec2{}) continue;  // equal centers: no direction
    half_planes.push_back({n, (offset + (ratio - 1.0) * dot(n, velocity)) / ratio});
  }
}

}  // namespace avo
