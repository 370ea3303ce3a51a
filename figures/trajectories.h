// SPDX-License-Identifier: Apache-2.0
// Time-lapse of a run as in the paper's Figs. 1, 7, 8 and 9: discs at regular time steps, with
// newer discs on top and darker. Each robot has one hue. Moving obstacles are gray, and static
// obstacles lie below all discs.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo/vec.h"
#include "figures/figure_options.h"

namespace avo::figures {

/// The places of all robots and moving obstacles at one time. Entries go by the index of the robot,
/// or of the moving obstacle, in the scene.
struct TrajectoryFrame {
  double time = 0.0;                   ///< s
  std::vector<Vec2> position{};        ///< m
  std::vector<double> heading{};       ///< rad; may be empty if all robots are holonomic
  std::vector<Vec2> mover_position{};  ///< m
  /// whether the robot is still present; may be empty if no robot leaves
  std::vector<bool> there{};
};

/// Observer of a simulation that keeps a bounded number of frames, equally spaced in time, however
/// long the run is. When it is full, it drops every second frame. No robots may be added. A robot
/// that leaves keeps its last place in the frames.
class TrajectoryRecorder {
 public:
  explicit TrajectoryRecorder(std::size_t most_frames = 1024);  ///< >= 2
  /// Call once before the first step and once after every step.
  void observe(const Simulation& simulation);
  /// Returns the kept frames by time, including the last observed frame.
  [[nodiscard]] std::vector<TrajectoryFrame> frames() const;

 private:
  bool is_repeated(const Simulation& simulation);

  std::size_t most_frames_;
  std::size_t stride_ = 1;    // steps between kept frames
  std::size_t observed_ = 0;  // number of observed frames
  std::vector<RobotId> robots_;
  double last_step_ = -1.0;  // number of the scene's time step, with free clocks
  TrajectoryFrame latest_;
  std::vector<TrajectoryFrame> kept_;
};

/// Draws the whole run in one picture, or those robots of it that the options name. Returns the
/// contents of the file at `path`. Throws Error if the path is not that of a figure, or if the
/// frames do not fit the scenario.
[[nodiscard]] std::string draw_trajectories(const Scenario& scenario,
                                            std::span<const TrajectoryFrame> frames,
                                            const std::string& path,
                                            const FigureOptions& options = {});

/// Draws one panel for each of `times` (s), side by side on one scale. A panel shows all robots at
/// that time, with the last `tail` seconds as a fading trace.
[[nodiscard]] std::string draw_instants(const Scenario& scenario,
                                        std::span<const TrajectoryFrame> frames,
                                        std::span<const double> times, double tail,
                                        const std::string& path, const FigureOptions& options = {});

/// One of several runs in a figure.
struct TracedRun {
  std::string title;
  Scenario scenario;
  std::vector<TrajectoryFrame> frames;
  bool like_first = false;  ///< its robots are those of the first run, and have their colors
};
/// Draws one panel for each run, side by side on one scale, like draw_trajectories().
[[nodiscard]] std::string draw_side_by_side(std::span<const TracedRun> runs,
                                            const std::string& path,
                                            const FigureOptions& options = {});

}  // namespace avo::figures
