// SPDX-License-Identifier: Apache-2.0
// Flows that never end: a torus, and a square crossed to and fro.
#include "flow.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "output.h"
#include "placement.h"

namespace avo::safety {
namespace {

constexpr int kRobots = 100;
constexpr double kReached = 1.0;    // m
constexpr double kSettling = 60.0;  // s, before it counts
constexpr double kNoGoal = 1e3;     // m: on the torus goals are never near

// A difference of two coordinates, across the seam where that is shorter.
double across(double difference) {
  return difference - kFlowSide * std::round(difference / kFlowSide);
}

class FlowLoop {
 public:
  FlowLoop(const Scene& scene, const PlannerOptions& options)
      : flow_(*scene.flow), radius_(scene.scenario.sensing_radius), planner_(options) {
    for (const RobotSetup& setup : scene.scenario.robots) {
      Robot robot;
      robot.position = setup.position;
      robot.radius = setup.radius;
      robot.max_acceleration = setup.max_acceleration;
      robot.max_speed = setup.max_speed;
      robots_.push_back(robot);
      goals_.push_back(setup.goal);
      speeds_.push_back(setup.preferred_speed);
    }
    detours_.resize(robots_.size());
    plans_.resize(robots_.size());
  }

  void step() {
    for (std::size_t i = 0; i < robots_.size(); ++i) plans_[i] = decide(i);
    before_ = robots_;
    for (std::size_t i = 0; i < robots_.size(); ++i) move(i);
  }

  [[nodiscard]] Vec2 between(Vec2 from, Vec2 to) const {
    const Vec2 straight = to - from;
    if (flow_ == Flow::to_and_fro) return straight;
    return {across(straight.x), across(straight.y)};
  }

  // Mean over all robots of what their velocities have of the preferred ones.
  [[nodiscard]] double progress() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < robots_.size(); ++i)
      sum += dot(robots_[i].velocity, direction(i)) / speeds_[i];
    return sum / static_cast<double>(robots_.size());
  }

  [[nodiscard]] const std::vector<Robot>& robots() const { return robots_; }
  [[nodiscard]] const std::vector<Robot>& before() const { return before_; }
  [[nodiscard]] const std::vector<Plan>& plans() const { return plans_; }

 private:
  // On the torus the goal stands for a direction.
  [[nodiscard]] Vec2 direction(std::size_t i) const {
    const Vec2 way = flow_ == Flow::torus ? goals_[i] : goals_[i] - robots_[i].position;
    return way / norm(way);
  }

  Plan decide(std::size_t i) {
    Robot& robot = robots_[i];
    robot.preferred_velocity = speeds_[i] * direction(i);
    robot.distance_to_goal = flow_ == Flow::torus ? kNoGoal : norm(goals_[i] - robot.position);
    neighbors_.clear();
    for (std::size_t k = 0; k < robots_.size(); ++k) {
      const Robot& other = robots_[k];
      const Vec2 way = between(robot.position, other.position);
      if (k == i || norm(way) > radius_) continue;
      Neighbor neighbor;
      neighbor.position = robot.position + way;
      neighbor.velocity = other.velocity;
      neighbor.radius = other.radius;
      neighbor.max_acceleration = other.max_acceleration;
      neighbors_.push_back(neighbor);
    }
    return planner_.plan(robot, neighbors_, workspace_, &detours_[i]);
  }

  void move(std::size_t i) {
    Robot& robot = robots_[i];
    const double lag = planner_.step_lag(), lead = planner_.options().time_step - lag;
    robot.position = robot.position + lag * robot.velocity + lead * plans_[i].next_velocity;
    robot.velocity = plans_[i].next_velocity;
    if (flow_ == Flow::torus) {
      robot.position = {across(robot.position.x), across(robot.position.y)};
    } else if (norm(goals_[i] - robot.position) <= kReached) {
      goals_[i] = -goals_[i];
    }
  }

  Flow flow_;
  double radius_;  // m, of sensing
  Planner planner_;
  std::vector<Robot> robots_, before_;
  std::vector<Vec2> goals_;
  std::vector<double> speeds_;  // m/s, preferred
  std::vector<Detour> detours_;
  std::vector<Plan> plans_;
  std::vector<Neighbor> neighbors_;
  PlanWorkspace workspace_;
};

// The library's judge knows no seam. Accelerations are held: a pair's distance in 16 parts of a
// step is off by at most 2 a_max (Δt/16)²/8, a hundredth of a millimeter.
class FlowJudge {
 public:
  explicit FlowJudge(double time_step) : time_step_(time_step) {}

