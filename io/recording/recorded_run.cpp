// SPDX-License-Identifier: Apache-2.0
// A recorded run in the form that comparisons need.
#include "avo_io/recorded_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <span>
#include <utility>

#include "avo/checked.h"
#include "avo_io/errors.h"
#include "io/recording/block_source.h"
#include "io/recording/mover_walk.h"
#include "io/recording/recorded_states.h"

namespace avo_io {
namespace {

/// Returns the judge of motion, used for the arrivals alone: limits of robots do not
/// matter for them.
avo::Check judge_of_arrivals(const avo::Scenario& scenario) {
  std::vector<avo::CheckedRobot> robots;
  for (const avo::RobotSetup& setup : scenario.robots) robots.push_back(checked_robot(setup));
  avo::Check check(robots, {}, {.arrival_distance = scenario.arrival_distance});
  std::vector<avo::CheckedWall> walls;
  for (const avo::StaticObstacle& obstacle : scenario.obstacles)
    for (const avo::Wall& wall : avo::walls_of(std::span(&obstacle, 1)))
      walls.push_back({wall.a, wall.b, wall.radius, obstacle.layers.bits});
  check.set_walls(std::move(walls));
  return check;
}

std::optional<double> least_clearance(const BlockShape& shape, const RecordingBlock& block,
                                      std::size_t time) {
  std::optional<double> least;
  for (std::size_t i = 0; i < shape.robots; ++i) {
    const double found = block.clearance[time * shape.robots + i];
    if (std::isfinite(found) && (!least || found < *least)) least = found;
  }
  return least;
}

/// Returns all robots at their starts; none is present yet.
RecordedFrame starts_of(const avo::Scenario& scenario) {
  RecordedFrame frame;
  for (const avo::RobotSetup& setup : scenario.robots) {
    frame.position.push_back(setup.position);
    frame.heading.push_back(setup.heading);
  }
  return frame;
}

/// Advances the frame; a robot that has left keeps its last place.
void go_on(RecordedFrame& frame, double time, const std::vector<avo::CheckedState>& rows,
           const MoverWalk& movers, std::size_t obstacles) {
  frame.time = time;
  frame.there.assign(frame.position.size(), false);
  for (const avo::CheckedState& row : rows) {
    const auto i = static_cast<std::size_t>(row.robot);
    frame.there[i] = true;
    frame.position[i] = row.position;
    if (row.heading) frame.heading[i] = row.heading->angle;
  }
  frame.mover_position.clear();
  for (std::size_t k = 0; k < obstacles; ++k) frame.mover_position.push_back(movers.position(k));
}

double fastest_of(const std::vector<avo::CheckedState>& rows) {
  double fastest = 0.0;
  for (const avo::CheckedState& row : rows) fastest = std::max(fastest, norm(row.velocity));
  return fastest;
}

/// Drops every second frame, so that as many again fit in.
void thin(std::vector<RecordedFrame>& frames) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < frames.size(); k += 2) std::swap(frames[kept++], frames[k]);
  frames.resize(kept);
}

}  // namespace

RecordedRun read_run(const std::string& recording, std::size_t most_frames) {
  BlockSource source(recording);
  RecordedRun run;
  run.scenario = source.scenario();
  const BlockShape shape = source.shape();
  const auto parked =
      std::count_if(run.scenario.robots.begin(), run.scenario.robots.end(), avo::is_parked);
  run.travelers = std::ssize(run.scenario.robots) - parked;
  avo::Check check = judge_of_arrivals(run.scenario);
  MoverWalk movers(run.scenario);
  RecordedFrame frame = starts_of(run.scenario);
  std::size_t stride = 1, count = 0;  // times between kept frames; times seen so far
  while (source.next()) {
    for (std::size_t k = 0; k < source.block().times; ++k, ++count) {
      const double time = source.block().time[k];
      const std::vector<avo::CheckedState> rows = rows_of(shape, source.block(), k);
      try {
        if (source.header().every > 1) check.skip();
        check.add(time, rows);
        movers.go_to(time);
      } catch (const avo::Error& error) {
        throw RecordingError(fmt::format("{}: time {}: {}", recording, time, error.what()));
      }
      run.moments.push_back({time, check.report().arrived - parked,
                             least_clearance(shape, source.block(), k), fastest_of(rows)});
      go_on(frame, time, rows, movers, run.scenario.moving_obstacles.size());
      if (count % stride != 0) continue;
      run.frames.push_back(frame);
      if (run.frames.size() < most_frames) continue;
      thin(run.frames);
      stride *= 2;
    }
  }
  if (!run.frames.empty() && run.frames.back().time < frame.time) run.frames.push_back(frame);
  return run;
}

}  // namespace avo_io
