// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: a table of all states.
#include "avo_io/recording.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

#include "avo/checked.h"

namespace avo_io {

bool has_headings(const avo::Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const avo::RobotSetup& robot) { return !is_holonomic(robot.model); });
}

CsvRecording::CsvRecording(const std::string& path, bool headings, std::int64_t every)
    : file_(path), headings_(headings), every_(every) {
  file_.write(fmt::format("time,robot,x,y,vx,vy{}{}\n", headings ? ",heading,speed" : "",
                          every > 1 ? ",every" : ""));
}

void CsvRecording::add(const avo::Simulation& simulation) {
  fmt::memory_buffer row;
  const auto end = std::back_inserter(row);
  for (const avo::CheckedState& state : checked_states(simulation.fleet())) {
    const avo::Vec2 p = state.position, v = state.velocity;
    row.clear();
    fmt::format_to(end, "{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g}", simulation.time(),
                   state.robot, p.x, p.y, v.x, v.y);
    if (headings_ && state.heading)
      fmt::format_to(end, ",{},{}", state.heading->angle, state.heading->speed);
    else if (headings_)
      fmt::format_to(end, ",,");
    if (every_ > 1) fmt::format_to(end, ",{}", every_);
    row.push_back('\n');
    file_.write({row.data(), row.size()});
  }
}

}  // namespace avo_io
