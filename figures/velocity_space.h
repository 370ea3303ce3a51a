// SPDX-License-Identifier: Apache-2.0
// The velocities that one robot may choose, in velocity space: the paper's Figs. 2(c), 3(c), 4(b),
// 5 and 6(a). White is allowed, and gray is forbidden.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "avo/geometry.h"
#include "avo/planner.h"
#include "avo/simulation.h"
#include "avo/velocity_obstacle.h"
#include "figures/canvas.h"
#include "figures/figure_options.h"

namespace avo::figures {

struct LabeledPlane {
  HalfPlane plane;       ///< allowed: normal . u >= offset, m/s
  std::string label;     ///< markup; empty: none
  bool binding = false;  ///< the chosen velocity lies on it
  bool forbids = true;   ///< filled; otherwise only its line is drawn, dashed
};

/// A velocity obstacle, moved by the new velocity v'_B of the neighbor that causes it.
struct LabeledObstacle {
  Obstacle obstacle;
  Vec2 offset;  ///< [v'_B] m/s
  std::string label;
  int discs = 0;        ///< number of discs of the family that are outlined, at equal steps of time
  bool forbids = true;  ///< filled; otherwise only outlined, if a half-plane replaces it
};

struct LabeledPoint {
  Vec2 at;  ///< m/s
  std::string label;
  Color color;
  bool arrow = false;  ///< from the origin, instead of a dot
};

struct VelocitySpace {
  std::optional<Disc> acceleration_disc;  ///< D(v_A, δ a_max)
  std::optional<Disc> speed_disc;         ///< D(0, v_max)
  std::vector<LabeledPlane> half_planes;
  std::vector<LabeledObstacle> obstacles;
  std::vector<LabeledPoint> points;
  /// closed, dashed, on top: a hull, or another robot's disc
  std::vector<std::vector<Vec2>> outlines;
  std::optional<Box> view;  ///< unset: the box that contains the discs and the points
};

/// Returns the sets of the planner's method and three points (the velocity, the preferred velocity
/// and the chosen velocity), from what `robot` saw and chose. Behind half-planes, it outlines the
/// obstacles that they replace, for neighbors that keep their velocity. Labels of robots are their
/// indices in the fleet. Moving obstacles are labeled o0, o1 …, and walls w0, w1 … by their indices
/// in what the robot saw. For method avo, the half-planes of the walls' obstacles are dashed,
/// because the method does not use them.
VelocitySpace velocity_space(const Simulation::Perception& perception, const Planner& planner);

/// Returns the obstacle of neighbor i in what the robot saw; its label is the neighbor's source.
LabeledObstacle obstacle_of(const Simulation::Perception& perception, std::size_t i,
                            const PlannerOptions& options);

/// Returns the boundary of the obstacle, moved by its offset, inside `view`: closed polygons, exact
/// to about 1/1000 of the view.
std::vector<std::vector<Vec2>> obstacle_outline(const LabeledObstacle& obstacle, const Box& view);

/// Draws into the present page box of a canvas, frame included.
void draw_velocity_space(Canvas& canvas, const Box& page, const VelocitySpace& space,
                         const FigureOptions& options = {});

/// Draws it as a separate figure. Returns the contents of the file at `path`. Throws Error if the
/// path is not that of a figure.
[[nodiscard]] std::string draw_velocity_space(const VelocitySpace& space, const std::string& path,
                                              const FigureOptions& options = {.width = 340.0});

}  // namespace avo::figures
