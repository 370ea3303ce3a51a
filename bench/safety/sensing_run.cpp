// SPDX-License-Identifier: Apache-2.0
// Runs a scene whose robots sense each other wrongly, or do not act as they decide.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "density.h"
#include "fleet_loop.h"
#include "output.h"
#include "run.h"

namespace avo::safety {
namespace {

// The outcome, the judge and the recording of a loop.
class Observer {
 public:
  Observer(const Scene& scene, const std::string& record, Outcome& outcome)
      : scene_(scene), judge_(std::in_place, scene.scenario), outcome_(outcome) {
    if (!record.empty()) recording_.emplace(record);
  }

  /// Returns true if all robots are at rest at their goals.
  bool observe(const FleetLoop& loop) {
    rows_.clear();
    outcome_.at_goal_at_end = 0;
    bool at_rest = true;
    for (std::size_t i = 0; i < loop.robots().size(); ++i) {
      const Robot& robot = loop.robots()[i];
      rows_.push_back({static_cast<std::int64_t>(i), robot.position, robot.velocity});
      at_rest = at_rest && norm(robot.velocity) < 1e-3;
      const double left = norm(loop.setup()[i].goal - robot.position);
      if (!(left <= scene_.scenario.arrival_distance)) continue;
      ++outcome_.at_goal_at_end;
      outcome_.arrival[i] = std::min(outcome_.arrival[i], loop.time());
    }
    judge_->observe(loop.time() - from_, rows_);
    if (recording_) recording_->add(loop.time(), rows_);
    return at_rest && outcome_.at_goal_at_end == static_cast<std::int64_t>(rows_.size());
  }

  void note_decisions(const FleetLoop& loop) {
    for (const Plan& plan : loop.plans()) {
      const auto status = static_cast<std::size_t>(plan.status);
      ++outcome_.decisions[std::min(status, kMostStatuses - 1)];
      ++outcome_.robot_steps;
    }
  }

  void note_density(const FleetLoop& loop) {
    std::vector<Vec2> places;
    for (const Robot& robot : loop.robots()) places.push_back(robot.position);
    FleetView fleet;
    fleet.position = places;
    fleet.setup = loop.setup();
    outcome_.density = std::max(outcome_.density, densest_disc(fleet));
  }

  // Obstacles that change their acceleration are judged from one change to the next.
  void begin_part(const FleetLoop& loop) {
    outcome_.verdict.add(judge_->verdict());
    Scenario part = scene_.scenario;
    for (std::size_t k = 0; k < loop.obstacles().size(); ++k) {
      const Neighbor& now = loop.obstacles()[k];
      MovingObstacle& obstacle = part.moving_obstacles[k];
      obstacle.position = now.position;
      obstacle.velocity = now.velocity;
      obstacle.acceleration = now.acceleration;
    }
    judge_.emplace(part);
    from_ = loop.time();
    judge_->observe(0.0, rows_);
  }

  void end() {
    outcome_.verdict.add(judge_->verdict());
    if (recording_) recording_->commit();
  }

 private:
  const Scene& scene_;
  std::optional<Judge> judge_;
  double from_ = 0.0;  // s, when the judge began
  Outcome& outcome_;
  std::optional<Recording> recording_;
  std::vector<CheckedState> rows_;
};

}  // namespace

void run_sensing(const Scene& scene, const std::string& record, Outcome& outcome) {
  const Scenario& scenario = scene.scenario;
  validate(scenario);
  PlannerOptions options = planner_options(scenario);
  const bool covered = options.certificate == Certificate::braking_trajectories;
  if (covered) options.sensing_error = scene.sensing->declared;
  if (covered && scene.acting.free_clock) {
    options.clock = Clock::free;
    options.longest_step = options.time_step;
  }
  outcome.planner = options;
  outcome.promised = covered && scene.sensing->promised;
  FleetLoop loop(scene, outcome.seed, options);
  Observer observer(scene, record, outcome);
  observer.observe(loop);
  Random random(outcome.seed, 7);
  const auto ticks_of = [&](double time) {
    return scene.acting.ticks * std::max<std::int64_t>(1, last_step(scenario, time));
  };
  const std::int64_t second = ticks_of(1.0), rally = ticks_of(scene.rally_period);
  const std::int64_t ticks = ticks_of(scenario.duration);
  const double start = thread_seconds();
  while (loop.ticks() < ticks) {
    if (!scene.rallies.empty() && loop.ticks() % rally == 0) {
      loop.send_all_to(scene.rallies[random.below(scene.rallies.size())]);
    }
    if (scene.acting.whims > 0.0 && loop.ticks() % second == 0) {
      loop.turn_movers();
      observer.begin_part(loop);
    }
    loop.tick();
    observer.note_decisions(loop);
    if (!scene.rallies.empty() && loop.ticks() % second == 0) observer.note_density(loop);
    const bool all_rest = observer.observe(loop);
    if (all_rest && scene.rallies.empty() && scene.scenario.moving_obstacles.empty()) break;
  }
  outcome.seconds = thread_seconds() - start;
  outcome.worst_second = outcome.seconds / static_cast<double>(outcome.robot_steps);
  observer.end();
}

}  // namespace avo::safety
