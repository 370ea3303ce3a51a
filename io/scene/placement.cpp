// SPDX-License-Identifier: Apache-2.0
// Creates the robots of groups: the benchmark scenes of the paper's §VI-B and more.
#include "io/scene/placement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <iterator>
#include <vector>

#include "core/elementary.h"
#include "io/maps/free_space.h"
#include "io/maps/wall_space.h"
#include "io/scene/circle_point.h"
#include "io/scene/reachable_draws.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr double kPi = 3.141592653589793;

/// Returns `number` centers, uniform in the rectangle of `space`. They are clear of each other, of
/// all discs in it and of the walls. It returns fewer if there is no room.
std::vector<Vec2> random_points(int number, Vec2 min, Vec2 max, double radius, FreeSpace& space,
                                const WallSpace& walls, Random& random) {
  // Tries for a disc; they find room up to about nine tenths of what is possible. That may take 2e7
  // tries in all for a million discs, and nearly all tries end in a covered cell.
  constexpr int kTries = 2000;
  const auto draw = [&](Random& from) {
    const double x = from.between(min.x, max.x);
    return Vec2{x, from.between(min.y, max.y)};
  };
  // a try draws two numbers, whatever its result: cells are fetched that many tries ahead
  Random ahead = random;
  for (int k = 0; k < 32; ++k) space.prefetch(draw(ahead));
  std::vector<Vec2> points;
  for (int i = 0; i < number; ++i) {
    int tries = 0;
    Vec2 center;
    do {
      if (++tries > kTries) return points;
      space.prefetch(draw(ahead));
      center = draw(random);
    } while (!space.is_clear(center) || !walls.is_clear(center));
    space.add({center, radius});
    points.push_back(center);
  }
  return points;
}

std::string no_room(std::string_view what, std::size_t placed, int number, std::string_view area) {
  return fmt::format("{}: found room for {} of {}, must have room for all: enlarge the {}", what,
                     placed, number, area);
}

Starts starts(const CirclePlacement& circle, int n) {
  const double radius = std::max(circle.min_radius, circle.spacing * n / (2.0 * kPi));
  Starts result{{}, circle.center};
  for (int k = 0; k < n; ++k) result.points.push_back(circle.center + radius * circle_point(k, n));
  return result;
}

Starts starts(const GridPlacement& grid, int n) {
  Starts result;
  for (int k = 0; k < n; ++k) {
    const int row = k / grid.columns, column = k % grid.columns;
    result.points.push_back(grid.corner + grid.spacing * Vec2{double(column), double(row)});
  }
  const int columns = std::min(n, grid.columns);
  const int rows = (n - 1) / grid.columns + 1;
  result.center = grid.corner + 0.5 * grid.spacing * Vec2{double(columns - 1), double(rows - 1)};
  return result;
}

Starts starts(const LinePlacement& line, int n) {
  Starts result{{}, 0.5 * (line.from + line.to)};
  for (int k = 0; k < n; ++k) {
    const double along = n > 1 ? double(k) / double(n - 1) : 0.5;
    result.points.push_back((1.0 - along) * line.from + along * line.to);
  }
  return result;
}

Starts starts(const RandomPlacement& area, const Group& group, const avo::Scenario& scenario,
              Random& random) {
  const double radius = room_of(group.robot);
  const std::size_t count = scenario.robots.size() + scenario.moving_obstacles.size();
  FreeSpace space(area.min, area.max, radius, area.clearance,
                  count + static_cast<std::size_t>(group.number));
  add_others(group, scenario, space);
  const WallSpace walls(heeded(scenario.obstacles, group.robot.layers), radius + area.clearance);
  return {random_points(group.number, area.min, area.max, radius, space, walls, random),
          0.5 * (area.min + area.max)};
}

// Places robots as CrowdNav places people: a start is drawn again if it is too near to any start or
// goal. Goals of the group itself are taken as if they were antipodal.
Starts starts(const RingPlacement& ring, const Group& group, const avo::Scenario& scenario,
              Random& random) {
  constexpr int kTries = 100000;  // for one robot
  const double radius = room_of(group.robot);
  std::vector<avo::Disc> taken;
  const auto take = [&taken](Vec2 start, Vec2 goal, double r) {
    taken.push_back({start, r}), taken.push_back({goal, r});
  };
  for (const auto& robot : scenario.robots) {
    if (keep_apart(robot, group.robot)) take(robot.position, robot.goal, room_of(robot));
  }
  for (const auto& mover : scenario.moving_obstacles)
    take(mover.position, mover.position, mover.radius);
  const WallSpace walls(heeded(scenario.obstacles, group.robot.layers), radius + ring.clearance);
  const auto is_clear = [&](Vec2 place) {
    return walls.is_clear(place) &&
           std::none_of(taken.begin(), taken.end(), [&](const avo::Disc& disc) {
             return norm(place - disc.center) < radius + disc.radius + ring.clearance;
           });
  };
  Starts result{{}, ring.center};
  for (int tries = 0; std::ssize(result.points) < group.number && tries < kTries; ++tries) {
    const double angle = random.between(-kPi, kPi);
    const double x = random.between(-ring.noise, ring.noise);
    const Vec2 off{x, random.between(-ring.noise, ring.noise)};
    const Vec2 place = ring.center + ring.radius * avo::elementary::direction(angle) + off;
    if (!is_clear(place)) continue;
    result.points.push_back(place);
    take(place, ring.center + (ring.center - place), radius);
    tries = 0;
  }
  return result;
}

