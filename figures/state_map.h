// SPDX-License-Identifier: Apache-2.0
// A map of the places where a robot with one velocity would be safe, doomed or neither
// (docs/states.md).
#pragma once
#include <string>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "figures/canvas.h"
#include "figures/figure_options.h"

namespace avo::figures {

/// Returns a view around the robot. It contains every place that the robot reaches while it brakes,
/// and everything that it may touch then.
Box view_of_states(const Simulation::Perception& perception);

/// Draws the map into the page box, frame included. It is white where the robot would be safe with
/// its present velocity, among the neighbors and walls that it sees. It is light where nothing is
/// proved, and dark red where the robot would be doomed. The longer side of the view has `cells`
/// cells, each judged at its middle.
void draw_state_map(Canvas& canvas, const Box& page, const Simulation::Perception& perception,
                    const Planner& planner, const Box& view, int cells,
                    const FigureOptions& options = {});

/// Draws the map as a separate figure. Returns the contents of the file at `path`. Throws Error if
/// the path is not that of a figure.
[[nodiscard]] std::string draw_state_map(const Simulation::Perception& perception,
                                         const Planner& planner, const std::string& path,
                                         const FigureOptions& options = {.width = 340.0});

}  // namespace avo::figures
