// SPDX-License-Identifier: Apache-2.0
// The paper's Figs. 2, 3 and 5: one pair A, B, its obstacles and its reciprocal sets.
#include <algorithm>
#include <cmath>
#include <utility>

#include "avo/half_plane.h"
#include "avo/velocity_obstacle.h"
#include "figures/axes.h"
#include "figures/contour.h"
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
constexpr Color kPath{0.80, 0.30, 0.00, 1.0};
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

// Where A goes relative to B under the new relative velocity u, until they touch and beyond.
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

// The largest distance between the boundary of Eq. (29) and that by membership, in m/s.
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

}  // namespace

Caption draw_velocity_obstacle(const std::string& folder) {
  const Row row{.panels = 3};
  const Obstacle obstacle = velocity_obstacle();
  Canvas canvas(folder + "/fig-02.png", row.width, row.height());
  draw_configuration(canvas, row.box(0));
  draw_relative_motion(canvas, row.box(1), obstacle, obstacle.pair.velocity, "(b) under *v*_{AB}");
  draw_obstacle(canvas, row.box(2), obstacle, "VO^τ_{AB}",
                {{obstacle.pair.velocity, "*v*_{AB}", figures::kBlack, true}});
  canvas.finish();
  const ClosestApproach closest = closest_approach(obstacle, obstacle.pair.velocity);
  return {"2",
          "fig-02.png",
          "Velocity obstacle",
          "(a) A robot A and a moving obstacle B. (b) Their relative position while both keep "
          "their velocities; the closest approach is " +
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
  Canvas canvas(folder + "/fig-03.png", row.width, row.height());
  draw_configuration(canvas, row.box(0));
  draw_relative_motion(canvas, row.box(1), obstacle, kNewVelocity, "(b) towards *v*′_{AB}");
  draw_obstacle(canvas, row.box(2), obstacle, "AVO^{δ,τ}_{AB}",
                {{obstacle.pair.velocity, "*v*_{AB}", figures::kBlack, true},
                 {kNewVelocity, "*v*′_{AB}", kPath}});
  canvas.finish();
  const ClosestApproach closest = closest_approach(obstacle, kNewVelocity);
  return {"3",
          "fig-03.png",
          "Acceleration-velocity obstacle",
          "(a) The same pair. (b) Their relative position while *v*′ is approached by proportional "
          "control, Eq. (9); the closest approach is " +
              format("%.2f m", closest.distance) + " after " + format("%.2f s", closest.time) +
              ". (c) The acceleration-velocity obstacle for δ = 2 s, τ = 4 s, Eqs. (10)–(12), "
              "filled by exact membership, with ten of its discs.",
          "a bent horn that the discs of Eq. (11) fill; the boundary of Eq. (29) lies on that of "
          "the membership within " +
              format("%.0e m/s", boundary_error(obstacle)) + ".",
          "as printed, Eqs. (26), (29) give the points where lines from the *origin* touch a "
          "disc, and those lie inside other discs; the boundary here is touched from the center "
          "of similitude of neighboring discs."};
}

Caption draw_reciprocal_sets(const std::string& folder) {
  const Obstacle obstacle = acceleration_velocity_obstacle();
  const Pair& pair = obstacle.pair;
  const double reach = kControlTime * 2.0 * kMaxAcceleration;
  const Horizon horizon(kControlTime, obstacle.time_horizon, 0.1);
  const RelativeHalfPlane relative = half_plane(pair, reach, horizon);
  const HalfPlane plane_H{relative.plane.normal,
                          dot(relative.plane.normal, pair.velocity) + relative.plane.offset};
  const Vec2 q = pair.velocity + relative.plane.offset * relative.plane.normal;
  const Disc reachable{pair.velocity, reach};

  const Row row{.panels = 3};
  Canvas canvas(folder + "/fig-05.png", row.width, row.height());
  VelocitySpace space;
  space.view = Box{pair.velocity - Vec2{2.4, 2.4}, pair.velocity + Vec2{2.4, 2.4}};
  space.acceleration_disc = reachable;
  space.obstacles = {{obstacle, {}, ""}};
  // D(v_AB, δ a_AB) ∩ AVO by its distance function; its hull by its corners
  const auto inside = [&](Vec2 u) {
    const double gap = closest_approach(obstacle, u).distance - pair.radius;
    return std::fmax(gap / obstacle.response.gain(obstacle.time_horizon),
                     norm(u - reachable.center) - reach);
  };
  std::vector<Vec2> corners;
  for (const auto& part : figures::negative_set(*space.view, 400, inside, 1.0)) {
    corners.insert(corners.end(), part.begin(), part.end());
  }
  space.outlines = {convex_hull(corners)};
  space.points = {{pair.velocity, "*v*_{AB}", figures::kBlack, true}, {q, "*q*", kPath}};
  figures::draw_velocity_space(canvas, row.box(0), space);
  {
    const Canvas::ClipScope scope(canvas);
    canvas.clip_to_view();
    const Vec2 along = 10.0 * perpendicular(plane_H.normal);
    const Vec2 line[] = {q - along, q + along};
    canvas.add_polyline(line);
    canvas.stroke({kPath, 1.2});
    canvas.text(q - 0.13 * along, "H",
                {.size = 9.5, .color = kPath, .offset = {3.0, 4.0}, .halo = true});
  }
  write_title(canvas, row.box(0), "(a) V_{AB} and H");

  const double share = reciprocal_share(kMaxAcceleration, kMaxAcceleration);
  const auto draw_share = [&](int index, Vec2 velocity, Vec2 normal, const std::string& name) {
    VelocitySpace own;
    own.view = Box{velocity - Vec2{1.6, 1.6}, velocity + Vec2{1.6, 1.6}};
    own.acceleration_disc = Disc{velocity, kControlTime * kMaxAcceleration};
    own.half_planes = {{apportion({normal, relative.plane.offset}, velocity, share), "", true}};
    own.points = {{velocity, "*v*_" + name, figures::kBlack, true}};
    figures::draw_velocity_space(canvas, row.box(index), own);
    write_title(canvas, row.box(index), (index == 1 ? "(b) set of " : "(c) set of ") + name);
  };
  draw_share(1, kVelocityA, relative.plane.normal, "A");
  draw_share(2, kVelocityB, -relative.plane.normal, "B");
  canvas.finish();

  double support = -1e9;  // of the hull, from its corners
  for (const Vec2 corner : corners) {
    support = std::fmax(support, dot(relative.plane.normal, corner - pair.velocity));
  }
  return {"5",
          "fig-05.png",
          "Reciprocal sets",
          "(a) For the pair of Fig. 3, both with a_max = " + format("%.1f m/s²", kMaxAcceleration) +
              ": the relative velocities within reach, D(*v*, δ a) with radius " +
              format("%.1f m/s", reach) +
              ", without the obstacle (white), the hull of what the obstacle takes from them "
              "(dashed) and the half-plane H, tangent at q. (b), (c) The sets of A and of B, "
              "each with half of it, Eqs. (17)–(20).",
          "q is the point of the hull nearest to *v*; h = " +
              format("%.4f m/s", relative.plane.offset) + " in closed form, " +
              format("%.4f m/s", support) + " from the corners of the drawn set.",
          "the half-plane is exact; the paper's comes from 25 samples of the boundary."};
}

}  // namespace avo::paper
