// SPDX-License-Identifier: Apache-2.0
// Draws a robot, its goal and a moving obstacle in pictures of runs.
#include "figures/robot_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace avo::figures {
namespace {

constexpr Color kObstacle = gray(0.35);
constexpr Color kParked = gray(0.5);

// Returns a long box with a pointed nose inside the robot's disc.
std::array<Vec2, 5> car_body(Vec2 position, double heading, double radius) {
  const Vec2 ahead{radius * std::cos(heading), radius * std::sin(heading)};
  const Vec2 left = perpendicular(ahead);
  return {position - 0.8 * ahead - 0.5 * left, position + 0.4 * ahead - 0.5 * left,
          position + ahead, position + 0.4 * ahead + 0.5 * left,
          position - 0.8 * ahead + 0.5 * left};
}

// Draws its own disc with both wheels, and a line to the center of the disc that other robots see.
void draw_drive(Canvas& canvas, const DifferentialDrive& drive, const Disc& own, double heading,
                Color body, const Stroke& edge) {
  const Vec2 ahead{std::cos(heading), std::sin(heading)}, side = perpendicular(ahead);
  canvas.add_disc(own);
  canvas.fill_and_stroke(body, edge);
  canvas.add_polyline(std::array{own.center, own.center + drive.offset * ahead});
  canvas.stroke(edge);
  const Vec2 length = 0.35 * own.radius * ahead, width = 0.1 * own.radius * side;
  for (const double half : {-0.5, 0.5}) {
    const Vec2 wheel = own.center + half * drive.track * side;
    canvas.add_polygon(std::array{wheel - length - width, wheel + length - width,
                                  wheel + length + width, wheel - length + width});
    canvas.fill(edge.color);
  }
}

// Draws the discs of a footprint, and a line from the position to the foremost center.
void draw_discs(Canvas& canvas, const Footprint& footprint, const Pose& pose, Color body,
                const Stroke& edge) {
  const Vec2 ahead{std::cos(pose.heading), std::sin(pose.heading)};
  const auto add_discs = [&] {
    for (int k = 0; k < footprint.discs; ++k)
      canvas.add_disc({pose.position + footprint.ahead(k) * ahead, footprint.radius});
  };
  add_discs();
  canvas.stroke(edge);
  add_discs();  // the edges within the union are painted over
  canvas.fill(body);
  canvas.add_polyline(
      std::array{pose.position, pose.position + footprint.ahead(footprint.discs - 1) * ahead});
  canvas.stroke(edge);
}

}  // namespace

void draw_robot(Canvas& canvas, const RobotSetup& setup, const Pose& pose, Color color,
                double age) {
  if (is_parked(setup)) color = kParked;
  const Color body = mix(mix(kWhite, color, 0.13), color, age * age);
  const double radius = disc_radius(setup);
  const Stroke edge{mix(mix(kWhite, color, 0.45), mix(color, kBlack, 0.45), age * age),
                    std::clamp(0.06 * radius * canvas.scale(), 0.25, 0.7)};
  if (is_holonomic(setup.model)) {
    canvas.add_disc({pose.position, radius});
    canvas.fill_and_stroke(body, edge);
    return;
  }
  const Vec2 center = disc_center(setup.model, pose.position, pose.heading);
  if (const Footprint footprint = footprint_of(setup.model)) {
    draw_discs(canvas, footprint, {center, pose.heading}, body, edge);
    return;
  }
  if (age == 1.0) {
    canvas.add_disc({center, radius});
    canvas.fill_and_stroke(mix(kWhite, color, 0.3), edge);
  }
  if (const auto* drive = std::get_if<DifferentialDrive>(&setup.model)) {
    draw_drive(canvas, *drive, {pose.position, setup.radius}, pose.heading, body, edge);
    return;
  }
  canvas.add_polygon(car_body(center, pose.heading, radius));
  canvas.fill_and_stroke(body, edge);
}

void draw_mover(Canvas& canvas, const Disc& disc, double age) {
  canvas.add_disc(disc);
  canvas.fill_and_stroke(mix(gray(0.93), kObstacle, age * age),
                         {mix(gray(0.75), gray(0.1), age * age), 0.5});
}

void draw_goal(Canvas& canvas, const RobotSetup& setup, Color color) {
  if (is_parked(setup)) return;
  const double half = std::clamp(0.3 * setup.radius * canvas.scale(), 0.8, 3.0);
  canvas.add_cross(setup.goal, half);
  canvas.stroke({mix(color, kBlack, 0.55), std::clamp(0.3 * half, 0.35, 0.8)});
}

}  // namespace avo::figures
