// SPDX-License-Identifier: Apache-2.0
#include "io/space/placement.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/elementary.h"
#include "io/scene/random.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::Robot;
using avo::space::RobotSetup;
using avo::space::Scenario;

constexpr int kMostDraws = 10'000;  // for one robot

// Starts of all robots of a group, and the center that antipodal goals are reflected in.
struct Starts {
  std::vector<Vec3> places = {};  // m
  Vec3 center = {};               // m
  std::string trouble = {};
};

// m: how far p_A - p_B, of robots alike, is from contact; negative in contact.
double gap(Vec3 p, const Robot& robot) {
  p.z -= std::clamp(p.z, -robot.downwash, robot.downwash);
  return norm(p) - 2.0 * robot.radius;
}

// Turned by the golden angle from place to place, at heights evenly spaced.
Starts place(const SpherePlacement& sphere, const SpaceGroup& group, Random&, const Scenario&) {
  Starts starts{.center = sphere.center};
  const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0)), count = group.count;
  for (int k = 0; k < group.count; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / count, across = std::sqrt(1.0 - z * z);
    const avo::Vec2 axis =
        avo::elementary::direction(std::remainder(golden * k, 2.0 * std::numbers::pi));
    starts.places.push_back(sphere.center +
                            sphere.radius * Vec3{across * axis.x, across * axis.y, z});
  }
  return starts;
}

Starts place(const SpaceGridPlacement& grid, const SpaceGroup& group, Random&, const Scenario&) {
  Starts starts;
  const int layer = grid.columns * grid.rows;
  for (int k = 0; k < group.count; ++k) {
    const int column = k % grid.columns, row = k % layer / grid.columns, above = k / layer;
    const Vec3 cell{static_cast<double>(column), static_cast<double>(row),
                    static_cast<double>(above)};
    starts.places.push_back(grid.corner + grid.spacing * cell);
  }
  const int layers = (group.count + layer - 1) / layer;
  starts.center =
      grid.corner + (0.5 * grid.spacing) * Vec3{grid.columns - 1.0, grid.rows - 1.0, layers - 1.0};
  return starts;
}

Starts place(const BoxPlacement& box, const SpaceGroup& group, Random& random,
             const Scenario& scenario) {
  Starts starts{.center = 0.5 * (box.min + box.max)};
  std::vector<Vec3> taken;
  const Robot body = robot_of(group.robot);
  for (const RobotSetup& robot : scenario.robots) taken.push_back(robot.position);
  while (starts.places.size() < static_cast<std::size_t>(group.count)) {
    bool is_free = false;
    for (int draw = 0; draw < kMostDraws && !is_free; ++draw) {
      const double x = random.between(box.min.x, box.max.x);
      const double y = random.between(box.min.y, box.max.y);
      const Vec3 a{x, y, random.between(box.min.z, box.max.z)};
      is_free = std::all_of(taken.begin(), taken.end(),
                            [&](Vec3 other) { return gap(a - other, body) > box.clearance; });
      if (is_free) taken.push_back(a), starts.places.push_back(a);
    }
    if (is_free) continue;
    starts.trouble = fmt::format("box: found room for {} robots, must have room for {}",
                                 starts.places.size(), group.count);
    return starts;
  }
  return starts;
}

// A point of the ball of the jitter, uniform.
Vec3 offset(double jitter, Random& random) {
  for (;;) {
    const double x = random.between(-1.0, 1.0), y = random.between(-1.0, 1.0);
    const Vec3 a{x, y, random.between(-1.0, 1.0)};
    if (norm_squared(a) <= 1.0) return jitter * a;
  }
}

// Sattolo's algorithm: one cycle through all.
std::vector<std::size_t> permuted(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t k = count; k-- > 1;)
    std::swap(order[k], order[static_cast<std::size_t>(random.below(k))]);
  return order;
}

}  // namespace

std::string append_group(const SpaceGroup& group, std::size_t i, Scenario& scenario) {
  Random random(scenario.seed, i);
  const Starts starts = std::visit(
      [&](const auto& kind) { return place(kind, group, random, scenario); }, group.placement);
  if (!starts.trouble.empty()) return starts.trouble;
  const std::vector<std::size_t> order = permuted(starts.places.size(), random);
  for (std::size_t k = 0; k < starts.places.size(); ++k) {
    RobotSetup robot = group.robot;
    const Vec3 start = starts.places[k];
    robot.position = start;
    switch (group.goals) {
      case SpaceGoals::antipodal:
        robot.goal = 2.0 * starts.center - start;
        break;
      case SpaceGoals::permuted:
        robot.goal = starts.places[order[k]];
        break;
      case SpaceGoals::offset:
        robot.goal = start + group.offset.by;
        break;
    }
    if (group.jitter > 0.0) {
      robot.position = robot.position + offset(group.jitter, random);
      robot.goal = robot.goal + offset(group.jitter, random);
    }
    scenario.robots.push_back(robot);
  }
  return {};
}

}  // namespace avo_io
