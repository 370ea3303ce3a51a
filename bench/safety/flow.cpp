// SPDX-License-Identifier: Apache-2.0
// Flows that never end: a torus, and a square that robots cross to and fro.
#include "flow.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "output.h"
#include "placement.h"

namespace avo::safety {
namespace {

constexpr int kFlowRobots = 100;
constexpr double kReached = 1.0;    // m, from a waypoint
constexpr double kStill = 0.01;     // m/s: a robot this slow stands
constexpr double kSettling = 60.0;  // s, before Outcome::late_flow counts
constexpr double kNoGoal = 1e3;     // m: on the torus, goals are never near

// Returns the difference of two coordinates, across the seam if that is shorter.
double across(double difference) {
  return difference - kFlowSide * std::round(difference / kFlowSide);
}

// The robots, and their motion in the last step.
struct Crowd {
  explicit Crowd(const Scene& scene) : flow(*scene.flow) {
    for (const RobotSetup& setup : scene.scenario.robots) {
      Robot robot;
      robot.position = setup.position;
      robot.radius = setup.radius;
      robot.max_acceleration = setup.max_acceleration;
      robot.max_speed = setup.max_speed;
      robots.push_back(robot);
      goals.push_back(setup.goal);
      speeds.push_back(setup.preferred_speed);
    }
    plans.resize(robots.size());
  }

  [[nodiscard]] Vec2 between(Vec2 from, Vec2 to) const {
    const Vec2 straight = to - from;
    if (flow == Flow::to_and_fro) return straight;
    return {across(straight.x), across(straight.y)};
  }

  // On the torus the goal represents a direction.
  [[nodiscard]] Vec2 direction(std::size_t i) const {
    const Vec2 way = flow == Flow::torus ? goals[i] : goals[i] - robots[i].position;
    return way / norm(way);
  }

  [[nodiscard]] bool is_there(std::size_t i) const {
    return flow == Flow::to_and_fro && norm(goals[i] - robots[i].position) <= kReached;
  }

  // Returns the mean over all robots of the velocity's component along the preferred velocity. A
  // robot at its waypoint has no preferred velocity.
  [[nodiscard]] double progress() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < robots.size(); ++i)
      if (!is_there(i)) sum += dot(robots[i].velocity, direction(i)) / speeds[i];
    return sum / static_cast<double>(robots.size());
  }

  Flow flow;
  std::vector<Robot> robots, before = {};
  std::vector<Vec2> goals;
  std::vector<double> speeds;  // m/s, preferred
  std::vector<Plan> plans;
};

// A loop around Planner::plan: the library's simulation has no seam.
class TorusLoop {
 public:
  TorusLoop(const Scene& scene, const PlannerOptions& options)
      : radius_(sensing_radius_of(scene.scenario)),
        planner_(options),
        detours_(scene.scenario.robots.size()) {}

  void step(Crowd& crowd) {
    for (std::size_t i = 0; i < crowd.robots.size(); ++i) crowd.plans[i] = decide(crowd, i);
    crowd.before = crowd.robots;
    const double lag = planner_.step_lag(), lead = planner_.options().time_step - lag;
    for (std::size_t i = 0; i < crowd.robots.size(); ++i) {
      Robot& robot = crowd.robots[i];
      const Vec2 next = crowd.plans[i].next_velocity;
      const Vec2 place = robot.position + lag * robot.velocity + lead * next;
      robot.position = {across(place.x), across(place.y)};
      robot.velocity = next;
    }
  }

