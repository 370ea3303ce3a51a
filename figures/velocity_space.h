// SPDX-License-Identifier: Apache-2.0
// What one robot may choose, in velocity space: the paper's Figs. 2(c), 3(c), 4(b), 5 and 6(a).
// White may be chosen, gray is forbidden.
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
  bool forbids = true;   ///< filled; else only its line is drawn, dashed
};

/// A velocity obstacle, moved by the new velocity v'_B of the one that causes it.
struct LabeledObstacle {
  Obstacle obstacle;
  Vec2 offset;  ///< [v'_B] m/s
  std::string label;
  int discs = 0;        ///< that many discs of the family are outlined, at equal steps of time
  bool forbids = true;  ///< filled; else only outlined, where a half-plane stands for it
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
  std::vector<std::vector<Vec2>> outlines;  ///< closed, dashed, on top: a hull, another's disc
  std::optional<Box> view;                  ///< unset: what holds the discs and the points
};

/// What `robot` saw and chose: the sets of the planner's method and three points (the velocity, the
/// preferred and the chosen one). Behind half-planes the obstacles are outlined that they stand
/// for, for others that keep their velocity. Robots are labeled by their index in the fleet, movers
/// o0, o1 …, walls w0, w1 … by their index in what the robot saw. Of method avo the half-planes of
/// the walls' obstacles are dashed: it does not look at them.
VelocitySpace velocity_space(const Simulation::Perception& perception, const Planner& planner);

/// The obstacle of neighbor i of what the robot saw; a label is its source.
LabeledObstacle obstacle_of(const Simulation::Perception& perception, std::size_t i,
                            const PlannerOptions& options);

/// Boundary of the obstacle, moved by its offset, inside `view`: closed polygons, exact to about
/// 1/1000 of the view.
std::vector<std::vector<Vec2>> obstacle_outline(const LabeledObstacle& obstacle, const Box& view);

/// Into the present page box of a canvas, frame included.
void draw_velocity_space(Canvas& canvas, const Box& page, const VelocitySpace& space,
                         const FigureOptions& options = {});

/// As a figure of its own: what the file at `path` is to hold. Throws Error on a path that is none.
[[nodiscard]] std::string draw_velocity_space(const VelocitySpace& space, const std::string& path,
                                              const FigureOptions& options = {.width = 340.0});

}  // namespace avo::figures
