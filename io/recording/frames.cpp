// SPDX-License-Identifier: Apache-2.0
// A recording as a sequence of pictures.
#include "avo_io/frames.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "avo_io/errors.h"
#include "avo_io/recording.h"
#include "io/recording/cubic.h"
#include "io/recording/mover_walk.h"

namespace avo_io {

/// One row of each robot and of each moving obstacle.
struct FrameRows {
  double time = 0.0;
  std::vector<avo::Vec2> position, velocity;
  std::vector<double> heading;
  std::vector<bool> there;
  std::vector<avo::Vec2> mover_position, mover_velocity;
};

namespace {

/// Interpolates along the shorter arc.
double between_headings(double a, double b, double part) {
  const double turn = std::remainder(b - a, 2.0 * std::numbers::pi);
  return a + part * turn;
}

}  // namespace

struct FrameReader::State {
  RecordingReader reader;
  MoverWalk movers;
  std::vector<bool> straight;  // of the moving obstacles, which are on trajectories
  FrameRows before, after;     // the rows before and after the requested time
  bool ended = false;
  double first_time = 0.0;

  State(const std::string& path, const avo::Scenario& scenario)
      : reader(path, static_cast<std::int64_t>(scenario.robots.size())), movers(scenario) {
    for (const avo::MovingObstacle& obstacle : scenario.moving_obstacles)
      straight.push_back(!obstacle.trajectory.empty());
    const std::size_t robots = scenario.robots.size();
    after.position.resize(robots);
    after.velocity.resize(robots);
    after.heading.resize(robots);
    for (std::size_t i = 0; i < robots; ++i) after.position[i] = scenario.robots[i].position;
    read();
    before = after;
    first_time = before.time;
  }

  void read();
  [[nodiscard]] RecordedFrame between(double time) const;
};

// Reads the next row into `after`; an absent robot keeps its last place.
void FrameReader::State::read() {
  RecordedTime moment;
  if (!reader.next(moment)) {
    ended = true;
    return;
  }
  after.time = moment.time;
  after.there.assign(after.position.size(), false);
  for (const avo::CheckedState& row : moment.rows) {
    const auto i = static_cast<std::size_t>(row.robot);
    after.there[i] = true;
    after.position[i] = row.position;
    after.velocity[i] = row.velocity;
    if (row.heading) after.heading[i] = row.heading->angle;
  }
  try {
    movers.go_to(moment.time);
  } catch (const avo::Error& error) {
    throw RecordingError(reader.place() + ": " + error.what());
  }
  after.mover_position.clear();
  after.mover_velocity.clear();
  for (std::size_t k = 0; k < straight.size(); ++k) {
    after.mover_position.push_back(movers.position(k));
    after.mover_velocity.push_back(movers.velocity(k));
  }
}

RecordedFrame FrameReader::State::between(double time) const {
  const double step = after.time - before.time;
  const double part = step > 0.0 ? std::clamp((time - before.time) / step, 0.0, 1.0) : 0.0;
  RecordedFrame frame{time, {}, {}, before.there, {}};
  for (std::size_t i = 0; i < before.position.size(); ++i) {
    const bool moves = before.there[i] && after.there[i];
    frame.position.push_back(moves ? on_cubic(before.position[i], before.velocity[i],
                                              after.position[i], after.velocity[i], part, step)
                                   : before.position[i]);
    frame.heading.push_back(moves ? between_headings(before.heading[i], after.heading[i], part)
                                  : before.heading[i]);
  }
  for (std::size_t k = 0; k < straight.size(); ++k) {
    const avo::Vec2 from = before.mover_position[k], to = after.mover_position[k];
    frame.mover_position.push_back(straight[k] ? from + part * (to - from)
                                               : on_cubic(from, before.mover_velocity[k], to,
                                                          after.mover_velocity[k], part, step));
  }
  return frame;
}

FrameReader::FrameReader(const std::string& recording, const avo::Scenario& scenario)
    : state_(std::make_unique<State>(recording, scenario)) {}
FrameReader::~FrameReader() = default;
FrameReader::FrameReader(FrameReader&&) noexcept = default;
FrameReader& FrameReader::operator=(FrameReader&&) noexcept = default;

double FrameReader::first_time() const {
  return state_->first_time;
}

std::optional<RecordedFrame> FrameReader::at(double time) {
  State& state = *state_;
  while (!state.ended && time > state.after.time) {
    state.before = state.after;
    state.read();
  }
  if (time > state.after.time) return std::nullopt;
  return state.between(time);
}

}  // namespace avo_io
