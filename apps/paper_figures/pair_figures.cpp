// SPDX-License-Identifier: Apache-2.0
// The paper's Figs. 2, 3 and 5: one pair A, B, its obstacles and its reciprocal sets.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "avo/half_plane.h"
#include "avo/velocity_obstacle.h"
#include "figures/axes.h"
#include "figures/colors.h"
#include "figures/contour.h"
#include "figures/hull.h"
#include "figures/velocity_space.h"
#include "figures_of_the_paper.h"
#include "panels.h"

namespace avo::paper {

using figures::Box;
using figures::Canvas;
using figures::Color;
using figures::gray;
using figures::VelocitySpace;

namespace {

// The configuration of Figs. 2(a), 3(a); the paper prints no numbers.
constexpr Disc kA{{-1.6, -1.6}, 0.5};
constexpr Disc kB{{0.9, 1.1}, 0.5};
constexpr Vec2 kVelocityA{0.9, 1.2};
constexpr Vec2 kVelocityB{-0.5, 0.1};
constexpr Vec2 kNewVelocity{0.15, 0.95};  // relative, Fig. 3(b)
constexpr double kControlTime = 2.0;      // [δ] s
constexpr double kMaxAcceleration = 0.5;  // m/s^2, of A and of B, Fig. 5
constexpr Color kPath = figures::kVermilion;
constexpr Box kVelocities{{-1.6, -1.2}, {3.2, 3.6}};

Pair pair_of_figure() {
  return {kA.center - kB.center, kVelocityA - kVelocityB, kA.radius + kB.radius};
}

Obstacle velocity_obstacle() {
  return {pair_of_figure(), Response::velocity(), 2.0};
}
Obstacle acceleration_velocity_obstacle() {
  return {pair_of_figure(), Response::proportional(kControlTime), 4.0};
}

void draw_configuration(Canvas& canvas, const Box& panel) {
  write_title(canvas, panel, "(a) configuration");
  draw_bodies(canvas, panel, {{-3.0, -3.0}, {3.0, 3.0}},
              {{kA, kVelocityA, "*p*_A"}, {kB, kVelocityB, "*p*_B", false}});
  canvas.text(kA.center + kVelocityA, "*v*_A", {.size = 8.5, .offset = {2.0, 3.0}});
  canvas.text(kB.center + kVelocityB, "*v*_B",
              {.size = 8.5, .align_x = 1.0, .offset = {-3.0, 0.0}});
}

// Draws the motion of A relative to B under the new relative velocity u, until contact and beyond.
void draw_relative_motion(Canvas& canvas, const Box& panel, const Obstacle& obstacle, Vec2 u,
                          const std::string& title) {
  write_title(canvas, panel, title);
  canvas.set_view(panel, {{-4.0, -4.0}, {2.5, 2.5}});
  {
    const Canvas::ClipScope scope(canvas);
    canvas.clip_to_view();
    canvas.add_disc({{}, obstacle.pair.radius});
    canvas.fill_and_stroke(gray(0.75), {gray(0.25), 0.8});
    std::vector<Vec2> path;
    constexpr int kPieces = 100;
    for (int k = 0; k <= kPieces; ++k) {
      path.push_back(relative_position(obstacle, u, obstacle.time_horizon * k / kPieces));
    }
    canvas.add_polyline(path);
    canvas.stroke({kPath, 1.2});
    for (int k = 0; k <= 4; ++k) {
      const double t = obstacle.time_horizon * k / 4;
      canvas.add_dot(relative_position(obstacle, u, t), 2.2);
      canvas.fill(kPath);
      canvas.text(relative_position(obstacle, u, t), format("%g s", t),
                  {.size = 7.0, .color = gray(0.2), .align_x = 1.0, .offset = {-4.0, 2.0}});
    }
    canvas.text(obstacle.pair.position, "*p*_{AB}",
                {.size = 8.5, .align_y = 1.0, .offset = {2.0, -5.0}});
    const Vec2 rim{0.8 * obstacle.pair.radius, -0.6 * obstacle.pair.radius};
    canvas.arrow({}, rim, {gray(0.2), 0.7}, 4.0);
    canvas.text(rim, "r_{AB}", {.size = 8.5, .align_y = 1.0, .offset = {1.0, -1.0}});
  }
  figures::draw_axes(canvas,
                     {.x_label = "x (m)", .y_label = "", .most_ticks_x = 6, .most_ticks_y = 6});
}

void draw_obstacle(Canvas& canvas, const Box& panel, const Obstacle& obstacle,
                   const std::string& name, std::vector<figures::LabeledPoint> points) {
  VelocitySpace space;
  space.view = kVelocities;
  space.obstacles = {{obstacle, {}, "", 10}};
  space.points = std::move(points);
  figures::draw_velocity_space(canvas, panel, space);
  write_title(canvas, panel, "(c) " + name);
}

// Returns the largest distance between the boundary of Eq. (29) and the boundary by membership, in
// m/s.
double boundary_error(const Obstacle& obstacle) {
  const Boundary edge = boundary(obstacle, 200);
  const double far = obstacle.response.gain(obstacle.time_horizon);
  double worst = 0.0;
  for (const auto* side : {&edge.left, &edge.right}) {
    for (const Vec2 u : *side) {
      const double off = closest_approach(obstacle, u).distance - obstacle.pair.radius;
      worst = std::fmax(worst, std::fabs(off) / far);
    }
  }
  return worst;
}

// The sets that Fig. 5 shows.
struct ReciprocalSets {
  Obstacle obstacle = acceleration_velocity_obstacle();
  double reach = kControlTime * 2.0 * kMaxAcceleration;  // m/s, δ (a_A + a_B)
  HalfPlane relative =
      half_plane(obstacle.pair, reach, Horizon(kControlTime, obstacle.time_horizon, 0.1))
          .plane;  // n . w >= h
  Disc reachable{obstacle.pair.velocity, reach};
  Vec2 q = obstacle.pair.velocity + relative.offset * relative.normal;
};

Box around(Vec2 center, double half) {
  return figures::grown({center, center}, half);
}

// Returns the corners of the hull of D(v_AB, δ a_AB) ∩ AVO, from the distance function of the set.
std::vector<Vec2> hull_of(const ReciprocalSets& sets) {
  const Obstacle& obstacle = sets.obstacle;
  const auto inside = [&](Vec2 u) {
    const double gap = closest_approach(obstacle, u).distance - obstacle.pair.radius;
    return std::fmax(gap / obstacle.response.gain(obstacle.time_horizon),
                     norm(u - sets.reachable.center) - sets.reach);
  };
  std::vector<Vec2> corners;
  for (const auto& part :
       figures::negative_set(around(sets.reachable.center, 2.4), 400, inside, 1.0)) {
    corners.insert(corners.end(), part.begin(), part.end());
  }
  return figures::convex_hull(corners);
}

void draw_relative_set(Canvas& canvas, const Box& panel, const ReciprocalSets& sets,
                       const std::vector<Vec2>& hull) {
  VelocitySpace space;
  space.view = around(sets.reachable.center, 2.4);
  space.acceleration_disc = sets.reachable;
  space.obstacles = {{sets.obstacle, {}, ""}};
  space.outlines = {hull};
  space.points = {{sets.obstacle.pair.velocity, "*v*_{AB}", figures::kBlack, true},
                  {sets.q, "*q*", kPath}};
  figures::draw_velocity_space(canvas, panel, space);
  write_title(canvas, panel, "(a) V_{AB} and H");
  const Canvas::ClipScope scope(canvas);
  canvas.clip_to_view();
  const Vec2 along = 10.0 * perpendicular(sets.relative.normal);
  const Vec2 line[] = {sets.q - along, sets.q + along};
  canvas.add_polyline(line);
  canvas.stroke({kPath, 1.2});
  canvas.text(sets.q - 0.13 * along, "H",
              {.size = 9.5, .color = kPath, .offset = {3.0, 4.0}, .halo = true});
}

// Draws the set of one robot: its half of the relative half-plane, within its own reach.
void draw_share(Canvas& canvas, const Box& panel, Vec2 velocity, const HalfPlane& relative,
                const std::string& name) {
  const double share = reciprocal_share(kMaxAcceleration, kMaxAcceleration);
  VelocitySpace own;
  own.view = around(velocity, 1.6);
  own.acceleration_disc = Disc{velocity, kControlTime * kMaxAcceleration};
  own.half_planes = {{apportion(relative, velocity, share), "", true}};
  own.points = {{velocity, "*v*_" + name, figures::kBlack, true}};
  figures::draw_velocity_space(canvas, panel, own);
}

}  // namespace

Caption draw_velocity_obstacle(const std::string& folder) {
  const Row row{.panels = 3};
  const Obstacle obstacle = velocity_obstacle();
  const std::string path = folder + "/fig-02.png";
  Canvas canvas(path, row.width, row.height());
  draw_configuration(canvas, row.box(0));
  draw_relative_motion(canvas, row.box(1), obstacle, obstacle.pair.velocity, "(b) under *v*_{AB}");
  draw_obstacle(canvas, row.box(2), obstacle, "VO^τ_{AB}",
                {{obstacle.pair.velocity, "*v*_{AB}", figures::kBlack, true}});
  save(path, canvas.finish());
  const ClosestApproach closest = closest_approach(obstacle, obstacle.pair.velocity);
  return {"2",
          "fig-02.png",
          "Velocity obstacle",
          "(a) A robot A and a moving obstacle B. (b) The relative position of A and B while both "
          "keep their velocities. The closest approach is " +
              format("%.2f m", closest.distance) + " after " + format("%.2f s", closest.time) +
              ", the sum of radii " + format("%.1f m", obstacle.pair.radius) +
              ". (c) The velocity obstacle for τ = 2 s, Eqs. (4)–(6), filled by exact membership, "
              "with ten of its discs.",
          "the truncated cone with its apex at the origin, touched by every disc of Eq. (5).",
          "the paper prints no numbers for its configuration; this one resembles it."};
}

Caption draw_acceleration_obstacle(const std::string& folder) {
  const Row row{.panels = 3};
  const Obstacle obstacle = acceleration_velocity_obstacle();
  const std::string path = folder + "/fig-03.png";
  Canvas canvas(path, row.width, row.height());
  draw_configuration(canvas, row.box(0));
  draw_relative_motion(canvas, row.box(1), obstacle, kNewVelocity, "(b) towards *v*′_{AB}");
  draw_obstacle(canvas, row.box(2), obstacle, "AVO^{δ,τ}_{AB}",
                {{obstacle.pair.velocity, "*v*_{AB}", figures::kBlack, true},
                 {kNewVelocity, "*v*′_{AB}", kPath}});
  save(path, canvas.finish());
  const ClosestApproach closest = closest_approach(obstacle, kNewVelocity);
  return {"3",
          "fig-03.png",
          "Acceleration-velocity obstacle",
          "(a) The same pair. (b) The relative position of the pair while *v*′ is approached by "
          "proportional control, Eq. (9). The closest approach is " +
              format("%.2f m", closest.distance) + " after " + format("%.2f s", closest.time) +
              ". (c) The acceleration-velocity obstacle for δ = 2 s, τ = 4 s, Eqs. (10)–(12), "
              "filled by exact membership, with ten of its discs.",
          "a bent horn that the discs of Eq. (11) fill; the boundary of Eq. (29) lies on that of "
          "the membership within " +
              format("%.0e m/s", boundary_error(obstacle)) + ".",
          "as printed, Eqs. (26), (29) give the points where lines from the *origin* touch a "
          "disc, and these points lie inside other discs. The boundary here is touched from the "
          "center of similitude of neighboring discs."};
}

Caption draw_reciprocal_sets(const std::string& folder) {
  const ReciprocalSets sets;
  const std::vector<Vec2> hull = hull_of(sets);
  const HalfPlane mirrored{-sets.relative.normal, sets.relative.offset};
  const Row row{.panels = 3};
  const std::string path = folder + "/fig-05.png";
  Canvas canvas(path, row.width, row.height());
  draw_relative_set(canvas, row.box(0), sets, hull);
  draw_share(canvas, row.box(1), kVelocityA, sets.relative, "A");
  write_title(canvas, row.box(1), "(b) set of A");
  draw_share(canvas, row.box(2), kVelocityB, mirrored, "B");
  write_title(canvas, row.box(2), "(c) set of B");
  save(path, canvas.finish());

  double support = -std::numeric_limits<double>::infinity();  // of the hull along the normal
  for (const Vec2 corner : hull) {
    support = std::fmax(support, dot(sets.relative.normal, corner - sets.obstacle.pair.velocity));
  }
  return {
      "5",
      "fig-05.png",
      "Reciprocal sets",
      "(a) For the pair of Fig. 3, both with a_max = " + format("%.1f m/s²", kMaxAcceleration) +
          ": the relative velocities within reach, D(*v*, δ a) with radius " +
          format("%.1f m/s", sets.reach) +
          ". White is what the obstacle leaves of these velocities, and dashed is the hull of what "
          "the obstacle takes. The half-plane H is tangent at q. (b), (c) The sets of A and of B, "
          "each with half of H, Eqs. (17)–(20).",
      "q is the point of the hull nearest to *v*. The support h is " +
          format("%.4f m/s", sets.relative.offset) + " in closed form, and " +
          format("%.4f m/s", support) + " from the corners of the drawn set.",
      "the half-plane is exact; the paper's comes from 25 samples of the boundary."};
}

}  // namespace avo::paper
