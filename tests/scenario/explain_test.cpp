// SPDX-License-Identifier: Apache-2.0
// Explanations of decisions, of every robot of the pinned runs and of other built-in scenes. Each
// explanation ends in what the robot does, and each stage follows from the one before it. Robots
// that stand have a reason with a name.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/explanation.h"
#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "hashes/pinned_runs.h"

namespace avo_test {
namespace {

using avo::Explanation;
using avo::PlanStatus;
using avo::Simulation;
using avo::Vec2;

constexpr double kTolerance = 1e-6;  // m/s

struct ExplainedRun {
  std::string scene;
  std::vector<std::string> overrides = {};
};

// The pinned runs, other scenes, and the scene of the doorway and of movers by each method.
std::vector<ExplainedRun> runs() {
  std::vector<ExplainedRun> all;
  for (const PinnedRun& run : pinned_runs()) all.push_back({run.scene, run.overrides});
  for (const char* scene :
       {"circle-24", "doorway", "office", "corridor-one-lane", "bottleneck", "maze", "mixed-fleet",
        "crossing-streams", "moving-obstacle", "crowdnav-circle"})
    all.push_back({scene});
  for (const avo::Method method :
       {avo::Method::avo_paper, avo::Method::velocity_obstacle, avo::Method::orca,
        avo::Method::orca_clamped, avo::Method::reciprocal_velocity_obstacle,
        avo::Method::buffered_voronoi})
    for (const char* scene : {"doorway", "moving-obstacle", "circle-24", "drives-100"})
      all.push_back({scene, {std::string("method=") + to_string(method)}});
  all.push_back({"uniform-1000", {"method=avo_paper"}});
  all.push_back({"circle-24", {"clock=free"}});
  return all;
}

std::string name_of(const ExplainedRun& run) {
  std::string name = run.scene;
  for (const std::string& setting : run.overrides) name += " " + setting.substr(0, 40);
  return name;
}

void run_to(Simulation& simulation, double time) {
  while (simulation.can_step_by(time)) simulation.step();
}

// Robots spread over the fleet, at most so many.
std::vector<avo::RobotId> some_of(const Simulation& simulation, std::size_t most) {
  std::vector<avo::RobotId> some;
  const auto ids = simulation.fleet(avo::Columns::id).id;
  const std::size_t step = std::max<std::size_t>(ids.size() / most, 1);
  for (std::size_t i = 0; i < ids.size(); i += step)
    if (!is_parked(simulation.setup(ids[i]))) some.push_back(ids[i]);
  return some;
}

std::array<std::uint64_t, 2> bits_of(Vec2 v) {
  return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y)};
}

struct Counts {
  int decisions = 0, binding = 0, refusing = 0, detours = 0, evasions = 0, rules = 0;
  int refusing_flight = 0;
};

// With those that refuse left out, the certificate admits the velocity; with them it does not.
void expect_refusals(const Explanation& why, const avo::Planner& planner, Vec2 asked,
                     const std::vector<avo::Cause>& refusing) {
  const auto& seen = why.seen;
  if (refusing.empty() || !is_holonomic(seen.robot.model)) return;  // wheels refuse as well
  const auto refuses = [&](avo::Cause cause) {
    return std::find(refusing.begin(), refusing.end(), cause) != refusing.end();
  };
  std::vector<avo::Neighbor> others;
  std::vector<avo::Wall> walls;
  for (std::size_t k = 0; k < seen.neighbors.size(); ++k)
    if (!refuses({static_cast<int>(k), -1})) others.push_back(seen.neighbors[k]);
  for (std::size_t k = 0; k < seen.walls.size(); ++k)
    if (!refuses({-1, static_cast<int>(k)})) walls.push_back(seen.walls[k]);
  avo::PlanWorkspace workspace;
  std::uint8_t without = 0, with = 1;
  planner.find_admitted(seen.robot, others, workspace, {&asked, 1}, {&without, 1}, walls);
  planner.find_admitted(seen.robot, seen.neighbors, workspace, {&asked, 1}, {&with, 1}, seen.walls);
  EXPECT_EQ(without, 1) << why.sentence;
  EXPECT_EQ(with, 0) << why.sentence;
}