  void observe(const FlowLoop& loop) {
    const std::vector<Robot>&before = loop.before(), &now = loop.robots();
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double rounding = 1.0 + 1e-9;
      const double change = norm(now[i].velocity - before[i].velocity);
      verdict_.acceleration_violations +=
          change > rounding * now[i].max_acceleration * time_step_ ? 1 : 0;
      verdict_.speed_violations += norm(now[i].velocity) > rounding * now[i].max_speed ? 1 : 0;
      for (std::size_t k = 0; k < i; ++k) observe_pair(loop, i, k);
    }
  }

  [[nodiscard]] Verdict verdict() const {
    Verdict verdict = verdict_;
    verdict.overlapping_pairs = static_cast<std::int64_t>(overlapping_.size());
    if (!verdict.safe()) verdict.violations = "overlaps or limits exceeded";
    return verdict;
  }

 private:
  void observe_pair(const FlowLoop& loop, std::size_t i, std::size_t k) {
    const Robot &a = loop.before()[i], &b = loop.before()[k];
    const Vec2 apart = loop.between(a.position, b.position);
    const double contact = a.radius + b.radius;
    const double farthest = (a.max_speed + b.max_speed) * time_step_;
    if (norm(apart) > 2.0 * contact + farthest) return;
    const Vec2 v = b.velocity - a.velocity;
    const Vec2 v_1 = loop.robots()[k].velocity - loop.robots()[i].velocity;
    for (int part = 1; part <= 16; ++part) {
      const double s = part / 16.0, t = s * time_step_;
      const double clearance = norm(apart + t * (v + (0.5 * s) * (v_1 - v))) - contact;
      verdict_.least_clearance = least_of(verdict_.least_clearance, clearance);
      if (clearance < 0.0) overlapping_.insert({i, k});
    }
  }

  double time_step_;
  Verdict verdict_;
  std::set<std::pair<std::size_t, std::size_t>> overlapping_;
};

bool is_clear(Vec2 place, const std::vector<RobotSetup>& others, double distance) {
  return std::all_of(others.begin(), others.end(), [&](const RobotSetup& other) {
    const Vec2 straight = place - other.position;
    return norm(Vec2{across(straight.x), across(straight.y)}) > distance;
  });
}

}  // namespace

Scene flow_scene(Flow flow, std::uint64_t seed) {
  Scenario scenario = usual_scenario();
  Random random(seed, flow == Flow::torus ? 26 : 27);
  while (scenario.robots.size() < kRobots) {
    const Vec2 place = random.in_square(kFlowSide);
    if (!is_clear(place, scenario.robots, 1.2)) continue;
    const int side = static_cast<int>(scenario.robots.size() % 4);
    const Vec2 goal = 0.5 * kFlowSide * circle_point(side, 4);
    scenario.robots.push_back(usual_robot(place, goal, 2.0));
  }
  scenario.duration = 300.0;
  Scene scene{std::move(scenario)};
  scene.flow = flow;
  return scene;
}

void run_flow(const Scene& scene, const std::string& record, Outcome& outcome) {
  const Scenario& scenario = scene.scenario;
  validate(scenario);
  outcome.planner = planner_options(scenario);
  FlowLoop loop(scene, outcome.planner);
  FlowJudge judge(scenario.time_step);
  std::optional<Recording> recording;
  if (!record.empty()) recording.emplace(record);
  std::vector<CheckedState> rows(scenario.robots.size());
  const std::int64_t steps = last_step(scenario, scenario.duration);
  const std::int64_t first = last_step(scenario, kSettling);
  double sum = 0.0;
  const double start = thread_seconds();
  for (std::int64_t step = 1; step <= steps; ++step) {
    loop.step();
    judge.observe(loop);
    for (const Plan& plan : loop.plans())
      ++outcome.decisions[std::min(static_cast<std::size_t>(plan.status), kMostStatuses - 1)];
    outcome.robot_steps += static_cast<std::int64_t>(loop.plans().size());
    if (step > first) sum += loop.progress();
    if (!recording) continue;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Robot& robot = loop.robots()[i];
      rows[i] = {static_cast<std::int64_t>(i), robot.position, robot.velocity};
    }
    recording->add(static_cast<double>(step) * scenario.time_step, rows);
  }
  outcome.seconds = thread_seconds() - start;
  outcome.flow = sum / static_cast<double>(steps - first);
  outcome.verdict = judge.verdict();
  if (recording) recording->commit();
}

}  // namespace avo::safety
