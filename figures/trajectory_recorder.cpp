// SPDX-License-Identifier: Apache-2.0
// Keeps a bounded number of equally spaced frames of a run.
#include <algorithm>
#include <cmath>
#include <utility>

#include "avo/error.h"
#include "figures/trajectories.h"

namespace avo::figures {

TrajectoryRecorder::TrajectoryRecorder(std::size_t most_frames) : most_frames_(most_frames) {
  if (most_frames < 2) throw Error("most_frames: found less than 2, a recorder keeps 2 or more");
}

void TrajectoryRecorder::observe(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  const MovingObstacleView obstacles = simulation.moving_obstacles();
  latest_.time = simulation.time();
  if (observed_ == 0) {
    robots_.assign(fleet.id.begin(), fleet.id.end());
    latest_.position.resize(robots_.size());
    latest_.heading.resize(robots_.size());
  }
  // ids ascend in both; absent robots keep their last places
  latest_.there.assign(robots_.size(), false);
  std::size_t place = 0;
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    while (place < robots_.size() && !(robots_[place] == fleet.id[k])) ++place;
    if (place == robots_.size()) throw Error("figure: found a robot that was added in mid-run");
    latest_.position[place] = fleet.position[k], latest_.heading[place] = fleet.heading[k];
    latest_.there[place] = true;
  }
  latest_.mover_position.assign(obstacles.position.begin(), obstacles.position.end());

  if (is_repeated(simulation)) return;
  const std::size_t index = observed_++;
  if (index % stride_ != 0) return;
  if (kept_.size() == most_frames_) {
    // drops every second frame: its index is no multiple of the doubled stride
    std::size_t count = 0;
    for (std::size_t i = 0; i < kept_.size(); i += 2) {
      if (count != i) kept_[count] = std::move(kept_[i]);
      ++count;
    }
    kept_.resize(count);
    stride_ *= 2;
    if (index % stride_ != 0) return;
  }
  kept_.push_back(latest_);
}

// With free clocks, instants come at any time: one instant in each of the scene's time steps is
// enough.
bool TrajectoryRecorder::is_repeated(const Simulation& simulation) {
  const PlannerOptions& options = simulation.planner().options();
  if (options.clock == Clock::common) return false;
  const double step = std::floor(simulation.time() / options.time_step);
  return std::exchange(last_step_, step) == step;
}

std::vector<TrajectoryFrame> TrajectoryRecorder::frames() const {
  std::vector<TrajectoryFrame> frames = kept_;
  if (observed_ > 0 && frames.back().time < latest_.time) frames.push_back(latest_);
  return frames;
}

}  // namespace avo::figures