 private:
  Plan decide(Crowd& crowd, std::size_t i) {
    Robot& robot = crowd.robots[i];
    robot.preferred_velocity = crowd.speeds[i] * crowd.direction(i);
    robot.distance_to_goal = kNoGoal;
    neighbors_.clear();
    for (std::size_t k = 0; k < crowd.robots.size(); ++k) {
      const Robot& other = crowd.robots[k];
      const Vec2 way = crowd.between(robot.position, other.position);
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

  double radius_;  // m, the sensing radius
  Planner planner_;
  std::vector<Detour> detours_;
  std::vector<Neighbor> neighbors_;
  PlanWorkspace workspace_;
};

// The library's simulation. A robot that stands at its waypoint is sent to the opposite waypoint.
class ToAndFroLoop {
 public:
  explicit ToAndFroLoop(const Scene& scene) : simulation_(scene.scenario, 1) {}

  void step(Crowd& crowd) {
    simulation_.step();
    crowd.before = crowd.robots;
    const FleetView fleet = simulation_.fleet();
    for (std::size_t i = 0; i < crowd.robots.size(); ++i) {
      crowd.robots[i].position = fleet.position[i], crowd.robots[i].velocity = fleet.velocity[i];
      crowd.plans[i] = fleet.plan[i];
    }
    for (std::size_t i = 0; i < crowd.robots.size(); ++i) {
      if (!crowd.is_there(i) || norm(crowd.robots[i].velocity) > kStill) continue;
      crowd.goals[i] = -crowd.goals[i];
      simulation_.set_goal({i}, crowd.goals[i]);
    }
  }

 private:
  Simulation simulation_;
};

// The library's judge has no seam. Accelerations are held: a pair's distance in 16 parts of a step
// is off by at most 2 a_max (Δt/16)²/8, a hundredth of a millimeter.
class FlowJudge {
 public:
  explicit FlowJudge(double time_step) : time_step_(time_step) {}

  void observe(const Crowd& crowd) {
    const std::vector<Robot>&before = crowd.before, &now = crowd.robots;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double rounding = 1.0 + 1e-9;
      const double change = norm(now[i].velocity - before[i].velocity);
      verdict_.acceleration_violations +=
          change > rounding * now[i].max_acceleration * time_step_ ? 1 : 0;
      verdict_.speed_violations += norm(now[i].velocity) > rounding * now[i].max_speed ? 1 : 0;
      for (std::size_t k = 0; k < i; ++k) observe_pair(crowd, i, k);
    }
  }

  [[nodiscard]] Verdict verdict() const {
    Verdict verdict = verdict_;
    verdict.overlapping_pairs = static_cast<std::int64_t>(overlapping_.size());
    if (!verdict.safe()) verdict.violations = "overlaps or limits exceeded";
    return verdict;
  }

 private:
  void observe_pair(const Crowd& crowd, std::size_t i, std::size_t k) {
    const Robot &a = crowd.before[i], &b = crowd.before[k];
    const Vec2 apart = crowd.between(a.position, b.position);
    const double contact = a.radius + b.radius;
    const double farthest = (a.max_speed + b.max_speed) * time_step_;
    if (norm(apart) > 2.0 * contact + farthest) return;
    const Vec2 v = b.velocity - a.velocity;
    const Vec2 v_1 = crowd.robots[k].velocity - crowd.robots[i].velocity;
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
  while (scenario.robots.size() < kFlowRobots) {
    const Vec2 place = random.in_square(kFlowSide);
    if (!is_clear(place, scenario.robots, 1.2)) continue;
    const int side = static_cast<int>(scenario.robots.size() % 4);
    const Vec2 goal = 0.5 * kFlowSide * circle_point(side, 4);
    scenario.robots.push_back(usual_robot(place, goal, 2.0));
  }
  scenario.duration = 300.0;
  if (flow == Flow::to_and_fro) scenario.arrival_distance = kReached;
  Scene scene{std::move(scenario)};
  scene.flow = flow;
  return scene;
}

void run_flow(const Scene& scene, const std::string& record, Outcome& outcome) {
  const Scenario& scenario = scene.scenario;
  validate(scenario);
  outcome.planner = planner_options(scenario);
  Crowd crowd(scene);
  std::optional<TorusLoop> torus;
  std::optional<ToAndFroLoop> to_and_fro;
  if (*scene.flow == Flow::torus)
    torus.emplace(scene, outcome.planner);
  else
    to_and_fro.emplace(scene);
  FlowJudge judge(scenario.time_step);
  std::optional<Recording> recording;
  if (!record.empty()) recording.emplace(record);
  std::vector<CheckedState> rows(scenario.robots.size());
  const std::int64_t steps = last_step(scenario, scenario.duration);
  const std::int64_t first = last_step(scenario, kSettling);
  double sum = 0.0, late = 0.0;
  const double start = thread_seconds();
  for (std::int64_t step = 1; step <= steps; ++step) {
    torus ? torus->step(crowd) : to_and_fro->step(crowd);
    judge.observe(crowd);
    for (const Plan& plan : crowd.plans)
      ++outcome.decisions[std::min(static_cast<std::size_t>(plan.status), kMostStatuses - 1)];
    outcome.robot_steps += static_cast<std::int64_t>(crowd.plans.size());
    sum += crowd.progress();
    if (step > first) late += crowd.progress();
    if (!recording) continue;
    for (std::size_t i = 0; i < rows.size(); ++i)
      rows[i] = {static_cast<std::int64_t>(i), crowd.robots[i].position, crowd.robots[i].velocity};
    recording->add(static_cast<double>(step) * scenario.time_step, rows);
  }
  outcome.seconds = thread_seconds() - start;
  outcome.flow = sum / static_cast<double>(steps);
  outcome.late_flow = late / static_cast<double>(steps - first);
  outcome.verdict = judge.verdict();
  if (recording) recording->commit();
}

}  // namespace avo::safety
