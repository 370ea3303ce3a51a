// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/pair_planes.h"

#include <algorithm>
#include <limits>

#include "obstacles/half_planes.h"
#include "planner/methods/buffered_voronoi.h"
#include "planner/rules/margin.h"

namespace avo::inline planner {

bool parts(const Neighbor& neighbor) {
  return neighbor.parting != Vec2{} && shares(neighbor);
}

bool has_noise(const SensingNoise& noise) {
  return noise.quantile > 0.0 && (noise.position > 0.0 || noise.velocity > 0.0);
}

double with_margin(const Pair& pair, double margin) {
  return pair.radius + margin_in_gap(margin, norm(pair.position) - pair.radius);
}

RelativeHalfPlane parting_plane(const PlannerOptions& options, const Horizon& horizon,
                                double radius, Vec2 direction, double reach) {
  if (!disregards_acceleration(options.method))
    return parting_half_plane(radius, direction, reach, horizon);
  return {PairState::overlapping, {direction / norm(direction), radius / options.time_step}};
}

double share_of_plane(double h, double a_A, double a_B, double priority_A, double priority_B) {
  return h > 0.0 ? reciprocal_share(a_A, a_B, priority_A, priority_B)
                 : room_share(a_A, a_B, priority_A, priority_B);
}

double mover_offset(const PlannerOptions& options, const Neighbor& neighbor, Vec2 normal) {
  return shares(neighbor) ? 0.0 : options.control_time * dot(normal, neighbor.acceleration);
}

Reserve reserve_of(const PlannerOptions& options) {
  const SensingNoise& noise = options.sensing_noise;
  return {noise.position, noise.velocity, noise.quantile, options.time_horizon};
}

Pair relative(const Robot& robot, const Neighbor& neighbor) {
  return {robot.position - neighbor.position, robot.velocity - neighbor.velocity,
          robot.radius + neighbor.radius};
}

namespace {

// [R] m/s, the largest change of both: δ (a_A + a_B); for a mover that moves on, its sensed
// acceleration counts.
double pair_reach(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor) {
  const double other = shares(neighbor) ? neighbor.max_acceleration : norm(neighbor.acceleration);
  return options.control_time * (robot.max_acceleration + other);
}

RelativeHalfPlane relative_half_plane(const PlannerOptions& options, const Horizon& horizon,
                                      const Robot& robot, const Neighbor& neighbor) {
  Pair pair = relative(robot, neighbor);
  if (has_noise(options.sensing_noise)) pair.radius = reserved_radius(pair, reserve_of(options));
  const double margin = shares(neighbor) ? options.margin : mover_margin(options, robot.radius);
  if (margin > 0.0)
    pair.radius = with_margin(pair, margin_on_way(margin, robot.radius, robot.distance_to_goal));
  if (parts(neighbor))
    return parting_plane(options, horizon, pair.radius, neighbor.parting,
                         pair_reach(options, robot, neighbor));
  if (disregards_acceleration(options.method)) {
    return orca_half_plane(pair, options.time_horizon, options.time_step);
  }
  return half_plane(pair, pair_reach(options, robot, neighbor), horizon);
}

// A's half-plane in v', from the relative one.
NeighborPlane share_of(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor,
                       int index, const RelativeHalfPlane& relative) {
  const double alpha =
      shares(neighbor)
          ? share_of_plane(relative.plane.offset, robot.max_acceleration, neighbor.max_acceleration,
                           robot.priority, neighbor.priority)
          : 1.0;
  HalfPlane plane = apportion(relative.plane, robot.velocity, alpha);
  if (!disregards_acceleration(options.method)) {
    plane.offset += mover_offset(options, neighbor, plane.normal);
  }
  // near contact it has no bound; keep it finite
  return {index, plane, std::min(alpha * relative.excess, std::numeric_limits<double>::max())};
}

}  // namespace

std::optional<NeighborPlane> own_half_plane(const PlannerOptions& options, const Horizon& horizon,
                                            const Robot& robot, const Neighbor& neighbor, int index,
                                            bool& overlapping) {
  if (method_traits(options.method).stays_in_cell)
    return cell_half_plane(options, robot, neighbor, index, overlapping);
  const RelativeHalfPlane plane = relative_half_plane(options, horizon, robot, neighbor);
  const bool coincident = plane.state == PairState::coincident;
  if (coincident || plane.state == PairState::overlapping) overlapping = true;
  if (coincident || plane.state == PairState::free) return {};
  return share_of(options, robot, neighbor, index, plane);
}

}  // namespace avo::inline planner
