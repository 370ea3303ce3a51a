// SPDX-License-Identifier: Apache-2.0
// A host that looks at robots one by one, and gives them goals: neither copies the fleet.
#include <gtest/gtest.h>
#include <vector>

#include "avo/simulation.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

using test::dense_avo_scene;
using test::dense_scene;
using test::robot_at;

void expect_same(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.new_velocity, b.new_velocity);
  EXPECT_EQ(a.next_velocity, b.next_velocity);
  EXPECT_EQ(a.status, b.status);
}

void expect_rows_are_robots(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  ASSERT_EQ(simulation.size(), fleet.id.size());
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const RobotState state = simulation.robot(fleet.id[i]);
    EXPECT_EQ(state.id, fleet.id[i]);
    EXPECT_EQ(state.position, fleet.position[i]);
    EXPECT_EQ(state.velocity, fleet.velocity[i]);
    EXPECT_EQ(state.heading, fleet.heading[i]);
    EXPECT_EQ(state.goal, fleet.goal[i]);
    EXPECT_EQ(state.detour.angle, fleet.detour[i].angle);
    EXPECT_EQ(state.detour.congestion, fleet.detour[i].congestion);
    EXPECT_EQ(state.applied_acceleration, fleet.applied_acceleration[i]);
    expect_same(state.plan, fleet.plan[i]);
    EXPECT_EQ(simulation.setup(state.id), fleet.setup[i]);
    EXPECT_EQ(simulation.index_of(state.id), i);
  }
}

// What an edit leaves in the columns is what a copy of the simulation tells of itself.
void expect_columns_of_a_copy(const Simulation& simulation) {
  const Simulation copy(simulation.save(), 1);
  const FleetView kept = simulation.fleet(), made = copy.fleet();
  ASSERT_EQ(kept.id.size(), made.id.size());
  for (std::size_t i = 0; i < kept.id.size(); ++i) {
    EXPECT_EQ(kept.id[i], made.id[i]);
    EXPECT_EQ(kept.position[i], made.position[i]);
    EXPECT_EQ(kept.velocity[i], made.velocity[i]);
    EXPECT_EQ(kept.goal[i], made.goal[i]);
    EXPECT_EQ(kept.detour[i].angle, made.detour[i].angle);
    EXPECT_EQ(kept.setup[i], made.setup[i]);
  }
}

TEST(HostLoop, one_robot_is_a_row_of_the_columns) {
  Simulation simulation(dense_scene(60, Motion::held), 1);  // cars among them
  expect_rows_are_robots(simulation);
  for (int k = 0; k < 20; ++k) simulation.step();
  expect_rows_are_robots(simulation);
  for (const std::uint64_t robot : {0, 59, 30, 31}) simulation.remove_robot({robot});
  simulation.add_robot(robot_at({500, 500}, {500, 500}));
  expect_rows_are_robots(simulation);
  simulation.step();
  expect_rows_are_robots(simulation);
}

TEST(HostLoop, ids_are_found_however_many_have_gone) {
  Simulation simulation(dense_scene(40, Motion::held), 1);
  for (std::uint64_t robot = 0; robot < 40; ++robot)
    if (robot % 7 != 3) simulation.remove_robot({robot});
  for (int k = 0; k < 5; ++k) simulation.add_robot(robot_at({500.0 + 9 * k, 500}, {500, 500}));
  expect_rows_are_robots(simulation);
  for (std::uint64_t robot = 0; robot < 40; ++robot)
    EXPECT_EQ(simulation.index_of({robot}).has_value(), robot % 7 == 3) << robot;
  EXPECT_FALSE(simulation.index_of({45}).has_value());
}

TEST(HostLoop, columns_that_nobody_wants_are_empty) {
  const Simulation simulation(dense_scene(9, Motion::held), 1);
  const FleetView fleet = simulation.fleet(Columns::position | Columns::goal);
  EXPECT_EQ(fleet.position.size(), 9u);
  EXPECT_EQ(fleet.goal.size(), 9u);
  EXPECT_TRUE(fleet.id.empty() && fleet.velocity.empty() && fleet.heading.empty());
  EXPECT_TRUE(fleet.setup.empty() && fleet.detour.empty() && fleet.plan.empty());
  EXPECT_TRUE(fleet.applied_acceleration.empty());
  EXPECT_EQ(simulation.fleet().plan.size(), 9u);
  EXPECT_EQ(simulation.fleet().position.data(), fleet.position.data());
}

// The mark would be overwritten by a copy.
TEST(HostLoop, a_goal_renews_one_row_and_copies_no_column) {
  Simulation simulation(dense_avo_scene(30, Motion::held, Certificate::braking_trajectories, 3), 1);
  for (int k = 0; k < 10; ++k) simulation.step();
  const FleetView fleet = simulation.fleet();
  const Vec2 place = fleet.position[7], goal = fleet.goal[7], mark{-77.0, 77.0};
  const_cast<Vec2&>(fleet.position[7]) = const_cast<Vec2&>(fleet.goal[7]) = mark;
  simulation.set_goal({3}, {1.5, 2.5});
  EXPECT_EQ(simulation.fleet().position[7], mark);
  EXPECT_EQ(simulation.fleet().goal[7], mark);
  EXPECT_EQ(simulation.robot({7}).position, place);
  const_cast<Vec2&>(fleet.position[7]) = place, const_cast<Vec2&>(fleet.goal[7]) = goal;
  EXPECT_EQ(simulation.fleet().goal[3], (Vec2{1.5, 2.5}));
  EXPECT_EQ(simulation.fleet().setup[3].goal, (Vec2{1.5, 2.5}));
  expect_columns_of_a_copy(simulation);
  simulation.move_robot({5}, {200.0, 200.0});
  EXPECT_EQ(simulation.fleet().position[5], (Vec2{200.0, 200.0}));
  EXPECT_EQ(simulation.fleet().plan[5].new_velocity, Vec2{});
  expect_columns_of_a_copy(simulation);
}

TEST(HostLoop, a_step_makes_all_columns_anew) {
  Simulation simulation(dense_scene(12, Motion::held), 1);
  const Vec2 before = simulation.fleet(Columns::position).position[4];
  simulation.step();
  EXPECT_NE(simulation.fleet(Columns::position).position[4], before);
  EXPECT_EQ(simulation.fleet(Columns::position).position[4], simulation.robot({4}).position);
}

}  // namespace
}  // namespace avo
