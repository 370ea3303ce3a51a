// SPDX-License-Identifier: Apache-2.0
// The tests check which constants robots have to share. In some fleets the robots plan with any δ,
// τ and max_neighbors, and Check judges the runs. In other fleets the robots differ in constants
// that they do have to share. There, only pairs with an odd robot touch.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "avo/check.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

// A robot that plans by itself, `parts` decisions in a step of 0.1 s.
struct Member {
  Robot robot;
  Planner planner;
  int parts = 1;
  bool one_sided = false;
  Detour detour = {};
  Vec2 acceleration = {};  // m/s^2, held until the next decision
};

// How a robot plans. The odd ones do not do what the others expect.
struct Manner {
  PlannerOptions options = {};
  bool one_sided = false;  // plan_among_movers instead of plan
};
using Manners = std::function<Manner(Random&)>;
struct Rules {
  Manners usual = [](Random&) { return Manner{}; };
  Manners odd = {};  // of every third robot
};

bool is_odd(int robot) {
  return robot % 3 == 0;
}

PlannerOptions any_options(Random& random) {
  PlannerOptions options;
  options.control_time = random.log_uniform(options.time_step, 8.0);
  options.time_horizon = random.log_uniform(0.5, 12.0);
  if (random.below(3) > 0) options.max_neighbors = 1 + random.below(8);
  options.arrival_distance = random.uniform(0.1, 1.0);
  return options;
}

// Unequal robots at rest on a grid.
std::vector<Member> crowd(const Rules& rules, Random& random) {
  constexpr int kColumns = 6, kRows = 4;
  std::vector<Member> members;
  for (int k = 0; k < kColumns * kRows; ++k) {
    const auto [own, one_sided] = rules.odd && is_odd(k) ? rules.odd(random) : rules.usual(random);
    Member member{{}, Planner(own), static_cast<int>(0.1 / own.time_step + 0.5), one_sided};
    Robot& robot = member.robot;
    robot.position = {1.3 * (k % kColumns), 1.3 * static_cast<double>(k / kColumns)};
    robot.radius = random.uniform(0.3, 0.6);
    robot.max_acceleration = random.uniform(0.5, 2.0);
    robot.max_speed = random.uniform(1.0, 2.0);
    members.push_back(std::move(member));
  }
  return members;
}

void decide(std::vector<Member>& members, std::size_t i, Vec2 goal, PlanWorkspace& workspace) {
  std::vector<Robot> robots;
  for (const Member& each : members) robots.push_back(each.robot);
  std::vector<Neighbor> neighbors = others(robots, i);
  Member& self = members[i];
  const Vec2 here = self.robot.position, way = goal - here;
  std::sort(neighbors.begin(), neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
    return norm_squared(a.position - here) < norm_squared(b.position - here);
  });
  self.robot.preferred_velocity = norm(way) > 1.5 ? (1.5 / norm(way)) * way : way;
  const Plan plan = self.one_sided
                        ? self.planner.plan_among_movers(self.robot, neighbors, workspace)
                        : self.planner.plan(self.robot, neighbors, workspace, &self.detour);
  self.acceleration = plan.acceleration;
}

void move(Member& member, double time) {
  Robot& robot = member.robot;
  const Vec2 v = robot.velocity, a = member.acceleration;
  robot.position = robot.position + time * v + (0.5 * time * time) * a;
  robot.velocity = v + time * a;
  if (norm_squared(robot.velocity) < 0x1p-100 * norm_squared(v)) robot.velocity = {};
}

// All are judged, or all but the odd ones.
enum class Judged { all, usual };

bool counts(Judged judged, std::size_t robot) {
  return judged == Judged::all || !is_odd(static_cast<int>(robot));
}

void show(const std::vector<Member>& members, Judged judged, double time, Check& check) {
  std::vector<CheckedState> rows;
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (!counts(judged, k)) continue;
    const Robot& robot = members[k].robot;
    rows.push_back({static_cast<std::int64_t>(k), robot.position, robot.velocity});
  }
  check.add(time, rows);
}