// A half-plane of a neighbor binds exactly if the target lies on the line of the half-plane.
void expect_binding(const Explanation& why, const avo::Planner& planner) {
  const auto& seen = why.seen;
  avo::PlanWorkspace workspace;
  avo::HalfPlanes planes;
  planner.collect_half_planes(seen.robot, seen.neighbors, workspace, planes, seen.walls);
  for (const avo::NeighborPlane& plane : planes.planes) {
    const bool binds = std::find(why.decision.binding.begin(), why.decision.binding.end(),
                                 avo::Cause{plane.neighbor, -1}) != why.decision.binding.end();
    const double off = std::abs(violation(plane.plane, why.decision.target));
    const bool is_free = why.decision.target == why.decision.aim;
    EXPECT_TRUE(binds ? off <= kTolerance : is_free || off > 0.01 * kTolerance) << why.sentence;
  }
}

void expect_stages(const Explanation& why, const avo::Planner& planner, Counts& counts) {
  const avo::DecisionTrace& decision = why.decision;
  const PlanStatus status = decision.plan.status;
  ++counts.decisions;
  counts.binding += decision.binding.empty() ? 0 : 1;
  counts.refusing += decision.refusing.empty() ? 0 : 1;
  counts.detours += status == PlanStatus::detour ? 1 : 0;
  counts.evasions += decision.evasion ? 1 : 0;
  counts.rules += decision.rule != avo::WishRule::none ? 1 : 0;
  EXPECT_EQ(decision.evasion.has_value(), decision.plan.evading);
  EXPECT_EQ(decision.preferred_velocity, why.seen.robot.preferred_velocity);
  const bool is_changed = decision.wish != decision.preferred_velocity;
  EXPECT_EQ(decision.rule != avo::WishRule::none, is_changed) << why.sentence;
  if (!can_rest(why.seen.robot.model) && !decision.plan.evading &&
      (status == PlanStatus::refused || status == PlanStatus::braking)) {
    ++counts.refusing_flight;
    EXPECT_FALSE(decision.refusing.empty()) << why.sentence;
  }
  if (why.seen.stop || status == PlanStatus::overlapping || !can_rest(why.seen.robot.model)) return;
  if (!why.seen.among_movers && !avo::avoids_union(planner.options().method) &&
      !(decision.plan.violation > 0.0))
    expect_binding(why, planner);
  if (planner.options().method != avo::Method::avo) return;
  const bool as_proposed = !is_holonomic(why.seen.robot.model) ||
                           norm(decision.plan.next_velocity - decision.proposal) <= kTolerance;
  EXPECT_TRUE(as_proposed || status != PlanStatus::optimal || decision.plan.evading)
      << why.sentence;
  const auto& last = decision.detour ? decision.refusing_detour : decision.refusing;
  const bool is_refused = status == PlanStatus::refused || status == PlanStatus::braking;
  EXPECT_TRUE(!is_refused || decision.plan.evading || !last.empty()) << why.sentence;
  expect_refusals(why, planner, decision.proposal, decision.refusing);
  if (decision.detour) expect_refusals(why, planner, *decision.detour, decision.refusing_detour);
}

TEST(Explanations, end_in_what_the_robot_does_and_each_stage_follows) {
  Counts counts;
  for (const ExplainedRun& run : runs()) {
    Simulation simulation(avo_io::load_scenario(run.scene, run.overrides), 1);
    const std::string name = name_of(run);
    for (const double time : {0.0, 2.5, 6.0, 9.0, 14.0, 22.0}) {
      run_to(simulation, time);
      std::vector<Explanation> all;
      for (const avo::RobotId robot : some_of(simulation, simulation.size()))
        all.push_back(simulation.explain(robot));
      const double now = simulation.time();
      simulation.step();
      for (const Explanation& why : all) {
        if (!simulation.index_of(why.robot) || !simulation.decided(why.robot)) continue;
        const avo::Plan plan = simulation.robot(why.robot).plan;
        const std::string place = name + " " + std::to_string(now) + ": " + why.sentence;
        ASSERT_EQ(bits_of(why.decision.plan.next_velocity), bits_of(plan.next_velocity)) << place;
        ASSERT_EQ(bits_of(why.decision.plan.new_velocity), bits_of(plan.new_velocity)) << place;
        ASSERT_EQ(bits_of(why.decision.plan.acceleration), bits_of(plan.acceleration)) << place;
        ASSERT_EQ(why.decision.plan.status, plan.status) << place;
        ASSERT_EQ(why.decision.plan.evading, plan.evading) << place;
        expect_stages(why, simulation.planner(why.robot), counts);
        ASSERT_FALSE(HasFailure()) << place;
      }
    }
  }
  EXPECT_GT(counts.decisions, 20000);
  EXPECT_GT(counts.binding, 10000);
  EXPECT_GT(counts.refusing, 1000);
  EXPECT_GT(counts.detours, 800);
  EXPECT_GT(counts.evasions, 4);
  EXPECT_GT(counts.rules, 10000);
  EXPECT_GT(counts.refusing_flight, 2);
}

