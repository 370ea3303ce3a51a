// SPDX-License-Identifier: Apache-2.0
// The paper's Figs. 4 and 6(a): one robot amid others; first they only move, and then they decide
// too.
#include <algorithm>
#include <cmath>

#include "avo/planner.h"
#include "figures/velocity_space.h"
#include "figures_of_the_paper.h"
#include "panels.h"

namespace avo::paper {

using figures::Box;
using figures::Canvas;
using figures::VelocitySpace;

namespace {

constexpr Box kWorkspace{{-6.0, -6.0}, {6.0, 6.0}};

// The configuration of Fig. 4(a); the paper prints no numbers.
Robot robot_of_figure() {
  Robot robot;
  robot.position = {0.0, 0.0};
  robot.velocity = {0.3, 0.5};
  robot.preferred_velocity = {0.8, 1.2};
  robot.radius = 0.5;
  robot.max_acceleration = 1.0;
  robot.max_speed = 100.0;  // the figures of the paper have no speed limit
  return robot;
}

std::vector<Neighbor> neighbors_of_figure(Behavior behavior) {
  struct Mover {
    Vec2 position, velocity;
  };
  std::vector<Neighbor> neighbors;
  for (const Mover& mover : {Mover{{2.9, 4.1}, {-0.7, -0.6}}, Mover{{-4.2, 3.0}, {0.7, -0.4}},
                             Mover{{4.6, -1.2}, {-0.8, 0.5}}, Mover{{-4.0, -3.0}, {0.5, 0.9}},
                             Mover{{0.8, -4.3}, {-0.3, 0.9}}}) {
    Neighbor neighbor;
    neighbor.position = mover.position;
    neighbor.velocity = mover.velocity;
    neighbor.radius = 0.5;
    neighbor.behavior = behavior;
    neighbors.push_back(neighbor);
  }
  return neighbors;
}

Planner planner_of_figure() {
  PlannerOptions options = default_options(Method::avo_paper);
  options.control_time = 2.0;
  options.time_horizon = 4.0;
  return Planner(options);
}

// Returns the sets as the planner sees them; the speed limit is outside the view.
VelocitySpace space_of(const std::vector<Neighbor>& neighbors, bool among_movers) {
  Simulation::Perception seen;
  seen.robot = robot_of_figure();
  seen.neighbors = neighbors;
  seen.among_movers = among_movers;
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    seen.source.push_back(static_cast<int>(i) + 1);
  }
  VelocitySpace space = figures::velocity_space(seen, planner_of_figure());
  space.speed_disc.reset();
  space.points[0].label = "*v*_A";
  space.points[1].label = "*v*_A^{pref}";
  space.points[2].label = "*v*′_A";
  space.view = figures::grown(figures::enclosing(*space.acceleration_disc), 0.5);
  return space;
}

void draw_configuration(Canvas& canvas, const Box& panel, bool decide) {
  const Robot robot = robot_of_figure();
  std::vector<Body> bodies{{{robot.position, robot.radius}, robot.velocity, "A"}};
  int number = 1;
  for (const Neighbor& neighbor : neighbors_of_figure(Behavior::moves_on)) {
    bodies.push_back({{neighbor.position, neighbor.radius},
                      neighbor.velocity,
                      std::to_string(number++),
                      decide});
  }
  write_title(canvas, panel, "(a) configuration");
  draw_bodies(canvas, panel, kWorkspace, bodies);
}

// Returns the area of the allowed velocities, by counting points of a grid.
std::string area_of(const VelocitySpace& space) {
  constexpr int kSide = 200;
  const Disc& disc = *space.acceleration_disc;
  const double step = 2.0 * disc.radius / kSide;
  int count = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const int column = i % kSide;
    const int row = i / kSide;
    const Vec2 from_corner{(column + 0.5) * step, (row + 0.5) * step};
    const Vec2 u = disc.center - Vec2{disc.radius, disc.radius} + from_corner;
    if (norm(u - disc.center) > disc.radius) continue;
    const bool allowed =
        std::none_of(space.half_planes.begin(), space.half_planes.end(),
                     [u](const auto& labeled) { return violation(labeled.plane, u) > 0.0; }) &&
        std::none_of(space.obstacles.begin(), space.obstacles.end(), [u](const auto& labeled) {
          return contains(labeled.obstacle, u - labeled.offset);
        });
    if (allowed) ++count;
  }
  return format("%.1f (m/s)²", count * step * step);
}

std::string point(Vec2 at) {
  return std::string("(") + format("%.2f", at.x) + ", " + format("%.2f", at.y) + ")";
}

}  // namespace

Caption draw_among_movers(const std::string& folder) {
  const Row row{.width = 430.0};
  const std::string path = folder + "/fig-04.png";
  Canvas canvas(path, row.width, row.height());
  draw_configuration(canvas, row.box(0), false);
  const auto neighbors = neighbors_of_figure(Behavior::moves_on);
  const VelocitySpace space = space_of(neighbors, true);
  figures::draw_velocity_space(canvas, row.box(1), space);
  write_title(canvas, row.box(1), "(b) obstacles and CA_A");
  save(path, canvas.finish());
  PlanWorkspace workspace;
  const Plan plan = planner_of_figure().plan_among_movers(robot_of_figure(), neighbors, workspace);
  return {"4",
          "fig-04.png",
          "One robot among moving obstacles",
          "(a) A robot and five moving obstacles with their velocities. (b) The union of their "
          "acceleration-velocity obstacles for δ = 2 s, τ = 4 s, each moved by *v*′_B, within "
          "the disc D(*v*_A, δ a_max); white is CA_A, Eq. (13). From the preferred velocity " +
              point(robot_of_figure().preferred_velocity) + " m/s the planner goes to " +
              point(plan.new_velocity) + " m/s (" + to_string(plan.status) + "), Eq. (14).",
          "the free set is what remains of the disc, " + area_of(space) +
              " in several parts, and the choice is its point nearest to the preferred velocity.",
          "the paper prints no numbers for its configuration. Candidates for the choice include "
          "the intersections with the disc, which the paper's list leaves out."};
}

Caption draw_half_planes(const std::string& folder) {
  const Row row{.width = 430.0};
  const std::string path = folder + "/fig-06.png";
  Canvas canvas(path, row.width, row.height());
  draw_configuration(canvas, row.box(0), true);
  const auto neighbors = neighbors_of_figure(Behavior::decides);
  const VelocitySpace space = space_of(neighbors, false);
  figures::draw_velocity_space(canvas, row.box(1), space);
  write_title(canvas, row.box(1), "(b) half-planes and CA_A");
  save(path, canvas.finish());
  PlanWorkspace workspace;
  const Plan plan = planner_of_figure().plan(robot_of_figure(), neighbors, workspace);
  return {
      "6(a)",
      "fig-06.png",
      "Several robots that decide",
      "The configuration of Fig. 4 with robots that all decide and have the same a_max: the " +
          std::to_string(space.half_planes.size()) +
          " half-planes that cut into the disc, by the number of the neighbor, and CA_A "
          "(white), Eq. (22); dashed, the obstacles that they stand for. The linear program goes "
          "to " +
          point(plan.new_velocity) + " m/s (" + to_string(plan.status) + "), Eq. (23).",
      "CA_A is convex, " + area_of(space) + "; that of Fig. 4 is not, with " +
          area_of(space_of(neighbors_of_figure(Behavior::moves_on), true)) + ".",
      "half-planes that the whole disc satisfies are not shown."};
}

}  // namespace avo::paper