Check judge_of(const std::vector<Member>& members) {
  std::vector<CheckedRobot> robots;
  for (const Member& each : members) {
    const Robot& robot = each.robot;
    robots.push_back({robot.radius, robot.max_acceleration, robot.max_speed});
  }
  return Check(robots);
}

// All sent to one point after the other for 30 s; states are judged every half step.
CheckReport crush(const Rules& rules, Judged judged, std::uint64_t seed) {
  constexpr int kSteps = 300, kParts = 2;
  constexpr double kPart = 0.1 / kParts;
  Random random(seed);
  std::vector<Member> members = crowd(rules, random);
  Check check = judge_of(members);
  show(members, judged, 0.0, check);
  PlanWorkspace workspace;
  Vec2 goal;
  for (int k = 0; k < kParts * kSteps; ++k) {
    if (k % 100 == 0) goal = Vec2{3.0, 2.0} + in_disc(random, 3.0);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i].parts == kParts || k % kParts == 0) decide(members, i, goal, workspace);
    }
    for (Member& each : members) move(each, kPart);
    show(members, judged, (k + 1) * kPart, check);
  }
  return check.report();
}

// In how many of so many crushes robots overlap; limits are kept in any.
int overlapping_crushes(const Rules& rules, Judged judged, int count) {
  int overlapping = 0;
  for (int seed = 1; seed <= count; ++seed) {
    const CheckReport report = crush(rules, judged, static_cast<std::uint64_t>(seed));
    EXPECT_EQ(report.accelerations.count + report.speeds.count + report.jumps.count, 0) << seed;
    EXPECT_LT(*report.least_clearance, 0.01) << seed;  // it was tight
    overlapping += report.overlaps.count > 0 ? 1 : 0;
  }
  return overlapping;
}

// The promise is one of pairs: where robots A and B keep the assumptions, A and B do not touch.
void expect_only_odd_ones_to_touch(const Manner& odd, int crushes = 5) {
  Rules rules;
  rules.odd = [odd](Random&) { return odd; };
  EXPECT_GT(overlapping_crushes(rules, Judged::all, crushes), 0);
  EXPECT_EQ(overlapping_crushes(rules, Judged::usual, crushes), 0);
}

TEST(MixedFleets, differ_in_what_only_shapes_their_wishes_and_never_touch) {
  Rules rules;
  rules.usual = [](Random& random) { return Manner{any_options(random)}; };
  EXPECT_EQ(overlapping_crushes(rules, Judged::all, 8), 0);
}

TEST(MixedFleets, without_the_certificate_touch) {
  Manner odd;
  odd.options.certificate = Certificate::none;
  expect_only_odd_ones_to_touch(odd);
}

TEST(MixedFleets, of_another_time_step_touch) {
  Manner odd;
  odd.options.time_step = 0.05;
  expect_only_odd_ones_to_touch(odd);
}

TEST(MixedFleets, that_plan_as_among_obstacles_touch) {
  Manner odd;
  odd.one_sided = true;
  expect_only_odd_ones_to_touch(odd, 1);  // it takes long
}

// Both robots of a pair have to derive the same lines, bit for bit.
TEST(MixedFleets, expect_the_same_braking_of_each_other_whatever_their_own_constants) {
  Random random(1);
  const StepLaw common = law_of(PlannerOptions{}).step;
  for (int k = 0; k < 10000; ++k) {
    const StepLaw law = law_of(any_options(random)).step;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(law.braking_time),
              std::bit_cast<std::uint64_t>(common.braking_time))
        << "control_time " << law.control_time;
    ASSERT_EQ(law.time_step, common.time_step);
    ASSERT_EQ(law.lag, common.lag);
  }
}

}  // namespace
}  // namespace avo::test
