// SPDX-License-Identifier: Apache-2.0
// Time-lapse of a run as in the paper's Figs. 1, 7, 8 and 9: discs at regular time steps, newer
// ones on top and darker, one hue a robot, moving obstacles gray, static ones below them all.
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

/// Where everybody was at one time. Columns by robot and by moving obstacle of the scene.
struct TrajectoryFrame {
  double time = 0.0;                      ///< s
  std::vector<Vec2> position{};           ///< m
  std::vector<double> heading{};          ///< rad; may be empty where all are holonomic
  std::vector<Vec2> obstacle_position{};  ///< m
  std::vector<bool> there{};              ///< the robot has not left; may be empty where none does
};

/// Observer of a simulation that keeps a bounded number of frames, equally spaced in time, however
/// long the run is: when it is full it drops every other one. No robots may be added. One that
/// leaves stays in the frames where it was.
class TrajectoryRecorder {
 public:
  explicit TrajectoryRecorder(std::size_t most_frames = 1024);  ///< >= 2
  /// Call once before the first step and once after every step.
  void observe(const Simulation& simulation);
  /// The kept frames by time, the last one observed included.
  [[nodiscard]] std::vector<TrajectoryFrame> frames() const;

 private:
  bool is_repeated(const Simulation& simulation);

  std::size_t most_frames_;
  std::size_t stride_ = 1;    // steps between kept frames
  std::size_t observed_ = 0;  // frames seen
  std::vector<RobotId> robots_;
  double last_step_ = -1.0;  // number of the scene's time step, where clocks are free
  TrajectoryFrame latest_;
  std::vector<TrajectoryFrame> kept_;
};

/// The whole run in one picture: what the file at `path` is to hold. Throws Error on a path that is
/// no figure, and where the frames do not fit the scenario.
[[nodiscard]] std::string draw_trajectories(const Scenario& scenario,
                                            std::span<const TrajectoryFrame> frames,
                                            const std::string& path,
                                            const FigureOptions& options = {});

/// One panel for each of `times` (s), side by side on one scale: everybody at that time, with the
/// last `tail` seconds as a fading trace.
[[nodiscard]] std::string draw_instants(const Scenario& scenario,
                                        std::span<const TrajectoryFrame> frames,
                                        std::span<const double> times, double tail,
                                        const std::string& path, const FigureOptions& options = {});

/// A run among others.
struct TracedRun {
  std::string title;
  Scenario scenario;
  std::vector<TrajectoryFrame> frames;
};
/// One panel for each run, side by side on one scale, as draw_trajectories() draws it.
[[nodiscard]] std::string draw_side_by_side(std::span<const TracedRun> runs,
                                            const std::string& path,
                                            const FigureOptions& options = {});

}  // namespace avo::figures
