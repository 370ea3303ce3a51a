// SPDX-License-Identifier: Apache-2.0
// A scene in a loop of its own around Planner::plan, for robots that sense each other wrongly.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "density.h"
#include "output.h"
#include "run.h"
#include "sensing.h"

namespace avo::safety {
namespace {

// Fastest with which a robot still stops at its goal: w²/2a + w Δt fits into the way left.
Vec2 towards_goal(const Robot& robot, Vec2 goal, double preferred_speed, const Planner& planner) {
  const Vec2 way = goal - robot.position;
  const double distance = norm(way);
  if (!(distance > 0.0)) return {};
  const Vec2 direction = way / distance;
  const double a = robot.max_acceleration, u = a * planner.options().time_step;
  const double left = std::max(0.0, distance - planner.step_lag() * dot(robot.velocity, direction));
  return std::min(preferred_speed, std::sqrt(u * u + 2.0 * a * left) - u) * direction;
}

class Loop {
 public:
  Loop(const Scene& scene, std::uint64_t seed, const PlannerOptions& options)
      : setup_(scene.scenario.robots),
        planner_(options),
        senses_(*scene.sensing, setup_.size(), options.time_step, seed),
        detours_(setup_.size()),
        plans_(setup_.size()) {
    for (const RobotSetup& setup : setup_) {
      Robot robot;
      robot.position = setup.position;
      robot.velocity = setup.velocity;
      robot.radius = setup.radius;
      robot.max_acceleration = setup.max_acceleration;
      robot.max_speed = setup.max_speed;
      robots_.push_back(robot);
    }
    before_ = robots_;
  }

  void step() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      Robot& robot = robots_[i];
      const RobotSetup& setup = setup_[i];
      robot.preferred_velocity = towards_goal(robot, setup.goal, setup.preferred_speed, planner_);
      robot.distance_to_goal = norm(setup.goal - robot.position);
      senses_.observe(i, robots_, before_, steps_, neighbors_);
      plans_[i] = planner_.plan(robot, neighbors_, workspace_, detours_[i]);
    }
    before_ = robots_;
    for (std::size_t i = 0; i < robots_.size(); ++i) move(robots_[i], plans_[i]);
    ++steps_;
  }

  void send_all_to(Vec2 goal) {
    for (RobotSetup& setup : setup_) setup.goal = goal;
  }

  [[nodiscard]] double time() const {
    return static_cast<double>(steps_) * planner_.options().time_step;
  }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const std::vector<Robot>& robots() const { return robots_; }
  [[nodiscard]] const std::vector<RobotSetup>& setup() const { return setup_; }
  [[nodiscard]] const std::vector<Plan>& plans() const { return plans_; }

 private:
  // From v to v_1 = v + rate (v' - v) on the way s v + (Δt - s) v_1; held: v Δt + a Δt²/2.
  void move(Robot& robot, const Plan& plan) const {
    const Vec2 v = robot.velocity;
    Vec2 v_1 = v + planner_.step_rate() * (plan.new_velocity - v);
    if (norm_squared(v_1) < 0x1p-100 * norm_squared(v)) v_1 = {};  // rounding of its making
    const double lag = planner_.step_lag(), lead = planner_.options().time_step - lag;
    robot.position = robot.position + (lag * v + lead * v_1);
    robot.velocity = v_1;
  }

  std::vector<RobotSetup> setup_;
  Planner planner_;
  Senses senses_;
  std::vector<Robot> robots_, before_;
  std::vector<Neighbor> neighbors_;
  std::vector<Detour> detours_;
  std::vector<Plan> plans_;
  PlanWorkspace workspace_;
  std::int64_t steps_ = 0;
};

// The outcome, the judge and the recording of a loop.
class Observer {
 public:
  Observer(const Scene& scene, const std::string& record, Outcome& outcome)
      : scene_(scene), judge_(scene.scenario), outcome_(outcome) {
    if (!record.empty()) recording_.emplace(record);
  }

  /// True where all are at rest at their goals.
  bool observe(const Loop& loop) {
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
    judge_.observe(loop.time(), rows_);
    if (recording_) recording_->add(loop.time(), rows_);
    return at_rest && outcome_.at_goal_at_end == static_cast<std::int64_t>(rows_.size());
  }

  void note_decisions(const Loop& loop) {
    for (const Plan& plan : loop.plans()) {
      const auto status = static_cast<std::size_t>(plan.status);
      ++outcome_.decisions[std::min(status, kMostStatuses - 1)];
    }
  }

  void note_density(const Loop& loop) {
    std::vector<Vec2> places;
    for (const Robot& robot : loop.robots()) places.push_back(robot.position);
    FleetView fleet;
    fleet.position = places;
    fleet.setup = loop.setup();
    outcome_.density = std::max(outcome_.density, densest_disc(fleet));
  }

  void end() {
    outcome_.verdict = judge_.verdict();
    if (recording_) recording_->commit();
  }

 private:
  const Scene& scene_;
  Judge judge_;
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
  outcome.planner = options;
  outcome.promised = covered && scene.sensing->promised;
  Loop loop(scene, outcome.seed, options);
  Observer observer(scene, record, outcome);
  observer.observe(loop);
  Random random(outcome.seed, 7);
  const std::int64_t second = std::max<std::int64_t>(1, last_step(scenario, 1.0));
  const std::int64_t steps = last_step(scenario, scenario.duration);
  const double start = thread_seconds();
  while (loop.steps() < steps) {
    if (!scene.rallies.empty() && loop.steps() % last_step(scenario, scene.rally_period) == 0) {
      loop.send_all_to(scene.rallies[random.below(scene.rallies.size())]);
    }
    loop.step();
    observer.note_decisions(loop);
    if (!scene.rallies.empty() && loop.steps() % second == 0) observer.note_density(loop);
    if (observer.observe(loop) && scene.rallies.empty()) break;
  }
  outcome.robot_steps = loop.steps() * static_cast<std::int64_t>(scenario.robots.size());
  outcome.seconds = thread_seconds() - start;
  outcome.worst_second = outcome.seconds / static_cast<double>(outcome.robot_steps);
  observer.end();
}

}  // namespace avo::safety
