// SPDX-License-Identifier: Apache-2.0
// Parts that several of the paper's figures share: rows of panels, robots with their velocities.
#pragma once
#include <string>
#include <vector>

#include "avo/geometry.h"
#include "figures/canvas.h"
#include "figures/colors.h"

namespace avo::paper {

/// A disc in the workspace, with an arrow for its velocity.
struct Body {
  Disc disc;      ///< m
  Vec2 velocity;  ///< m/s; the arrow is as long as the distance of one second
  std::string label;
  bool decides = true;  ///< colored; otherwise gray
};

/// Square panels in one row, each with its letter above; the widths and heights are in pt.
struct Row {
  double width = 450.0;
  int panels = 2;
  [[nodiscard]] double panel() const;
  [[nodiscard]] double height() const;
  [[nodiscard]] figures::Box box(int index) const;
};

/// Writes e.g. "(a) configuration" above a panel.
void write_title(figures::Canvas& canvas, const figures::Box& panel, const std::string& markup);

/// Draws robots and moving obstacles in the workspace, with axes in m.
void draw_bodies(figures::Canvas& canvas, const figures::Box& panel, const figures::Box& world,
                 const std::vector<Body>& bodies);

inline constexpr figures::Color kRobotColor = figures::kBlue;

}  // namespace avo::paper
