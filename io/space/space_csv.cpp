// SPDX-License-Identifier: Apache-2.0
// Recordings of space as CSV, and their judge.
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <string_view>
#include <system_error>
#include <vector>

#include "avo/space/check.h"
#include "avo/space/metrics.h"
#include "avo_io/space.h"
#include "io/recording/csv_lines.h"
#include "io/text/line_reader.h"

namespace avo_io {
namespace {

constexpr std::string_view kHeader = "time,robot,x,y,z,vx,vy,vz";
constexpr std::size_t kColumns = 8;

void append_number(double value, std::string& line) {
  std::array<char, 32> buffer{};  // a double has at most 24 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  line.append(buffer.data(), end);
}

/// One line of a recording.
struct SpaceRow {
  double time = 0.0;
  avo::space::CheckedState state;
};

[[noreturn]] void fail(const LineReader& lines, const std::string& what) {
  throw RecordingError(fmt::format("{}:{}: {}", lines.name(), lines.number(), what));
}

double number_of(std::string_view field, const LineReader& lines) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
    fail(lines, fmt::format("found \"{}\", must be a finite number", field));
  return value;
}

SpaceRow row_of(std::string_view line, const LineReader& lines) {
  std::array<double, kColumns> numbers{};
  std::size_t count = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    if (count < kColumns) numbers[count] = number_of(line.substr(0, comma), lines);
    ++count;
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (count != kColumns)
    fail(lines, fmt::format("found {} columns, must be {}: {}", count, kColumns, kHeader));
  constexpr double kMostRobots = 1e9;
  if (numbers[1] != std::floor(numbers[1]) || numbers[1] < 0.0 || numbers[1] > kMostRobots)
    fail(lines, fmt::format("found robot {}, must be a whole number", numbers[1]));
  return {numbers[0],
          {static_cast<std::int64_t>(numbers[1]),
           {numbers[2], numbers[3], numbers[4]},
           {numbers[5], numbers[6], numbers[7]}}};
}

// Adds all rows of one time to the judge.
void add(avo::space::Check& check, double time, std::vector<avo::space::CheckedState>& rows,
         const LineReader& lines) {
  if (rows.empty()) return;
  try {
    check.add(time, rows);
  } catch (const avo::Error& error) {
    fail(lines, error.what());
  }
  rows.clear();
}

}  // namespace

SpaceCsvRecording::SpaceCsvRecording(const std::string& path) : file_(path) {
  file_.write(std::string(kHeader) + "\n");
}

void SpaceCsvRecording::add(const avo::space::Simulation& simulation) {
  rows_.clear();
  const std::string time = csv_time(simulation.time());
  for (std::size_t k = 0; k < simulation.size(); ++k) {
    const avo::space::Robot& robot = simulation.robots()[k];
    rows_ += time;
    rows_ += ',';
    rows_ += std::to_string(k);
    for (const double x : {robot.position.x, robot.position.y, robot.position.z, robot.velocity.x,
                           robot.velocity.y, robot.velocity.z}) {
      rows_ += ',';
      append_number(x, rows_);
    }
    rows_ += '\n';
  }
  file_.write(rows_);
}

bool is_space_csv(const std::string& path) {
  if (!path.ends_with(".csv")) return false;
  LineReader lines(path);
  const auto first = lines.next();
  return first && *first == kHeader;
}

Judgement judge_in_space(const std::string& recording, const avo::space::Scenario& scene,
                         double tolerance, bool require_arrival) {
  LineReader lines(recording);
  const auto first = lines.next();
  if (!first || *first != kHeader)
    fail(lines, fmt::format("found \"{}\", must be \"{}\"", first.value_or(""), kHeader));
  avo::space::Check check(
      avo::space::checked_robots(scene), scene.boxes,
      {.relative_tolerance = tolerance, .arrival_distance = scene.arrival_distance});
  Judgement judgement;
  std::vector<avo::space::CheckedState> rows;
  double time = 0.0;
  while (const auto line = lines.next()) {
    const SpaceRow row = row_of(*line, lines);
    if (!rows.empty() && row.time != time) {
      add(check, time, rows, lines);
      const double step = row.time - time;
      const bool is_even = std::abs(step - scene.time_step) <= 1e-6 * scene.time_step;
      if (!is_even) ++judgement.uneven_steps;
      if (step > 1.5 * scene.time_step) check.skip();
    }
    time = row.time;
    rows.push_back(row.state);
  }
  add(check, time, rows, lines);
  judgement.report = check.report();
  judgement.recording = recording;
  const avo::CheckReport& report = judgement.report;
  judgement.scene = scene.name;
  judgement.time_step = scene.time_step;
  judgement.tolerance = tolerance;
  judgement.require_arrival = require_arrival;
  judgement.scene_end = scene.duration;
  judgement.whole = report.from == 0.0 &&
                    (report.arrived == report.with_goal || report.to >= scene.duration - 1e-9);
  judgement.obstacle_of_wall = scene.obstacle_of_box;
  const auto robots = static_cast<std::int64_t>(scene.robots.size());
  if (report.robots < robots)
    throw RecordingError(fmt::format("{}: found {} robots, must be {}, those of the scene",
                                     recording, report.robots, robots));
  return judgement;
}

}  // namespace avo_io
