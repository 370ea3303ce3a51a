// SPDX-License-Identifier: Apache-2.0
#include "metrics/crowd.h"

#include <algorithm>
#include <cmath>

#include "core/plane.h"

namespace avo::inline metrics {
namespace {

constexpr double kDanger = 0.2;  // m, between discs: a smaller distance is danger

}  // namespace

// Examines one robot: the robots near it, and its cell.
void Crowd::look_around(const FleetView& fleet, std::size_t robot, double duration) {
  double nearest = kInfinity;  // m, between discs
  cell_.begin();
  const double radius = disc_radius(fleet.setup[robot]);
  for (const NeighborHit& hit :
       grid_.gather(positions_[robot], static_cast<int>(robot), positions_.size(), scratch_)) {
    const auto other = static_cast<std::size_t>(hit.index);
    nearest = std::min(nearest, std::sqrt(hit.distance_squared) - radius - radii_[other]);
    if (other < fleet.id.size()) cell_.cut(positions_[other] - positions_[robot]);
  }
  if (nearest < kDanger) {
    danger_time_ += duration;
    separation_in_danger_ += nearest * duration;
  }
  const double density = 1.0 / cell_.area();
  density_ += density * duration;
  densest_ = std::max(densest_, density);
}

void Crowd::observe(const Simulation& simulation, const Trips& trips, double duration) {
  const FleetView fleet = simulation.fleet();
  const MovingObstacleView movers = simulation.moving_obstacles();
  double largest = 0.0;  // m
  positions_.clear(), radii_.clear();
  const auto add = [&](Vec2 position, double radius) {
    positions_.push_back(position), radii_.push_back(radius);
    largest = std::max(largest, radius);
  };
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    const RobotSetup& setup = fleet.setup[i];
    add(disc_center(setup.model, fleet.position[i], fleet.heading[i]), disc_radius(setup));
  }
  for (std::size_t k = 0; k < movers.setup.size(); ++k)
    add(movers.position[k], movers.setup[k].radius);
  // no farther point cuts a cell
  grid_.build(positions_, std::max(2.0 * kCellRadius, 2.0 * largest + kDanger));
  Vec2 directions = {};
  double moving = 0.0;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    if (!trips.is_travelling(fleet.id[i].value)) continue;
    time_ += duration;
    look_around(fleet, i, duration);
    const double speed = norm(fleet.velocity[i]);
    if (!(speed > kMoves * fleet.setup[i].preferred_speed)) continue;
    directions = directions + fleet.velocity[i] / speed;
    moving += 1.0;
  }
  if (moving < 2.0) return;  // a single robot is always in order
  order_time_ += duration;
  order_ += norm(directions) / moving * duration;
}

void Crowd::describe(RunMetrics& metrics) const {
  if (time_ > 0.0) {
    metrics.danger = danger_time_ / time_;
    metrics.density_mean = density_ / time_;
    metrics.density_max = densest_;
  }
  if (danger_time_ > 0.0) metrics.danger_separation = separation_in_danger_ / danger_time_;
  if (order_time_ > 0.0) metrics.order = order_ / order_time_;
}

}  // namespace avo::inline metrics
