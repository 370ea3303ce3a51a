// SPDX-License-Identifier: Apache-2.0
// A run in space as two pictures side by side: from above (plan), and from the side (elevation).
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "avo/space/simulation.h"
#include "figures/figure_options.h"
#include "figures/trajectories.h"

namespace avo::figures {

/// Observer of a simulation that keeps a bounded number of frames, equally spaced in time.
class SpaceRecorder {
 public:
  explicit SpaceRecorder(std::size_t most_frames = 1024) : most_frames_(most_frames) {}
  /// Call once before the first step and once after every step.
  void observe(const space::Simulation& simulation);

  /// One time: the places of all robots and moving obstacles, m.
  struct Frame {
    double time = 0.0;  ///< s
    std::vector<Vec3> position, mover;
  };
  /// The kept frames by time, including the last observed one.
  [[nodiscard]] std::vector<Frame> frames() const;

 private:
  std::size_t most_frames_;
  std::size_t stride_ = 1, observed_ = 0;
  Frame latest_;
  std::vector<Frame> kept_;
};

/// Draws plan and elevation side by side. Returns the contents of the file at `path`.
[[nodiscard]] std::string draw_views(const space::Scenario& scenario,
                                     const std::vector<SpaceRecorder::Frame>& frames,
                                     const std::string& path, FigureOptions options = {});

/// A scene of space as one of the plane, with the elevation to the right of the plan. Robot k of n
/// is disc k of the plan, and disc n + k of the elevation. So it is with moving obstacles.
struct ViewsInPlane {
  Scenario scenario;
  Vec2 shift;  ///< m, of the elevation

  /// Returns the places of all discs.
  [[nodiscard]] std::vector<Vec2> places(const std::vector<Vec3>& positions) const;
  /// Returns the flags of all robots for all discs.
  [[nodiscard]] static std::vector<bool> twice(const std::vector<bool>& flags);
};
/// frames: all places that a picture has to contain.
[[nodiscard]] ViewsInPlane views_in_plane(const space::Scenario& scenario,
                                          const std::vector<SpaceRecorder::Frame>& frames);
/// The places of the moving obstacles at that time, s; m.
[[nodiscard]] std::vector<Vec3> movers_at(const space::Scenario& scenario, double time);

}  // namespace avo::figures
