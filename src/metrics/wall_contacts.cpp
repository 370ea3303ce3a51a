// SPDX-License-Identifier: Apache-2.0
// Which robots touched a wall, and how near any robot came to one.
#include "metrics/wall_contacts.h"

#include <algorithm>
#include <limits>

namespace avo::inline metrics {

namespace {

bool concerns(LayerSet wall, const Body& robot) {
  return wall == kAllLayers || (wall.bits & robot.setup->layers.bits) != 0;
}

}  // namespace

void WallContacts::take(std::span<const StaticObstacle> obstacles) {
  walls = walls_of(obstacles);
  found_within = -1.0;
  layers.clear();
  for (const StaticObstacle& obstacle : obstacles)
    layers.resize(layers.size() + walls_of(std::span(&obstacle, 1)).size(), obstacle.layers);
}

// Makes the grid anew where the distance has changed much.
void WallContacts::find_within(double distance) {
  constexpr double kRounding = 1e-9;  // of the distance
  if (distance <= found_within && found_within <= 2.0 * distance) return;
  const std::vector<double> reach(walls.size(), distance * (1.0 + kRounding));
  grid = SegmentGrid(walls, reach, usual_cells(walls.size(), distance));
  found_within = distance;
}

void WallContacts::observe(std::span<const Body> robots, const std::optional<Response>& response,
                           double time_step) {
  touching.clear();
  if (walls.empty() || robots.empty()) return;
  double least = least_clearance.value_or(std::numeric_limits<double>::infinity());
  double reach = 0.0, thickest = 0.0;  // m
  for (const Body& robot : robots) reach = std::max(reach, robot.radius + path_length(robot));
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Wall& wall = walls[k];
    thickest = std::max(thickest, wall.radius);
    if (least_clearance) continue;
    // any robot bounds the smallest clearance: the first robot that heeds the wall, in its place
    const auto first = std::find_if(robots.begin(), robots.end(),
                                    [&](const Body& robot) { return concerns(layers[k], robot); });
    if (first == robots.end()) continue;
    const double apart = distance(first->position, Segment{wall.a, wall.b});
    least = std::min(least, apart - first->radius - wall.radius);
  }
  if (least == std::numeric_limits<double>::infinity()) return;  // no robot heeds a wall
  find_within(reach + thickest + std::max(least, 0.0));
  const auto separation_from = [&](const Body& robot, const Segment& segment, double cutoff) {
    if (robot.arc) return separation(robot.arc->path, segment, cutoff);
    if (!response || !robot.exact) return separation(robot.path, segment, cutoff);
    const ResponsePath path{robot.position, robot.velocity, robot.w, *response, time_step};
    return separation(path, segment);
  };
  for (const Body& robot : robots) {
    for (const std::uint32_t k : grid.list_at(robot.position)) {
      if (!concerns(layers[k], robot)) continue;
      const Segment segment{walls[k].a, walls[k].b};
      const double contact = robot.radius + walls[k].radius;
      const double cutoff = contact + std::max(least, 0.0);
      if (distance(robot.position, segment) - path_length(robot) > cutoff) continue;
      const double nearest = separation_from(robot, segment, cutoff);
      least = std::min(least, nearest - contact);
      if (!(nearest < contact * (1.0 - kContact))) continue;
      touched.insert(robot.name);
      touching.push_back(robot.name);
    }
  }
  least_clearance = least;
}

}  // namespace avo::inline metrics
