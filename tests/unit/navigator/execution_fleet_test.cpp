// SPDX-License-Identifier: Apache-2.0
// Fleets of bases that do not execute exactly, crushed together and judged by their bodies: none
// touch as long as every robot declares its deviation (docs/certificate/execution.md).
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "unit/navigator/base_fleet.h"

namespace avo {
namespace {

using test::BaseFleet, test::grid_of, test::Knowledge, test::Member;

struct Outcome {
  double fraction = 0.0, clearance = 1.0, depth = 0.0;  // of ε; m; m
  int left = 0;
  std::int64_t wall_contacts = 0;
};

Outcome crushed(int runs, int side, const ExecutionModel* model, Knowledge known) {
  Outcome all;
  for (int run = 0; run < runs; ++run) {
    BaseFleet crush(grid_of(static_cast<std::uint64_t>(run + 1), side, model), known);
    for (const Vec2 goal : {Vec2{3, -0.5}, Vec2{9, 1}}) {
      for (Navigator& navigator : crush.navigators) navigator.set_goal(goal);
      for (const double end = crush.time + 15.0; crush.time < end;) crush.step();
    }
    const CheckReport report = crush.check.report();
    all.fraction = std::max(all.fraction, crush.fraction);
    all.clearance = std::min(all.clearance, report.least_clearance.value_or(1.0));
    all.depth = std::max(all.depth, report.overlaps.worst);
    all.left += crush.left;
    all.wall_contacts += report.static_contacts.count;
  }
  return all;
}

// Holonomic bases of all kinds with drives among them, and fleets of one kind.
TEST(FleetOfBases, bodies_never_touch_in_a_crush) {
  const ExecutionModel late{.dead_time = 0.1}, slow{.time_constant = 0.3, .dead_time = 0.05};
  double fraction = 0.0, clearance = 1.0;
  for (const ExecutionModel* model : {static_cast<const ExecutionModel*>(nullptr), &late, &slow}) {
    for (const bool is_told : {false, true}) {
      const Outcome all = crushed(4, 4, model, {.of_reference = is_told});
      EXPECT_EQ(all.depth, 0.0);
      EXPECT_EQ(all.left, 0);
      EXPECT_EQ(all.wall_contacts, 0);
      fraction = std::max(fraction, all.fraction);
      clearance = std::min(clearance, all.clearance);
    }
  }
  RecordProperty("clearance", std::to_string(clearance));
  RecordProperty("fraction", std::to_string(fraction));
  EXPECT_GT(fraction, 0.7);
}

TEST(FleetOfBases, bodies_touch_where_a_part_is_not_declared) {
  const ExecutionModel late{.dead_time = 0.2};
  const ExecutionModel slow{.time_constant = 0.3, .dead_time = 0.05};
  const double radius = crushed(4, 4, &slow, {.of_reference = true, .of_radius = false}).depth;
  const double velocities = crushed(60, 2, &late, {.of_velocities = false}).depth;
  const double errors =
      crushed(60, 2, &late, {.of_positions = false, .of_velocities = false}).depth;
  const double reference = crushed(4, 4, &slow, {.keeps_a_reference = false}).depth;
  EXPECT_GT(radius, 0.01);
  EXPECT_GT(velocities, 0.001);
  EXPECT_GT(errors, 0.01);
  EXPECT_GT(reference, 0.1);
  RecordProperty("radius", std::to_string(radius));
  RecordProperty("velocities", std::to_string(velocities));
  RecordProperty("errors", std::to_string(errors));
  RecordProperty("reference", std::to_string(reference));
}

// s, until twelve robots have changed sides across a circle.
double across(const ExecutionModel& model, bool is_told) {
  std::vector<Member> members;
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.5235987755982988 * k + 0.01;
    Member& one = members.emplace_back();
    one.model = model;
    one.body.radius = 0.3, one.body.max_speed = 1.0;
    one.base.lag = model.time_constant, one.base.dead_time = model.dead_time;
    one.base.deadband = model.deadband, one.base.quantum = model.quantum;
    one.base.position = {6.0 * std::cos(angle), 6.0 * std::sin(angle) + 8.0};
    one.most = execution_error(model, one.body, test::kFleetStep);
  }
  BaseFleet fleet(members, {.of_reference = is_told});
  for (std::size_t k = 0; k < members.size(); ++k)
    fleet.navigators[k].set_goal(members[(k + 6) % 12].base.position);
  const auto are_there = [&] {
    return std::all_of(fleet.members.begin(), fleet.members.end(), [&](const Member& one) {
      const auto k = static_cast<std::size_t>(&one - fleet.members.data());
      return norm(one.base.position - members[(k + 6) % 12].base.position) < 0.5;
    });
  };
  while (!are_there() && fleet.time < 120.0) fleet.step();
  EXPECT_EQ(fleet.check.report().overlaps.count, 0);
  return fleet.time;
}

TEST(FleetOfBases, bodies_arrive) {
  const ExecutionModel late{.dead_time = 0.1};
  const ExecutionModel slow{
      .time_constant = 0.2, .dead_time = 0.05, .deadband = 0.03, .quantum = 0.01};
  const auto expect_time = [](const char* name, double time, double most) {
    EXPECT_LT(time, most) << name;
    ::testing::Test::RecordProperty(name, std::to_string(time));
  };
  expect_time("exact_told", across({}, true), 40.0);
  expect_time("exact", across({}, false), 40.0);
  expect_time("late_told", across(late, true), 40.0);
  expect_time("late", across(late, false), 60.0);
  expect_time("slow_told", across(slow, true), 40.0);
  expect_time("slow", across(slow, false), 60.0);
}

}  // namespace
}  // namespace avo
