// SPDX-License-Identifier: Apache-2.0
// The pairs that overlap now.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "avo/clearance.h"
#include "avo/discs.h"
#include "host.h"
#include "io/text/json.h"
#include "walls/segment.h"
#include "walls/wall_grid.h"

namespace avo_lab {
namespace {

using avo::Vec2;
using avo_io::Json;

struct Disc {
  std::string name;
  Vec2 center;
  double radius;
  std::size_t row;  // of its robot
};

/// Returns the discs of all present robots.
std::vector<Disc> discs_of(const avo::FleetView& fleet) {
  std::vector<Disc> discs;
  for (std::size_t k = 0; k < fleet.id.size(); ++k)
    for (const avo::Disc& disc : discs_at(fleet.setup[k], fleet.position[k], fleet.heading[k]))
      discs.push_back(
          {name_of(static_cast<std::int64_t>(fleet.id[k].value)), disc.center, disc.radius, k});
  return discs;
}

void append_overlap(const Disc& disc, const std::string& other, Vec2 nearest, double radius,
                    Json& contacts) {
  const Vec2 line = nearest - disc.center;
  const double distance = norm(line), depth = disc.radius + radius - distance;
  if (!(depth > 1e-9 * (disc.radius + radius))) return;  // tolerance for rounding
  // in the middle of the overlap
  const double along = distance > 0.0 ? (disc.radius - 0.5 * depth) / distance : 0.0;
  const Vec2 at = disc.center + along * line;
  contacts.push_back({{"a", disc.name}, {"b", other}, {"x", at.x}, {"y", at.y}, {"depth", depth}});
}

/// Appends the contacts of robots that have a contact by their clearance.
void append_robots(const avo::FleetView& fleet, const std::vector<Disc>& discs, Json& contacts) {
  const std::span<const float> clearance = clearances_of(fleet);
  std::vector<std::size_t> touched;
  for (std::size_t k = 0; k < discs.size(); ++k)
    if (clearance[discs[k].row] < 0.0F) touched.push_back(k);
  for (std::size_t i = 0; i < touched.size(); ++i) {
    for (std::size_t j = i + 1; j < touched.size(); ++j) {
      if (discs[touched[i]].row == discs[touched[j]].row) continue;
      const auto &a = fleet.setup[discs[touched[i]].row], &b = fleet.setup[discs[touched[j]].row];
      if (!avoids(a, b) || !avoids(b, a)) continue;
      const Disc& other = discs[touched[j]];
      append_overlap(discs[touched[i]], other.name, other.center, other.radius, contacts);
    }
  }
}

void append_walls(const avo::Simulation& simulation, const std::vector<Disc>& discs,
                  Json& contacts) {
  const avo::StaticObstacleView obstacles = simulation.obstacles();
  double largest = 0.0;
  for (const Disc& disc : discs) largest = std::max(largest, disc.radius);
  for (std::size_t k = 0; k < obstacles.id.size(); ++k) {
    const std::vector<avo::Wall> walls = avo::walls_of(obstacles.setup.subspan(k, 1));
    std::vector<double> reach;
    for (const avo::Wall& wall : walls) reach.push_back(largest + wall.radius);
    const avo::WallGrid grid(walls, reach);
    const std::string name = "obstacles." + std::to_string(obstacles.id[k].value);
    for (std::size_t i = 0; i < discs.size(); ++i) {
      if (is_parked(simulation.fleet().setup[discs[i].row])) continue;
      for (const avo::Wall& wall : grid.near(discs[i].center))
        append_overlap(discs[i], name, nearest_on({wall.a, wall.b}, discs[i].center), wall.radius,
                       contacts);
    }
  }
}

}  // namespace

std::string contacts_of(const PlaneRun& run) {
  const avo::Simulation& simulation = *run.simulation;
  const avo::FleetView fleet = simulation.fleet();
  const std::vector<Disc> discs = discs_of(fleet);
  Json contacts = Json::array();
  append_robots(fleet, discs, contacts);
  const avo::MovingObstacleView movers = simulation.moving_obstacles();
  for (std::size_t m = 0; m < movers.position.size(); ++m)
    for (const Disc& disc : discs)
      append_overlap(disc, name_of(-1 - static_cast<std::int64_t>(m)), movers.position[m],
                     movers.setup[m].radius, contacts);
  append_walls(simulation, discs, contacts);
  return contacts.dump();
}

}  // namespace avo_lab
