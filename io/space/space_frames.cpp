// SPDX-License-Identifier: Apache-2.0
#include "avo_io/space_frames.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "avo_io/errors.h"
#include "io/recording/cubic.h"
#include "io/space/space_clearances.h"
#include "io/space/space_rows.h"

namespace avo_io {

/// Robots as they were at a row.
struct AVO_LOCAL SpaceRowFrame {
  SpaceFrame frame;
  std::vector<avo::Vec3> velocity;  // m/s

  void go_on(const SpaceRows& rows, const SpaceMoment& moment) {
    rows.require_known(moment, frame.position.size());
    frame.time = moment.time;
    frame.there.assign(frame.position.size(), false);
    for (const avo::space::CheckedState& row : moment.rows) {
      const auto i = static_cast<std::size_t>(row.robot);
      frame.there[i] = true;
      frame.position[i] = row.position;
      velocity[i] = row.velocity;
    }
  }
};

namespace {

using avo::Vec3;
using avo::space::CheckedState;

SpaceRowFrame starts_of(const avo::space::Scenario& scenario) {
  SpaceRowFrame starts;
  for (const avo::space::RobotSetup& robot : scenario.robots) {
    starts.frame.position.push_back(robot.position);
    starts.velocity.emplace_back();
  }
  starts.frame.there.assign(scenario.robots.size(), false);
  return starts;
}

/// Counts robots that were at their goals, and finds the least clearance.
class SpaceMoments {
 public:
  explicit SpaceMoments(const avo::space::Scenario& scenario)
      : scenario_(scenario),
        shape_{scenario.robots.size(), &kSpaceColumns},
        block_(shape_),
        clearances_(scenario),
        has_arrived_(scenario.robots.size(), false) {}

  RecordedMoment next(const SpaceMoment& moment) {
    RecordedMoment told{moment.time, 0, {}, 0.0};
    for (const CheckedState& row : moment.rows) {
      const auto i = static_cast<std::size_t>(row.robot);
      const double left = norm(row.position - scenario_.robots[i].goal);
      if (left <= scenario_.arrival_distance) has_arrived_[i] = true;
      told.fastest = std::max(told.fastest, norm(row.velocity));
    }
    told.arrived = std::count(has_arrived_.begin(), has_arrived_.end(), true);
    block_.times = 0;
    append_moment(moment, shape_, block_);
    clearances_.find(shape_, 0, block_);
    for (std::size_t i = 0; i < shape_.robots; ++i) {
      const double found = block_.clearance[i];
      if (std::isfinite(found) && (!told.clearance || found < *told.clearance))
        told.clearance = found;
    }
    return told;
  }

 private:
  const avo::space::Scenario& scenario_;
  BlockShape shape_;
  RecordingBlock block_;
  SpaceClearances clearances_;
  std::vector<bool> has_arrived_;
};

}  // namespace

struct SpaceFrameReader::State {
  SpaceRows rows;
  SpaceRowFrame before, after;
  bool ended = false;

  State(const std::string& recording, const avo::space::Scenario& scenario)
      : rows(recording), after(starts_of(scenario)) {
    read();
    before = after;
  }
  void read() {
    const SpaceMoment* moment = rows.next();
    if (moment == nullptr)
      ended = true;
    else
      after.go_on(rows, *moment);
  }
};

SpaceFrameReader::SpaceFrameReader(const std::string& recording,
                                   const avo::space::Scenario& scenario)
    : state_(std::make_unique<State>(recording, scenario)) {}
SpaceFrameReader::~SpaceFrameReader() = default;
SpaceFrameReader::SpaceFrameReader(SpaceFrameReader&&) noexcept = default;
SpaceFrameReader& SpaceFrameReader::operator=(SpaceFrameReader&&) noexcept = default;

double SpaceFrameReader::first_time() const {
  return state_->before.frame.time;
}

std::optional<SpaceFrame> SpaceFrameReader::at(double time) {
  State& state = *state_;
  while (!state.ended && time > state.after.frame.time) {
    state.before = state.after;
    state.read();
  }
  const SpaceFrame &from = state.before.frame, &to = state.after.frame;
  if (time > to.time) return std::nullopt;
  const double step = to.time - from.time;
  const double part = step > 0.0 ? std::clamp((time - from.time) / step, 0.0, 1.0) : 0.0;
  SpaceFrame frame{time, from.position, from.there};
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    if (from.there[i] && to.there[i])
      frame.position[i] = on_cubic(from.position[i], state.before.velocity[i], to.position[i],
                                   state.after.velocity[i], part, step);
  }
  return frame;
}

SpaceRun read_space_run(const std::string& recording, const avo::space::Scenario& scenario,
                        std::size_t most_frames) {
  SpaceRows rows(recording);
  SpaceRowFrame now = starts_of(scenario);
  SpaceMoments moments(scenario);
  SpaceRun run;
  std::size_t stride = 1, count = 0;  // times between kept frames; times seen so far
  while (const SpaceMoment* moment = rows.next()) {
    now.go_on(rows, *moment);
    run.moments.push_back(moments.next(*moment));
    if (count++ % stride != 0) continue;
    run.frames.push_back(now.frame);
    if (run.frames.size() < most_frames) continue;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < run.frames.size(); k += 2)
      std::swap(run.frames[kept++], run.frames[k]);
    run.frames.resize(kept);
    stride *= 2;
  }
  if (run.moments.size() < 2) rows.fail("found rows of less than two times, must be of more");
  if (run.frames.back().time != now.frame.time) run.frames.push_back(now.frame);
  return run;
}

}  // namespace avo_io
