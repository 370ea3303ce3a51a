// SPDX-License-Identifier: Apache-2.0
// Recordings of space as CSV, and their judge.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string_view>

#include "avo/space/check.h"
#include "avo/space/metrics.h"
#include "avo_io/space.h"
#include "io/recording/csv_lines.h"
#include "io/space/space_rows.h"

namespace avo_io {
namespace {

// m: the largest deviation of the scene's quadrotors.
double deviation_of(const avo::space::Scenario& scene) {
  double largest = 0.0;
  for (const avo::space::RobotSetup& robot : scene.robots) {
    if (robot.quadrotor) largest = std::max(largest, limits_of(*robot.quadrotor).deviation);
  }
  return largest;
}

}  // namespace

SpaceCsvRecording::SpaceCsvRecording(const std::string& path) : file_(path) {
  file_.write(std::string(kSpaceColumns) + "\n");
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
  return first && *first == kSpaceColumns;
}

Judgement judge_in_space(const std::string& recording, const avo::space::Scenario& scene,
                         double tolerance, bool require_arrival, bool movers_at_rest) {
  SpaceRows rows(recording);
  avo::space::Check check(avo::space::checked_robots(scene), scene.boxes,
                          {.relative_tolerance = tolerance,
                           .arrival_distance = scene.arrival_distance,
                           .movers_at_rest = movers_at_rest},
                          avo::space::checked_movers(scene));
  Judgement judgement;
  std::optional<double> last;  // s
  while (const SpaceMoment* moment = rows.next()) {
    const double step = last ? moment->time - *last : scene.time_step;
    last = moment->time;
    if (std::abs(step - scene.time_step) > 1e-6 * scene.time_step) ++judgement.uneven_steps;
    if (step > 1.5 * scene.time_step) check.skip();
    try {
      check.add(moment->time, moment->rows, avo::space::mover_states(scene, moment->time));
    } catch (const avo::Error& error) {
      rows.fail(error.what());
    }
  }
  judgement.report = check.report();
  judgement.recording = recording;
  const avo::CheckReport& report = judgement.report;
  judgement.scene = scene.name;
  judgement.time_step = scene.time_step;
  judgement.tolerance = tolerance;
  judgement.require_arrival = require_arrival;
  judgement.scene_end = scene.duration;
  judgement.deviation = deviation_of(scene);
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