bool has_name(const std::string& sentence) {
  for (const char* name : {"robot ", "robots ", "moving obstacle ", "wall", "disc at", "goal"})
    if (sentence.find(name, sentence.find(' ', 6)) != std::string::npos) return true;
  return false;
}

// Robots at rest by what holds them: each kind must be among those that are asked.
struct Standing {
  int all = 0, beside_walls = 0, at_passages = 0, beside_movers = 0, at_shared_goals = 0;

  void count(const Explanation& why) {
    const auto& seen = why.seen;
    const bool has_movers =
        std::any_of(seen.neighbors.begin(), seen.neighbors.end(),
                    [](const auto& n) { return n.behavior == avo::Behavior::moves_on; });
    ++all;
    beside_walls += seen.walls.empty() ? 0 : 1;
    at_passages += seen.wait ? 1 : 0;
    beside_movers += has_movers ? 1 : 0;
    at_shared_goals += seen.stop || seen.guide == avo::Guide::place ? 1 : 0;
  }
};

// Crowds in scenes with walls and passages, a door in which a mover stands, and the circle with one
// goal for all.
std::vector<avo::Scenario> crowds() {
  std::vector<avo::Scenario> all;
  for (const char* name : {"doorway", "office", "corridor-one-lane", "bottleneck", "maze",
                           "circle-100", "drives-100", "mixed-yard", "swap-blocks", "cars-100"})
    all.push_back(avo_io::load_scenario(name));
  avo::Scenario& blocked = all.emplace_back(avo_io::load_scenario("doorway"));
  blocked.moving_obstacles.push_back({.radius = 0.6});
  avo::Scenario& shared = all.emplace_back(avo_io::load_scenario("circle-24"));
  for (avo::RobotSetup& robot : shared.robots) robot.goal = {};
  return all;
}

void expect_reason_and_name(const Explanation& why) {
  const std::string& sentence = why.sentence;
  bool is_vague = false;
  for (const char* words : {"others stand", "before others", "by others", "of others"})
    is_vague = is_vague || sentence.find(words) != std::string::npos;
  EXPECT_TRUE(has_name(sentence) && !is_vague) << why.time << ": " << sentence;
}

TEST(Explanations, of_robots_that_stand_have_a_reason_and_a_name) {
  Standing standing;
  for (const avo::Scenario& scene : crowds()) {
    Simulation simulation(scene, 1);
    for (double time = 1.0; time < 40.0; time += 1.9) {
      run_to(simulation, time);
      for (const avo::RobotId i : some_of(simulation, 40)) {
        const avo::RobotState robot = simulation.robot(i);
        const bool rests = norm(robot.velocity) < 0.01 * simulation.setup(i).max_speed;
        if (!rests || simulation.is_at_goal(i)) continue;
        const Explanation why = simulation.explain(i);
        const bool gets_on = why.sentence.find("turns on the spot") != std::string::npos ||
                             why.sentence.find(" starts: ") != std::string::npos;
        if (gets_on) continue;
        standing.count(why);
        expect_reason_and_name(why);
      }
    }
  }
  EXPECT_GT(standing.all, 200);
  EXPECT_GT(standing.beside_walls, 10);
  EXPECT_GT(standing.at_passages, 10);
  EXPECT_GT(standing.beside_movers, 50);
  EXPECT_GT(standing.at_shared_goals, 10);
}

TEST(Explanations, name_the_door_and_the_robot_that_a_robot_waits_for) {
  avo::Scenario scene = avo_io::load_scenario("corridor-one-lane");
  Simulation simulation(scene, 1);
  int waits = 0;
  for (double time = 0.5; time < 30.0; time += 0.5) {
    run_to(simulation, time);
    for (std::size_t i = 0; i < simulation.size(); ++i) {
      const Explanation why = simulation.explain({i});
      if (!why.seen.wait || why.seen.guide != avo::Guide::passage || why.decision.evasion ||
          why.decision.plan.status == PlanStatus::overlapping)
        continue;
      ++waits;
      const std::string whom = "for robot " + std::to_string(why.seen.wait->robot.value);
      EXPECT_NE(why.sentence.find("at the door between ("), std::string::npos);
      EXPECT_NE(why.sentence.find(
                    whom + (why.seen.wait->inside ? ", which is inside" : ", which goes first")),
                std::string::npos)
          << why.sentence;
    }
  }
  EXPECT_GT(waits, 20);
}

}  // namespace
}  // namespace avo_test
