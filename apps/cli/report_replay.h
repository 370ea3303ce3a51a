// SPDX-License-Identifier: Apache-2.0
// A recording as a drawing that a page sets in motion.
#pragma once
#include <string>
#include <vector>

#include "avo_io/frames.h"
#include "figures/canvas.h"

namespace avo_cli {

/// What is taken of a recording for a page.
struct ReportFrames {
  std::vector<avo_io::RecordedFrame> frames;  ///< by time, evenly spaced, a few hundred at most
  avo::figures::Box world;                    ///< all that is there
};
ReportFrames read_frames(const std::string& recording, const avo::Scenario& scenario, double end);

/// An SVG of the walls, goals and bodies, a circle each.
std::string drawing_of(const avo::Scenario& scenario, const ReportFrames& run);
/// The script's data: an object of times, the box and the positions.
std::string data_of(const avo::Scenario& scenario, const ReportFrames& run);

}  // namespace avo_cli