std::vector<Vec2> goals(const Group& group, const Starts& from, const avo::Scenario& scenario,
                        Random& random) {
  std::vector<Vec2> result = from.points;
  if (std::holds_alternative<AntipodalGoals>(group.goals)) {
    for (Vec2& p : result) p = from.center + (from.center - p);
  } else if (const auto* offset = std::get_if<OffsetGoals>(&group.goals)) {
    for (Vec2& p : result) p = p + offset->by;
  } else if (const auto* area = std::get_if<RandomGoals>(&group.goals)) {
    const double radius = room_of(group.robot);
    FreeSpace space(area->min, area->max, radius, area->clearance, from.points.size());
    const WallSpace walls(heeded(scenario.obstacles, group.robot.layers), radius + area->clearance);
    result = random_points(group.number, area->min, area->max, radius, space, walls, random);
  } else if (const auto* formation = std::get_if<FormationGoals>(&group.goals)) {
    const std::vector<Vec2> slots =
        avo::place_slots(avo::formation_slots(formation->shape, result.size(), formation->spacing),
                         formation->center, formation->heading);
    const std::vector<std::size_t> chosen = avo::assign_slots(from.points, slots);
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = slots[chosen[k]];
  } else {
    // Sattolo's algorithm: one cycle through all
    for (std::size_t i = result.size() - 1; i > 0; --i)
      std::swap(result[i], result[static_cast<std::size_t>(random.below(i))]);
  }
  return result;
}

/// Moves each point by up to `most` (m) along x and along y.
void jitter(std::vector<Vec2>& points, double most, Random& random) {
  for (Vec2& point : points) {
    point.x += random.between(-most, most);
    point.y += random.between(-most, most);
  }
}

}  // namespace

double room_of(const avo::RobotSetup& robot) {
  return norm(disc_center(robot.model, {}, 0.0)) + disc_radius(robot);
}

void append_robot(const avo::RobotSetup& model, GroupHeading heading, Vec2 start, Vec2 goal,
                  Random& random, avo::Scenario& scenario) {
  avo::RobotSetup& robot = scenario.robots.emplace_back(model);
  robot.position = start;
  robot.goal = goal;
  if (is_holonomic(robot.model)) return;
  if (heading == GroupHeading::random) robot.heading = random.between(-kPi, kPi);
  if (heading == GroupHeading::goal) {
    const Vec2 line = goal - start;
    robot.heading = avo::elementary::atan2(line.y, line.x);
  }
}

std::string append_group(const Group& group, std::uint64_t stream, avo::Scenario& scenario) {
  Random random(scenario.seed, stream);
  const int n = group.number;
  Starts from;
  if (const auto* circle = std::get_if<CirclePlacement>(&group.placement))
    from = starts(*circle, n);
  else if (const auto* grid = std::get_if<GridPlacement>(&group.placement))
    from = starts(*grid, n);
  else if (const auto* line = std::get_if<LinePlacement>(&group.placement))
    from = starts(*line, n);
  else if (const auto* ring = std::get_if<RingPlacement>(&group.placement))
    from = starts(*ring, group, scenario, random);
  else
    from = starts(std::get<RandomPlacement>(group.placement), group, scenario, random);
  if (from.points.size() < static_cast<std::size_t>(n))
    return no_room("placement", from.points.size(), n,
                   std::holds_alternative<RingPlacement>(group.placement) ? "circle" : "rectangle");
  std::vector<Vec2> to = goals(group, from, scenario, random);
  if (to.size() < from.points.size()) return no_room("goals", to.size(), n, "rectangle");
  if (group.jitter > 0.0) {
    // a separate stream: other numbers from the seed stay as they are without it
    Random chance(scenario.seed, ~stream);
    jitter(from.points, group.jitter, chance);
    jitter(to, group.jitter, chance);
  }
  draw_reachable(group, scenario, stream, from, to);
  std::vector<avo::RobotId> robots;
  for (std::size_t i = 0; i < to.size(); ++i) {
    robots.push_back({scenario.robots.size()});
    append_robot(group.robot, group.heading, from.points[i], to[i], random, scenario);
  }
  if (group.task) scenario.teams.push_back(avo::make_team(robots, *group.task));
  return "";
}

}  // namespace avo_io
