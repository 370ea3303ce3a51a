// SPDX-License-Identifier: Apache-2.0
// Where a robot with one velocity would be safe, doomed or neither (docs/states.md).
#pragma once
#include <string>

#include "avo/planner.h"
#include "avo/simulation.h"
#include "figures/canvas.h"
#include "figures/figure_options.h"

namespace avo::figures {

/// Around the robot, as far as it gets while it brakes and what it may come to touch then.
Box view_of_states(const Simulation::Perception& perception);

/// White where the robot would be safe with its present velocity, beside the neighbors and walls
/// that it sees; light where nothing is proved; dark red where it would be doomed. `cells` along
/// the longer side of the view, each judged at its middle. Into the page box, frame included.
void draw_state_map(Canvas& canvas, const Box& page, const Simulation::Perception& perception,
                    const Planner& planner, const Box& view, int cells,
                    const FigureOptions& options = {});

/// As a figure of its own: what the file at `path` is to hold. Throws Error on a path that is none.
[[nodiscard]] std::string draw_state_map(const Simulation::Perception& perception,
                                         const Planner& planner, const std::string& path,
                                         const FigureOptions& options = {.width = 340.0});

}  // namespace avo::figures
