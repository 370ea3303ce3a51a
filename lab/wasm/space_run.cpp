// SPDX-License-Identifier: Apache-2.0
// The present state of a run in space, as columns, and the pairs that overlap.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host.h"
#include "io/space/space_clearances.h"
#include "io/text/json.h"

namespace avo_lab {
namespace {

using avo::Vec3;
using avo::space::Robot;
using avo_io::Json;

constexpr double kRounding = 1e-9;  // of the radii: a smaller overlap is none

/// Returns m for each robot, to the body of the nearest other one, downwash included.
std::vector<float> clearances_in_space(const SpaceRun& run) {
  std::vector<float> clearance(run.simulation->size());
  avo_io::SpaceClearances(run.scenario).find(run.simulation->robots(), clearance);
  return clearance;
}

/// Appends an overlap of a ball and of another one around the nearest point of another body.
void append_overlap(const std::string& a, Vec3 center, double radius, const std::string& b,
                    Vec3 nearest, double other_radius, Json& contacts) {
  const Vec3 line = nearest - center;
  const double distance = norm(line), depth = radius + other_radius - distance;
  if (!(depth > kRounding * (radius + other_radius))) return;
  const Vec3 at =
      distance > 0.0 ? center + (radius - 0.5 * depth) / distance * line : center;  // in the middle
  contacts.push_back({{"a", a}, {"b", b}, {"x", at.x}, {"y", at.y}, {"z", at.z}, {"depth", depth}});
}

/// Appends the overlap of two robots: of their balls, or of one's ball and the air below the other.
void append_pair(const SpaceRun& run, std::size_t i, std::size_t j, Json& contacts) {
  const Robot &a = run.simulation->robots()[i], &b = run.simulation->robots()[j];
  const double height = a.position.z - b.position.z;
  const double below_a = std::clamp(height, 0.0, a.downwash);
  const double below_b = std::clamp(-height, 0.0, b.downwash);
  append_overlap(name_of(static_cast<std::int64_t>(i)), a.position - Vec3{0.0, 0.0, below_a},
                 a.radius, name_of(static_cast<std::int64_t>(j)),
                 b.position - Vec3{0.0, 0.0, below_b}, b.radius, contacts);
}

}  // namespace

std::int64_t obstacle_of(const avo::space::Scenario& scenario, std::size_t box) {
  return box < scenario.obstacle_of_box.size() ? scenario.obstacle_of_box[box]
                                               : static_cast<std::int64_t>(box);
}

Columns moment_of(const SpaceRun& run) {
  const avo::space::Simulation& simulation = *run.simulation;
  const bool has_decided = simulation.steps() > 0;
  Columns columns;
  columns.add(simulation.time());
  columns.add(static_cast<double>(simulation.steps()));
  columns.add(static_cast<std::uint32_t>(simulation.size()));
  columns.add(static_cast<std::uint32_t>(simulation.movers().size()));
  for (const Robot& robot : simulation.robots()) columns.add(robot.position);
  for (const Robot& robot : simulation.robots()) columns.add(robot.velocity);
  for (std::size_t k = 0; k < simulation.size(); ++k) columns.add(simulation.goal({k}));
  for (std::size_t k = 0; k < simulation.size(); ++k) columns.add(0.0);
  for (std::size_t k = 0; k < simulation.size(); ++k) {
    const Vec3 a = simulation.plans()[k].acceleration;
    columns.add(norm(Vec3{a.x, a.y, a.z / simulation.robots()[k].vertical}));
  }
  for (const avo::space::Mover& mover : simulation.movers())
    columns.add(mover.position), columns.add(mover.velocity);
  columns.add_all(clearances_in_space(run));
  for (std::size_t k = 0; k < simulation.size(); ++k) columns.add(static_cast<std::int32_t>(k));
  for (const avo::space::Plan& plan : simulation.plans()) columns.add(plan.status);
  for (std::size_t k = 0; k < simulation.size(); ++k) columns.add(has_decided);
  for (std::size_t k = 0; k < simulation.size(); ++k) columns.add(simulation.is_at_goal({k}));
  return columns;
}

std::string contacts_of(const SpaceRun& run) {
  const avo::space::Simulation& simulation = *run.simulation;
  const std::vector<float> clearance = clearances_in_space(run);
  Json contacts = Json::array();
  for (std::size_t i = 0; i < clearance.size(); ++i)
    for (std::size_t j = i + 1; clearance[i] < 0.0F && j < clearance.size(); ++j)
      if (clearance[j] < 0.0F) append_pair(run, i, j, contacts);
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const Robot& robot = simulation.robots()[i];
    const std::string name = name_of(static_cast<std::int64_t>(i));
    for (std::size_t m = 0; m < simulation.movers().size(); ++m)
      append_overlap(name, robot.position, robot.radius, name_of(-1 - static_cast<std::int64_t>(m)),
                     simulation.movers()[m].position, simulation.movers()[m].radius, contacts);
    for (std::size_t k = 0; k < run.scenario.boxes.size(); ++k)
      append_overlap(name, robot.position, robot.radius,
                     "obstacles." + std::to_string(obstacle_of(run.scenario, k)),
                     robot.position + displacement_to(run.scenario.boxes[k], robot.position), 0.0,
                     contacts);
  }
  return contacts.dump();
}

}  // namespace avo_lab
