// SPDX-License-Identifier: Apache-2.0
// Moments of a run as pictures of pixels: the frames of a video.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "avo/scenario.h"
#include "figures/canvas.h"
#include "figures/trajectories.h"

namespace avo::figures {

/// Draws moments of one scenario, all on the same scale.
class MomentPainter {
 public:
  /// The sizes are in pixels, even numbers; `world` is the visible part. The scenario must outlive
  /// this object. views: see robot_colors().
  MomentPainter(const Scenario& scenario, const Box& world, int width, int height,
                std::size_t views = 1);
  ~MomentPainter();
  MomentPainter(const MomentPainter&) = delete;
  MomentPainter& operator=(const MomentPainter&) = delete;

  /// Paints the robots of the newest (last) frame that are present by `there`, with their traces
  /// since the first frame. Returns blue, green, red and an unused byte for each pixel, row by row;
  /// valid until the next call. Throws Error if Cairo cannot draw.
  std::string_view paint(std::span<const TrajectoryFrame> frames, const std::vector<bool>& there);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the box that all robots, goals, static and moving obstacles cover at the start, with a
/// margin.
Box world_of(const Scenario& scenario);

}  // namespace avo::figures
