// SPDX-License-Identifier: Apache-2.0
// Runs one scene from its start to its end.
#include "run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <span>
#include <utility>

#include "density.h"
#include "evadable.h"
#include "flow.h"
#include "output.h"
#include "placement.h"

namespace avo::safety {

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

namespace {

// The last step, s.
struct Span {
  double from, to;
  // Returns whether one of the consecutive periods from `start` on begins in (from, to].
  [[nodiscard]] bool begins(double period, double start = 0.0) const {
    const auto passed = [&](double time) {
      return std::floor((time - start) / period + 1e-9);  // tolerance for sums of decimal fractions
    };
    return passed(from) != passed(to);
  }
};

// Sends all robots to another of the rallying points.
void rally(const Scene& scene, Random& random, Simulation& simulation) {
  const Vec2 goal = scene.rallies[random.below(scene.rallies.size())];
  const FleetView fleet = simulation.fleet();
  const std::vector<RobotId> robots(fleet.id.begin(), fleet.id.end());
  for (const RobotId robot : robots) simulation.set_goal(robot, goal);
}

// Sends a robot on if it has reached its place, or has tried for 20 s.
void send_on(const Scene& scene, const Span& span, Random& random, Simulation& simulation) {
  if (scene.errands.empty()) return;
  for (std::size_t i = 0; i < scene.scenario.robots.size(); ++i) {
    const double start = -scene.scenario.time_step * static_cast<double>(i);
    if (!span.begins(20.0, start) && !simulation.is_at_goal({i})) continue;
    const std::vector<Vec2>& places = scene.errands[i % scene.errands.size()];
    simulation.set_goal(RobotId{i}, places[random.below(places.size())]);
  }
}

void note_arrivals(const Simulation& simulation, Outcome& outcome) {
  outcome.at_goal_at_end = 0;
  for (std::size_t i = 0; i < outcome.arrival.size(); ++i) {
    if (!simulation.is_at_goal({i})) continue;
    ++outcome.at_goal_at_end;
    outcome.arrival[i] = std::min(outcome.arrival[i], simulation.time());
  }
}

void note_decisions(const Simulation& simulation, Outcome& outcome) {
  const std::span<const Plan> plans = simulation.fleet().plan;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!simulation.decided({i})) continue;
    const auto status = static_cast<std::size_t>(plans[i].status);
    ++outcome.decisions[std::min(status, kMostStatuses - 1)];
    ++outcome.robot_steps;
  }
}

bool at_rest(const Simulation& simulation) {
  constexpr double kSlow = 1e-3;  // m/s
  const FleetView fleet = simulation.fleet();
  return std::all_of(fleet.velocity.begin(), fleet.velocity.end(),
                     [](Vec2 v) { return norm(v) < kSlow; });
}

bool moves(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  return std::any_of(fleet.velocity.begin(), fleet.velocity.end(),
                     [](Vec2 v) { return v != Vec2{}; });
}

// Measures steps and keeps the worst second.
class StepClock {
 public:
  void step(Simulation& simulation) {
    const double start = thread_seconds();
    simulation.step();
    const double taken = thread_seconds() - start;
    total_ += taken;
    second_ += taken;
  }
  // Ends a second of the scene with so many decisions.
  void end_second(std::int64_t decisions) {
    worst_ = std::max(worst_, second_ / static_cast<double>(std::max<std::int64_t>(decisions, 1)));
    second_ = 0.0;
  }
  [[nodiscard]] double total() const { return total_; }
  [[nodiscard]] double worst() const { return worst_; }

 private:
  double total_ = 0.0, second_ = 0.0, worst_ = 0.0;
};

// Returns whether the robots allow for everything that their scene does to what they sense.
bool is_covered(const Scenario& scenario) {
  const SensingError& declared = planner_options(scenario).sensing_error;
  const SensingError needed = declared_error(scenario);
  return declared.position >= needed.position && declared.velocity >= needed.velocity;
}

// Judges whether hits of a robot that is alone among moving obstacles were evadable, which is a
// fault.
void judge_hits(const Scene& scene, Verdict& verdict) {
  const std::int64_t hits = verdict.moving_contacts + verdict.resting_contacts;
  if (!scene.alone || hits == 0 || !is_evadable(scene.scenario)) return;
  verdict.evadable_hits = 1;
  verdict.violations += verdict.violations.empty() ? "" : ", ";
  verdict.violations += "hit by a mover that it could have evaded";
}

// Runs the library's simulation: every robot knows all others as the scene says.
void run_simulation(const Scene& scene, const std::string& record, Outcome& outcome) {
  Scenario scenario = scene.scenario;
  scenario.allow_broken_assumptions = true;  // the cost of that is measured as well
  Simulation simulation(scenario, 1);
  Judge judge(scenario);
  std::optional<Recording> recording;
  const bool headings =
      std::any_of(scenario.robots.begin(), scenario.robots.end(),
                  [](const RobotSetup& robot) { return !is_holonomic(robot.model); });
  if (!record.empty()) recording.emplace(record, headings);
  outcome.planner = simulation.planner().options();
  outcome.promised = is_covered(scenario);
  const auto observe = [&] {
    judge.observe(simulation);
    if (recording) recording->add(simulation);
    note_arrivals(simulation, outcome);
  };
  observe();
  Random random(outcome.seed, 7);
  StepClock clock;
  Span span{-scenario.time_step, 0.0};
  constexpr double kAwhile = 20.0;  // s
  double last_motion = 0.0;         // s
  std::int64_t before = 0;          // decisions
  // once all robots are at rest at their goals, nothing more happens unless an obstacle comes by
  const bool may_end =
      scene.rallies.empty() && scene.errands.empty() && scenario.moving_obstacles.empty();
  while (simulation.can_step_by(scenario.duration)) {
    if (!scene.rallies.empty() && span.begins(scene.rally_period)) rally(scene, random, simulation);
    send_on(scene, span, random, simulation);
    clock.step(simulation);
    observe();
    note_decisions(simulation, outcome);
    span = {span.to, simulation.time()};
    if (span.begins(1.0)) {
      clock.end_second(outcome.robot_steps - std::exchange(before, outcome.robot_steps));
      if (!scene.rallies.empty())
        outcome.density = std::max(outcome.density, densest_disc(simulation.fleet()));
    }
    if (moves(simulation)) last_motion = simulation.time();
    const bool rests = scene.until_rest ? simulation.time() - last_motion > kAwhile
                                        : simulation.all_at_goal() && at_rest(simulation);
    if (may_end && rests) break;
  }
  if (scene.until_rest) outcome.rest = simulation.time() > last_motion ? last_motion : kNever;
  outcome.seconds = clock.total();
  outcome.worst_second = clock.worst();
  outcome.verdict = judge.verdict();
  judge_hits(scene, outcome.verdict);
  if (recording) recording->commit();
}

}  // namespace

Outcome run_scene(const Scene& scene, std::uint64_t seed, const std::string& record) {
  Outcome outcome;
  outcome.seed = seed;
  outcome.arrival.assign(scene.scenario.robots.size(), kNever);
  outcome.unit = scene.unit;
  outcome.limit = scene.limit;
  outcome.share = scene.share;
  outcome.duration = scene.scenario.duration;
  if (scene.flow) {
    run_flow(scene, record, outcome);
  } else if (scene.sensing) {
    run_sensing(scene, record, outcome);
  } else {
    run_simulation(scene, record, outcome);
  }
  return outcome;
}

}  // namespace avo::safety
