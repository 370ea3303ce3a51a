// SPDX-License-Identifier: Apache-2.0
// Moments of a run as pictures of pixels: the frames of a video.
#pragma once
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
  /// Pixels, even numbers; `world` is what is shown. The scenario has to live as long.
  MomentPainter(const Scenario& scenario, const Box& world, int width, int height);
  ~MomentPainter();
  MomentPainter(const MomentPainter&) = delete;
  MomentPainter& operator=(const MomentPainter&) = delete;

  /// Everybody in the newest frame, which is the last, of whom `there` says so, with the ways that
  /// they have come since the first. Of each pixel, row by row, blue, green, red and a byte of no
  /// meaning; valid until the next call. Throws Error where Cairo cannot draw.
  std::string_view paint(std::span<const TrajectoryFrame> frames, const std::vector<bool>& there);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What all robots, goals, static and moving obstacles cover at the start, with a margin.
Box world_of(const Scenario& scenario);

}  // namespace avo::figures
