// SPDX-License-Identifier: Apache-2.0
// Which robots touched a wall, and how near any robot came to one.
#include "metrics/wall_contacts.h"

#include <algorithm>
#include <limits>

namespace avo::inline metrics {

void WallContacts::observe(std::span<const Body> robots, const std::optional<Response>& response,
                           double time_step) {
  touching.clear();
  const std::span<const Wall> walls = search.walls();
  if (walls.empty() || robots.empty()) return;
  double least = least_clearance.value_or(std::numeric_limits<double>::infinity());
  double reach = 0.0, thickest = 0.0;  // m
  for (const Body& robot : robots) reach = std::max(reach, robot.radius + way_of(robot));
  for (const Wall& wall : walls) {
    thickest = std::max(thickest, wall.radius);
    if (least_clearance) continue;
    // any robot bounds the smallest clearance: the first one, in its place
    const double apart = distance(robots[0].position, Segment{wall.a, wall.b});
    least = std::min(least, apart - robots[0].radius - wall.radius);
  }
  search.prepare(reach + thickest + std::max(least, 0.0));
  const auto separation_from = [&](const Body& robot, const Segment& segment, double cutoff) {
    if (robot.arc) return separation(robot.arc->path, segment, cutoff);
    if (!response || !robot.exact) return separation(robot.path, segment, cutoff);
    const ResponsePath path{robot.position, robot.velocity, robot.w, *response, time_step};
    return separation(path, segment, cutoff);
  };
  for (const Body& robot : robots) {
    for (const std::size_t k : search.near(robot.position)) {
      const Segment segment{walls[k].a, walls[k].b};
      const double contact = robot.radius + walls[k].radius;
      const double cutoff = contact + std::max(least, 0.0);
      if (distance(robot.position, segment) - way_of(robot) > cutoff) continue;
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
