// SPDX-License-Identifier: Apache-2.0
// The recording of a run: a table of all states.
#include "avo_io/recording.h"

#include <algorithm>

#include "avo/checked.h"
#include "io/recording/csv_lines.h"

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
  file_.write(csv_header({headings_, every_}));
}

void CsvRecording::add(const avo::Simulation& simulation) {
  using avo::Columns;
  const avo::FleetView fleet = simulation.fleet(
      Columns::id | Columns::position | Columns::velocity | Columns::heading | Columns::setup);
  const std::string time = csv_time(simulation.time());
  rows_.clear();
  for (std::size_t k = 0; k < fleet.id.size(); ++k)
    append_csv_line(time, checked_state(fleet, k), {headings_, every_}, rows_);
  file_.write({rows_.data(), rows_.size()});
}

void CsvRecording::finish(const avo::Simulation& /*simulation*/) {}

}  // namespace avo_io
