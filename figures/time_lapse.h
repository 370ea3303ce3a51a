// SPDX-License-Identifier: Apache-2.0
// Which frames of a run a time-lapse shows, and in which colors.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/scenario.h"
#include "figures/canvas.h"
#include "figures/trajectories.h"

namespace avo::figures {

/// Throws Error where a frame does not fit the scenario, a value is not finite, times do not
/// ascend, or there is no frame.
void check_frames(const Scenario& scenario, std::span<const TrajectoryFrame> frames);

/// Index of the frame from which on no robot moves any more (the last one if they never rest).
std::size_t last_motion(const Scenario& scenario, std::span<const TrajectoryFrame> frames);

/// Index of the last frame not later than `time`, 0 if there is none.
std::size_t frame_at(std::span<const TrajectoryFrame> frames, double time);

/// Indices of frames at regular times from the first to `last`, so far apart that the discs of a
/// robot at cruising speed hardly overlap, and with at most about `most_discs` discs in all.
std::vector<std::size_t> select_frames(const Scenario& scenario,
                                       std::span<const TrajectoryFrame> frames, std::size_t last,
                                       std::size_t most_discs);

/// One color a robot: a fixed set for a few robots, else by the angle at which a robot starts, seen
/// from the middle of all, so that robots with a like way have a like color.
std::vector<Color> robot_colors(const Scenario& scenario);

/// What all robots cover from frame `first` to frame `last`, goals and static obstacles included.
Box covered(const Scenario& scenario, std::span<const TrajectoryFrame> frames, std::size_t first,
            std::size_t last);

}  // namespace avo::figures
