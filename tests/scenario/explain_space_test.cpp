// SPDX-License-Identifier: Apache-2.0
// Explanations of decisions in space, of every robot of several scenes. Each explanation ends in
// what the robot does, and changes nothing. Each stage follows from the one before it. Robots that
// stand have a reason with a name.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

#include "avo/space/explanation.h"
#include "scenario/space_scenes.h"

namespace avo_test::in_space {
namespace {

using avo::PlanStatus;
using avo::Vec3;
using avo::space::Cause;
using avo::space::DecisionTrace;
using avo::space::Explanation;
using avo::space::Planner;
using avo::space::Simulation;

constexpr double kTolerance = 1e-6;  // m/s

std::array<std::uint64_t, 3> bits_of(Vec3 v) {
  return {std::bit_cast<std::uint64_t>(v.x), std::bit_cast<std::uint64_t>(v.y),
          std::bit_cast<std::uint64_t>(v.z)};
}

struct Counts {
  int decisions = 0, binding = 0, refusing = 0, of_boxes = 0, of_movers = 0, detours = 0;
  int evasions = 0, rules = 0, ages = 0;
};

bool contains(const std::vector<Cause>& causes, Cause cause) {
  return std::find(causes.begin(), causes.end(), cause) != causes.end();
}

// With those that refuse left out, the certificate admits the velocity; with them it does not.
void expect_refusals(const Explanation& why, const Planner& planner, Vec3 asked,
                     const std::vector<Cause>& refusing) {
  const auto& seen = why.seen;
  if (refusing.empty() || contains(refusing, {})) return;  // its own limits refuse as well
  std::vector<avo::space::Neighbor> others;
  std::vector<avo::space::Box> boxes;
  std::vector<avo::space::Mover> movers;
  const auto keep_others = [&](const auto& all, auto& kept, const auto& cause_of) {
    for (std::size_t k = 0; k < all.size(); ++k)
      if (!contains(refusing, cause_of(static_cast<int>(k)))) kept.push_back(all[k]);
  };
  keep_others(seen.neighbors, others, [](int k) { return Cause{k, -1, -1}; });
  keep_others(seen.boxes, boxes, [](int k) { return Cause{-1, k, -1}; });
  keep_others(seen.movers, movers, [](int k) { return Cause{-1, -1, k}; });
  avo::space::PlanWorkspace workspace;
  // rounding may have put it beyond the robot's own limits
  const Vec3 within = asked + 1e-9 * (seen.robot.velocity - asked);
  EXPECT_TRUE(planner.is_admitted(seen.robot, others, workspace, within, boxes, movers))
      << why.sentence;
  EXPECT_FALSE(
      planner.is_admitted(seen.robot, seen.neighbors, workspace, asked, seen.boxes, seen.movers))
      << why.sentence;
}

// Where the target keeps to all half-spaces, a half-space binds exactly if the target lies on its
// boundary.
void expect_binding(const Explanation& why) {
  const DecisionTrace& decision = why.decision;
  if (decision.plan.violation > 0.0) return;
  const bool is_free = decision.target == decision.aim;
  for (const avo::space::CausedHalfSpace& plane : decision.half_spaces) {
    const double off = dot(plane.normal, decision.target) - plane.offset;
    EXPECT_GE(off, -kTolerance) << why.sentence;
    const bool binds = off <= 0.01 * kTolerance;
    EXPECT_TRUE(!binds || is_free || contains(decision.binding, plane.of)) << why.sentence;
  }
  for (const Cause cause : decision.binding) {
    EXPECT_TRUE(std::any_of(decision.half_spaces.begin(), decision.half_spaces.end(),
                            [&](const auto& plane) {
                              return plane.of == cause &&
                                     std::abs(dot(plane.normal, decision.target) - plane.offset) <=
                                         kTolerance;
                            }))
        << why.sentence;
  }
}

// What binds has the same half-space where nothing else is sensed.
void expect_sources(const Explanation& why, const Planner& planner) {
  const auto& seen = why.seen;
  const auto one_of = [](const auto& all, int k) {
    return std::span(all).subspan(static_cast<std::size_t>(std::max(k, 0)), k >= 0 ? 1 : 0);
  };
  avo::space::PlanWorkspace workspace;
  for (const Cause cause : why.decision.binding) {
    avo::space::Detour detour = seen.detour;
    const DecisionTrace alone =
        planner.explain(seen.robot, one_of(seen.neighbors, cause.neighbor), workspace, &detour,
                        one_of(seen.boxes, cause.box), one_of(seen.movers, cause.mover));
    const auto& all = why.decision.half_spaces;
    const auto own =
        std::find_if(all.begin(), all.end(), [&](const auto& plane) { return plane.of == cause; });
    ASSERT_NE(own, all.end()) << why.sentence;
    EXPECT_TRUE(std::any_of(alone.half_spaces.begin(), alone.half_spaces.end(),
                            [&](const auto& plane) {
                              return plane.normal == own->normal && plane.offset == own->offset;
                            }))
        << why.sentence;
  }
}

void expect_stages(const Explanation& why, const Planner& planner, Counts& counts) {
  const DecisionTrace& decision = why.decision;
  const PlanStatus status = decision.plan.status;
  ++counts.decisions;
  counts.binding += decision.binding.empty() ? 0 : 1;
  counts.refusing += decision.refusing.empty() ? 0 : 1;
  for (const Cause cause : decision.refusing) {
    counts.of_boxes += cause.box >= 0 ? 1 : 0;
    counts.of_movers += cause.mover >= 0 ? 1 : 0;
  }
  counts.detours += status == PlanStatus::detour ? 1 : 0;
  counts.evasions += decision.evasion && decision.evasion->mover >= 0 ? 1 : 0;
  counts.rules += decision.rule != avo::WishRule::none ? 1 : 0;
  for (const auto& other : why.seen.neighbors) counts.ages += other.age > 0 ? 1 : 0;
  EXPECT_EQ(decision.evasion.has_value(), decision.plan.evading);
  EXPECT_EQ(decision.preferred_velocity, why.seen.robot.preferred_velocity);
  const bool is_changed = decision.wish != decision.preferred_velocity;
  EXPECT_EQ(decision.rule != avo::WishRule::none, is_changed) << why.sentence;
  const bool heeds =
      decision.rule == avo::WishRule::keeps_right || decision.rule == avo::WishRule::yields;
  EXPECT_TRUE(!heeds || decision.heeded >= 0) << why.sentence;
  expect_binding(why);
  if (why.robot.value % 4 == 0) expect_sources(why, planner);
  if (status == PlanStatus::overlapping) return;
  const bool as_proposed = norm(decision.plan.next_velocity - decision.proposal) <= kTolerance;
  EXPECT_TRUE(as_proposed || status != PlanStatus::optimal) << why.sentence;
  const auto& last = decision.detour ? decision.refusing_detour : decision.refusing;
  const bool is_refused = status == PlanStatus::refused || status == PlanStatus::braking;
  EXPECT_TRUE(!is_refused || decision.plan.evading || !last.empty()) << why.sentence;
  expect_refusals(why, planner, decision.proposal, decision.refusing);
  if (decision.detour) expect_refusals(why, planner, *decision.detour, decision.refusing_detour);
}

void expect_end(const Explanation& why, const Planner& planner, const avo::space::Plan& plan) {
  const auto& seen = why.seen;
  EXPECT_EQ(bits_of(why.decision.plan.next_velocity), bits_of(plan.next_velocity));
  EXPECT_EQ(bits_of(why.decision.plan.new_velocity), bits_of(plan.new_velocity));
  EXPECT_EQ(bits_of(why.decision.plan.acceleration), bits_of(plan.acceleration));
  EXPECT_EQ(why.decision.plan.status, plan.status);
  EXPECT_EQ(why.decision.plan.state, plan.state);
  EXPECT_EQ(why.decision.plan.evading, plan.evading);
  avo::space::PlanWorkspace workspace;
  avo::space::Detour detour = seen.detour;
  const avo::space::Plan again =
      planner.plan(seen.robot, seen.neighbors, workspace, &detour, seen.boxes, seen.movers);
  EXPECT_EQ(bits_of(again.next_velocity), bits_of(plan.next_velocity));
}

TEST(ExplanationsInSpace, end_in_what_the_robot_does_and_each_stage_follows) {
  Counts counts;
  for (const SpaceRun& run : space_runs()) {
    Simulation simulation(run.scenario, 1), unasked(run.scenario, 1);
    const Planner planner(planner_options(run.scenario));
    for (int step = 0; step < 200; ++step) {
      std::vector<Explanation> all;
      for (std::size_t k = 0; k < simulation.size() && step % 4 == 0; ++k)
        all.push_back(simulation.explain({k}));
      const double now = simulation.time();
      simulation.step();
      unasked.step();
      ASSERT_EQ(simulation.state_hash(), unasked.state_hash()) << run.name;
      for (const Explanation& why : all) {
        expect_end(why, planner, simulation.plans()[why.robot.value]);
        expect_stages(why, planner, counts);
        ASSERT_FALSE(HasFailure()) << run.name << " " << now << ": " << why.sentence;
      }
    }
  }
  EXPECT_GT(counts.decisions, 10000);
  EXPECT_GT(counts.binding, 5000);
  EXPECT_GT(counts.refusing, 1000);
  EXPECT_GT(counts.of_boxes, 100);
  EXPECT_GT(counts.of_movers, 20);
  EXPECT_GT(counts.detours, 200);
  EXPECT_GT(counts.evasions, 20);
  EXPECT_GT(counts.rules, 5000);
  EXPECT_GT(counts.ages, 100);
}

TEST(ExplanationsInSpace, name_moving_obstacles_by_their_ids) {
  avo::space::Scenario scene;
  scene.robots.resize(1);
  scene.moving_obstacles.push_back({.position = {0.0, 30.0, 0.0}, .velocity = {0.0, 1.0, 0.0}});
  Simulation simulation(scene, 1);
  const avo::MovingObstacleId ball = simulation.add_moving_obstacle(
      {.position = {9.0, 0.0, 0.0}, .velocity = {-3.0, 0.0, 0.0}, .radius = 0.4});
  simulation.remove_moving_obstacle({0});
  int named = 0;
  for (int step = 0; step < 30; ++step) {
    const Explanation why = simulation.explain({0});
    simulation.step();
    EXPECT_EQ(bits_of(why.decision.plan.next_velocity),
              bits_of(simulation.plans()[0].next_velocity));
    for (const avo::MovingObstacleId seen : why.seen.mover_ids) EXPECT_EQ(seen, ball);
    named += why.sentence.find("moving obstacle 1") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(ball.value, 1U);
  EXPECT_GT(named, 3);
}

// The corner of its trajectory comes too late for the robot, which rests while it is touched.
TEST(ExplanationsInSpace, name_the_moving_obstacle_that_touches_a_robot_at_rest) {
  for (const bool is_certified : {true, false}) {
    avo::space::Scenario scene;
    scene.robots.resize(1);
    if (!is_certified) scene.certificate = avo::Certificate::none;
    avo::space::MovingObstacle corner{.radius = 0.6};
    corner.trajectory = {{0, {-10, 0, 4}}, {4, {-3, 0, 4}}, {5, {-1, 0, 0.5}}, {12, {10, 0, 0}}};
    scene.moving_obstacles = {corner};
    Simulation simulation(scene, 1);
    double deepest = 0.0;  // m
    for (int step = 0; step < 100; ++step) {
      const Explanation why = simulation.explain({0});
      const avo::space::Plan& plan = why.decision.plan;
      const avo::space::Mover& mover = simulation.movers()[0];
      const double depth = 1.1 - norm(mover.position - simulation.robots()[0].position);
      deepest = std::max(deepest, depth);
      if (depth > 1e-3) {
        EXPECT_EQ(plan.status, PlanStatus::overlapping) << why.time;
        EXPECT_EQ(plan.mover, 0);
        EXPECT_GE(plan.depth, depth - 1e-6);
        EXPECT_EQ(plan.state, avo::SafetyState::unknown);
        EXPECT_NE(why.sentence.find("is in contact with moving obstacle 0"), std::string::npos)
            << why.sentence;
        EXPECT_EQ(why.sentence.find("(safe)"), std::string::npos) << why.sentence;
      }
      simulation.step();
      const auto touched = simulation.touched({0});
      EXPECT_EQ(touched.has_value(), plan.status == PlanStatus::overlapping);
      EXPECT_TRUE(!touched || touched->moving_obstacle == avo::MovingObstacleId{0});
      EXPECT_EQ(simulation.plans()[0].mover, -1) << "no list is given";
    }
    EXPECT_GT(deepest, 0.3) << is_certified;
  }
}

// Robots touch because errors of their measurements are not declared. The step and the decision
// that is explained name the same robot, by its id and by its place in a list.
TEST(ExplanationsInSpace, name_robots_in_contact_by_their_ids) {
  avo::space::Scenario scene;
  scene.sensing.noise = {.position = 0.02, .velocity = 0.04};
  scene.sensing.delay = 4;
  scene.sensing.dropped = 0.1;
  scene.sensing_error = avo::SensingError{};
  for (int k = 0; k < 30; ++k) {
    const double angle = 2.399963 * k, height = (2.0 * k + 1.0) / 30.0 - 1.0;
    const double across = std::sqrt(1.0 - height * height);
    avo::space::RobotSetup robot;
    robot.position = 7.0 * Vec3{across * std::cos(angle), across * std::sin(angle), height};
    robot.goal = -1.0 * robot.position;
    scene.robots.push_back(robot);
  }
  Simulation simulation(scene, 1);
  int contacts = 0, places = 0;
  for (int step = 0; step < 200; ++step) {
    std::vector<Explanation> explained;
    for (std::size_t k = 0; k < simulation.size(); ++k)
      explained.push_back(simulation.explain({k}));
    simulation.step();
    for (const Explanation& why : explained) {
      const avo::space::Plan& plan = why.decision.plan;
      const auto touched = simulation.touched(why.robot);
      ASSERT_EQ(touched.has_value(), plan.status == PlanStatus::overlapping);
      EXPECT_EQ(simulation.plans()[why.robot.value].neighbor, -1) << "no list is given";
      if (!touched) continue;
      ASSERT_GE(plan.neighbor, 0);
      const auto place = static_cast<std::size_t>(plan.neighbor);
      EXPECT_EQ(touched->robot, why.seen.neighbor_ids[place]);
      EXPECT_FALSE(touched->obstacle || touched->moving_obstacle);
      ++contacts, places += place != touched->robot->value ? 1 : 0;
    }
  }
  EXPECT_GT(contacts, 10);
  EXPECT_GT(places, 5) << "ids differ from places";
}

TEST(ExplanationsInSpace, of_numbers_that_are_none_end_in_braking) {
  const Planner planner{avo::PlannerOptions{.method = avo::Method::avo}};
  avo::space::PlanWorkspace workspace;
  const avo::space::Robot robot{.velocity = {1.0, 0.0, 0.5}, .preferred_velocity = {2.0, 0.0, 0.0}};
  const avo::space::Neighbor nowhere{.position = {std::nan(""), 0.0, 0.0}};
  const DecisionTrace trace = planner.explain(robot, {&nowhere, 1}, workspace);
  EXPECT_EQ(trace.plan.status, PlanStatus::invalid_input);
  EXPECT_EQ(trace.wish, robot.preferred_velocity);
  EXPECT_EQ(trace.proposal, trace.plan.next_velocity);
  EXPECT_LT(norm(trace.plan.next_velocity), norm(robot.velocity));
}

bool has_name(const std::string& sentence) {
  const char* const names[] = {"robot ", "robots ", "obstacle ", "obstacles ", "goal"};
  return std::any_of(std::begin(names), std::end(names), [&](const char* name) {
    return sentence.find(name, sentence.find(' ', 6)) != std::string::npos;
  });
}

bool is_vague(const std::string& sentence) {
  const char* const vague[] = {"before others", "by others", "beside others", "room for others"};
  return std::any_of(std::begin(vague), std::end(vague),
                     [&](const char* words) { return sentence.find(words) != std::string::npos; });
}

TEST(ExplanationsInSpace, of_robots_that_stand_have_a_reason_and_a_name) {
  int standing = 0, at_passages = 0;
  for (const SpaceRun& run : space_runs()) {
    Simulation simulation(run.scenario, 1);
    for (int step = 0; step < 800; ++step) {
      simulation.step();
      for (std::size_t k = 0; k < simulation.size() && step % 5 == 4; ++k) {
        const avo::space::Robot& robot = simulation.robots()[k];
        const bool rests = norm(robot.velocity) < 0.01 * robot.max_speed;
        if (!rests || simulation.is_at_goal({k})) continue;
        const Explanation why = simulation.explain({k});
        if (why.sentence.find(" starts: ") != std::string::npos) continue;
        ++standing;
        at_passages += why.seen.wait ? 1 : 0;
        EXPECT_TRUE(has_name(why.sentence) && !is_vague(why.sentence))
            << run.name << " " << why.time << ": " << why.sentence;
      }
    }
  }
  EXPECT_GT(standing, 100);
  EXPECT_GT(at_passages, 5);
}

TEST(ExplanationsInSpace, name_the_passage_and_the_robot_that_a_robot_waits_for) {
  Simulation simulation(example("shaft-one-lane"), 1);
  int waits = 0, inside = 0;
  for (int step = 0; step < 300; ++step) {
    simulation.step();
    for (std::size_t k = 0; k < simulation.size(); ++k) {
      const Explanation why = simulation.explain({k});
      if (!why.seen.wait || why.decision.evasion ||
          why.decision.plan.status == PlanStatus::overlapping)
        continue;
      ++waits;
      EXPECT_EQ(why.seen.guide, avo::Guide::passage);
      EXPECT_NE(why.seen.wait->robot, why.robot);
      const Vec3 other = simulation.robots()[why.seen.wait->robot.value].position;
      const bool is_inside = std::abs(other.z) < 4.7;  // the shaft and its mouths
      EXPECT_TRUE(!why.seen.wait->inside || is_inside) << why.sentence;
      inside += why.seen.wait->inside ? 1 : 0;
      EXPECT_NE(why.sentence.find("at the passage at (0, 0, 0) for robot " +
                                  std::to_string(why.seen.wait->robot.value) +
                                  (why.seen.wait->inside ? ", which is inside"
                                                         : ", which goes "
                                                           "first")),
                std::string::npos)
          << why.sentence;
    }
  }
  EXPECT_GT(waits, 100);
  EXPECT_GT(inside, 50);
}

}  // namespace
}  // namespace avo_test::in_space
