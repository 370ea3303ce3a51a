// SPDX-License-Identifier: Apache-2.0
// Feeds a recording of space to its judge.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "avo/space/check.h"
#include "avo/space/metrics.h"
#include "avo_io/space.h"
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
    const bool is_later = last.has_value();
    const double step = last ? moment->time - *last : scene.time_step;
    last = moment->time;
    judgement.every = std::max(judgement.every, moment->every);
    if (std::abs(step - scene.time_step) > 1e-6 * scene.time_step) ++judgement.uneven_steps;
    if (is_later && (moment->every > 1 || step > 1.5 * scene.time_step)) check.skip();
    rows.require_known(*moment, scene.robots.size());
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
