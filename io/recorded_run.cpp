// SPDX-License-Identifier: Apache-2.0
// A recorded run as comparisons need it.
#include "avo_io/recorded_run.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "avo/checked.h"
#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "block_source.h"

namespace avo_io {
namespace {

/// The judge of motion, for the arrivals alone: of a robot's limits it is told nothing that
/// matters.
avo::Check judge_of_arrivals(const avo::Scenario& scenario) {
  std::vector<avo::CheckedRobot> robots;
  for (const avo::RobotSetup& setup : scenario.robots) robots.push_back(checked_robot(setup));
  avo::Check check(robots, {}, {.arrival_distance = scenario.arrival_distance});
  std::vector<avo::CheckedWall> walls;
  for (const avo::Wall& wall : avo::walls_of(scenario.obstacles))
    walls.push_back({wall.a, wall.b, wall.radius});
  check.set_walls(std::move(walls));
  return check;
}

/// One time of a block.
struct BlockMoment {
  const BlockShape& shape;
  const RecordingBlock& block;
  std::size_t k;

  [[nodiscard]] double value(std::size_t column, std::size_t robot) const {
    return block.row(shape, column, k)[robot];
  }
  [[nodiscard]] bool is_there(std::size_t robot) const {
    return block.status[k * shape.robots + robot] != kAbsent;
  }

  [[nodiscard]] std::vector<avo::CheckedState> rows() const {
    std::vector<avo::CheckedState> rows;
    for (std::size_t i = 0; i < shape.robots; ++i) {
      if (!is_there(i)) continue;
      avo::CheckedState& row = rows.emplace_back();
      row = {static_cast<std::int64_t>(i), {value(0, i), value(1, i)}, {value(2, i), value(3, i)}};
      if (shape.columns == kHeadingColumns && std::isfinite(value(4, i)))
        row.heading = {value(4, i), value(5, i)};
    }
    return rows;
  }

  [[nodiscard]] std::optional<double> clearance() const {
    std::optional<double> least;
    for (std::size_t i = 0; i < shape.robots; ++i) {
      const double found = block.clearance[k * shape.robots + i];
      if (std::isfinite(found) && (!least || found < *least)) least = found;
    }
    return least;
  }

  /// `places` are those of a time before.
  void move(RecordedPlaces& places) const {
    places.time = block.time[k];
    for (std::size_t i = 0; i < shape.robots; ++i) {
      if (!is_there(i)) continue;
      places.position[i] = {value(0, i), value(1, i)};
      if (!places.heading.empty() && std::isfinite(value(4, i))) places.heading[i] = value(4, i);
    }
  }
};

RecordedPlaces starts_of(const RecordedRun& run, const BlockShape& shape) {
  RecordedPlaces places;
  for (const avo::RobotSetup& setup : run.scenario.robots) {
    places.position.push_back(setup.position);
    if (shape.columns == kHeadingColumns) places.heading.push_back(setup.heading);
  }
  return places;
}

/// Drops every other one, so that there is room for as many again.
void thin(std::vector<RecordedPlaces>& places) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < places.size(); k += 2) std::swap(places[kept++], places[k]);
  places.resize(kept);
}

}  // namespace

RecordedRun read_run(const std::string& recording, std::size_t most_places) {
  BlockSource source(recording);
  RecordedRun run;
  run.scenario = parse_scenario(source.header().scene);
  const BlockShape shape = source.shape();
  if (run.scenario.robots.size() != shape.robots)
    throw RecordingError(fmt::format("{}: found {} robots, must be {}, those of its scene",
                                     recording, shape.robots, run.scenario.robots.size()));
  const auto parked = std::count_if(run.scenario.robots.begin(), run.scenario.robots.end(),
                                    [](const avo::RobotSetup& robot) { return robot.parked; });
  run.travelers = std::ssize(run.scenario.robots) - parked;
  avo::Check check = judge_of_arrivals(run.scenario);
  RecordedPlaces places = starts_of(run, shape);
  std::size_t stride = 1, count = 0;  // times between places that are kept; seen so far
  while (source.next()) {
    for (std::size_t k = 0; k < source.block().times; ++k, ++count) {
      const BlockMoment moment{shape, source.block(), k};
      try {
        if (source.header().every > 1) check.skip();
        check.add(source.block().time[k], moment.rows());
      } catch (const avo::Error& error) {
        throw RecordingError(
            fmt::format("{}: time {}: {}", recording, source.block().time[k], error.what()));
      }
      run.moments.push_back(
          {source.block().time[k], check.report().arrived - parked, moment.clearance()});
      moment.move(places);
      if (count % stride != 0) continue;
      run.places.push_back(places);
      if (run.places.size() < most_places) continue;
      thin(run.places);
      stride *= 2;
    }
  }
  if (!run.places.empty() && run.places.back().time < places.time) run.places.push_back(places);
  return run;
}

}  // namespace avo_io
