// SPDX-License-Identifier: Apache-2.0
// Selects the frames of a run that a time-lapse shows, and their colors.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "figures/canvas.h"
#include "figures/trajectories.h"

namespace avo::figures {

/// Throws Error if a frame does not fit the scenario, a value is not finite, times do not ascend,
/// or there is no frame.
void check_frames(const Scenario& scenario, std::span<const TrajectoryFrame> frames);

/// Returns the index of the frame after which no robot moves any more (the last frame if they never
/// rest).
std::size_t last_motion(const Scenario& scenario, std::span<const TrajectoryFrame> frames);

/// Returns the index of the last frame not later than `time`, or 0 if there is none.
std::size_t frame_at(std::span<const TrajectoryFrame> frames, double time);

/// Returns the indices of frames at regular times from the first to `last`. They are so far apart
/// that the discs of a robot at cruising speed hardly overlap. There are at most about `most_discs`
/// discs in all.
std::vector<std::size_t> select_frames(const Scenario& scenario,
                                       std::span<const TrajectoryFrame> frames, std::size_t last,
                                       std::size_t most_discs);

/// Returns one color for each robot: a fixed set for a few robots. For more robots, the color
/// follows from the angle of the robot's start, seen from the middle of all. Robots with similar
/// motion then have similar colors. views: the robots are there so many times, one view after the
/// other, with the colors of the first one.
std::vector<Color> robot_colors(const Scenario& scenario, std::size_t views = 1);

/// Returns the box that all robots cover from frame `first` to frame `last`, goals and static
/// obstacles included.
Box covered(const Scenario& scenario, std::span<const TrajectoryFrame> frames, std::size_t first,
            std::size_t last);

}  // namespace avo::figures
