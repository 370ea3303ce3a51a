// SPDX-License-Identifier: Apache-2.0
// The recording of a run: a table of all states.
#include "avo_io/recording.h"

#include <algorithm>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "avo/checked.h"

namespace avo_io {

bool has_headings(const avo::Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const avo::RobotSetup& robot) { return !is_holonomic(robot.model); });
}

bool is_hdf5_path(std::string_view path) {
  constexpr std::string_view kEnding = ".h5";
  if (path.size() < kEnding.size()) return false;
  std::string ending(path.substr(path.size() - kEnding.size()));
  if (ending[1] == 'H') ending[1] = 'h';
  return ending == kEnding;
}

CsvRecording::CsvRecording(const std::string& path, bool headings, std::int64_t every)
    : Recording(path), headings_(headings), every_(every) {
  file_.write(fmt::format("time,robot,x,y,vx,vy{}{}\n", headings ? ",heading,speed" : "",
                          every > 1 ? ",every" : ""));
}

void CsvRecording::add(const avo::Simulation& simulation) {
  using avo::Columns;
  const avo::FleetView fleet = simulation.fleet(
      Columns::id | Columns::position | Columns::velocity | Columns::heading | Columns::setup);
  const auto end = std::back_inserter(rows_);
  const std::string time = fmt::format("{}", simulation.time());
  const std::string last = every_ > 1 ? fmt::format(",{}\n", every_) : "\n";
  rows_.clear();
  for (std::size_t k = 0; k < fleet.id.size(); ++k) {
    const avo::CheckedState state = checked_state(fleet, k);
    const avo::Vec2 p = state.position, v = state.velocity;
    fmt::format_to(end, FMT_COMPILE("{},{},{},{},{},{}"), time, state.robot, p.x, p.y, v.x, v.y);
    if (headings_ && state.heading)
      fmt::format_to(end, FMT_COMPILE(",{},{}"), state.heading->angle, state.heading->speed);
    else if (headings_)
      rows_ += ",,";
    rows_ += last;
  }
  file_.write({rows_.data(), rows_.size()});
}

void CsvRecording::finish(const avo::Simulation& /*simulation*/) {}

}  // namespace avo_io
