// SPDX-License-Identifier: Apache-2.0
// The present state as columns, with an entry for each present robot.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "avo/clearance.h"
#include "host.h"

namespace avo_lab {
namespace {

/// Finds clearances of the present robots, which come and go.
class Clearances {
 public:
  const std::vector<float>& of(const avo::FleetView& fleet) {
    if (!finder_ || !std::equal(ids_.begin(), ids_.end(), fleet.id.begin(), fleet.id.end())) {
      ids_.assign(fleet.id.begin(), fleet.id.end());
      avo::Scenario scene;
      scene.robots.assign(fleet.setup.begin(), fleet.setup.end());
      finder_.emplace(scene);
    }
    x_.clear(), y_.clear();
    for (const avo::Vec2 p : fleet.position) x_.push_back(p.x), y_.push_back(p.y);
    clearance_.resize(ids_.size());
    finder_->find({x_, y_, fleet.heading}, clearance_);
    return clearance_;
  }

 private:
  std::vector<avo::RobotId> ids_;
  std::optional<avo::ClearanceFinder> finder_;
  std::vector<double> x_, y_;
  std::vector<float> clearance_;
};

}  // namespace

std::span<const float> clearances_of(const avo::FleetView& fleet) {
  static Clearances clearances;
  return clearances.of(fleet);
}

Columns moment_of(const PlaneRun& run) {
  const avo::Simulation& simulation = *run.simulation;
  const avo::FleetView fleet = simulation.fleet();
  const avo::MovingObstacleView obstacles = simulation.moving_obstacles();
  Columns columns;
  columns.add(simulation.time());
  columns.add(static_cast<double>(simulation.steps()));
  columns.add(static_cast<std::uint32_t>(fleet.id.size()));
  columns.add(static_cast<std::uint32_t>(obstacles.position.size()));
  columns.add_all(fleet.position);
  columns.add_all(fleet.velocity);
  columns.add_all(fleet.goal);
  columns.add_all(fleet.heading);
  columns.add_all(fleet.applied_acceleration);
  for (std::size_t k = 0; k < obstacles.position.size(); ++k)
    columns.add(obstacles.position[k]), columns.add(obstacles.velocity[k]);
  columns.add_all(clearances_of(fleet));
  for (const avo::RobotId id : fleet.id) columns.add(static_cast<std::int32_t>(id.value));
  for (const avo::Plan& plan : fleet.plan) columns.add(plan.status);
  for (const avo::RobotId id : fleet.id) columns.add(simulation.decided(id));
  for (const avo::RobotId id : fleet.id) columns.add(simulation.is_at_goal(id));
  return columns;
}

}  // namespace avo_lab
