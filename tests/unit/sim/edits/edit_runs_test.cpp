// SPDX-License-Identifier: Apache-2.0
// These runs have many edits of static obstacles: no robot is touched, and the bits are the same.
#include <gtest/gtest.h>
#include <vector>

#include "avo/error.h"
#include "support/walls.h"
#include "unit/sim/judged.h"
#include "unit/sim/walled_scenes.h"

namespace avo {
namespace {

using test::Judged;
using test::pieces;
using test::robot_at;

// Ten thousand doors anywhere among robots on their ways: those that are refused would have been
// touched, the others are not.
TEST(Edits, ten_thousand_doors_touch_nobody) {
  for (const bool navigation : {true, false}) {
    test::Random random(11);
    Scenario scene;
    scene.navigation = navigation;
    std::vector<Wall> walls = test::random_walls(12, 16.0, 3);
    scene.obstacles = {pieces(walls)};
    for (int k = 0; k < 16; ++k) {
      RobotSetup robot = robot_at({20.0 + 1.5 * (k % 4), 1.5 * (k / 4)}, {2.0 * (k % 4), 12.0});
      robot.radius = 0.3;
      if (k % 4 == 0) robot.model = Car{0.5}, robot.heading = 0.1 * k;
      scene.robots.push_back(robot);
    }
    Judged judged(scene, 1);
    Simulation& simulation = judged.simulation;
    std::vector<ObstacleId> doors;
    int added = 0, refused = 0, edits = 0;
    while (edits < 5000) {
      if (doors.size() > 12 || (!doors.empty() && random.below(2) == 0)) {
        const auto k = static_cast<std::size_t>(random.below(static_cast<int>(doors.size())));
        simulation.remove_obstacle(doors[k]);
        doors.erase(doors.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        const Vec2 a = test::in_square(random, 24.0) - Vec2{2, 2};
        const Vec2 b = a + random.uniform(0.1, 3.0) * random.direction();
        StaticObstacle door = pieces({{a, b}});
        door.radius = random.below(4) == 0 ? 0.2 : 0.0;
        try {
          doors.push_back(simulation.add_obstacle(door));
          ++added;
        } catch (const Error&) {
          ++refused;
        }
      }
      ++edits;
      if (random.below(2) == 0) judged.step();
      if (edits % 40 == 0)
        simulation.set_goal({static_cast<std::uint64_t>(random.below(16))},
                            test::in_square(random, 16.0));
    }
    const CheckReport report = judged.report();
    EXPECT_EQ(report.static_contacts.count, 0);
    EXPECT_TRUE(report.safe());
    EXPECT_LT(*report.least_static_clearance, 0.01) << "nobody came near";
    EXPECT_GT(added, 1000);
    EXPECT_GT(refused, 20);
    for (const Plan& plan : simulation.fleet().plan) {
      EXPECT_NE(plan.status, PlanStatus::overlapping);
    }
  }
}

void expect_no_change(const Scenario& scene, Vec2 far_off) {
  Simulation edited(scene, 1), other(scene, 1);
  for (int k = 0; k < 13; ++k) edited.step(), other.step();
  for (int round = 0; round < 3; ++round) {
    const ObstacleId far =
        edited.add_obstacle(pieces({{far_off, far_off + Vec2{10, 1.0 * round}}}));
    EXPECT_NE(edited.state_hash(), other.state_hash());
    for (int k = 0; k < 7 * round; ++k) edited.step(), other.step();
    edited.remove_obstacle(far);
    EXPECT_EQ(edited.state_hash(), other.state_hash()) << round;
    for (int k = 0; k < 20; ++k) edited.step(), other.step();
    EXPECT_EQ(edited.state_hash(), other.state_hash()) << round;
  }
}

TEST(Edits, far_from_everybody_they_change_no_bit) {
  expect_no_change(test::crowded_maze(60), {60, 60});
  expect_no_change(test::noise_scene(8), {-60, -50});
}

// Doors between neighboring cells of the maze, which open and close in no order.
struct Doors {
  test::Random random{7};
  std::vector<ObstacleId> doors = {};
  int added = 0;

  void edit(Simulation& simulation) {
    if (!doors.empty() && random.below(2) == 0) {
      const auto k = static_cast<std::size_t>(random.below(static_cast<int>(doors.size())));
      simulation.remove_obstacle(doors[k]);
      doors.erase(doors.begin() + static_cast<std::ptrdiff_t>(k));
      return;
    }
    const Vec2 corner{3.0 * (1 + random.below(9)), 3.0 * (1 + random.below(9))};
    const Vec2 along = random.below(2) == 0 ? Vec2{3.0, 0.0} : Vec2{0.0, 3.0};
    try {
      doors.push_back(simulation.add_obstacle(pieces({{corner, corner + along}})));
      ++added;
    } catch (const Error&) {  // somebody is there
    }
  }
};

TEST(Edits, are_the_same_for_any_number_of_threads) {
  const Scenario scene = test::crowded_maze(300);
  Simulation one(scene, 1), two(scene, 2);
  Doors of_one, of_two;
  for (int k = 0; k < 25; ++k) {
    for (int edit = 0; edit < 4; ++edit) of_one.edit(one), of_two.edit(two);
    one.step(), two.step();
    ASSERT_EQ(one.state_hash(), two.state_hash()) << k;
    ASSERT_EQ(one.unreachable(), two.unreachable()) << k;
  }
  EXPECT_TRUE(one.save() == two.save());
  EXPECT_GT(of_one.added, 5);
}

TEST(Edits, a_rollback_goes_across_them) {
  const Scenario scene = test::crowded_maze(40);
  Simulation original(scene, 1), other(scene, 1);
  Doors doors;
  std::vector<std::vector<std::byte>> saved;
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < 30; ++k) {
    saved.push_back(original.save());
    if (k % 3 == 1) doors.edit(original);
    saved.push_back(original.save());
    original.step();
    hashes.push_back(original.state_hash());
  }
  Doors again;
  for (const std::size_t from : {12u, 4u, 25u, 0u}) {
    Simulation alone(saved[2 * from + 1], 1);
    for (Simulation* restored : {&original, &other, &alone}) {
      restored->restore(saved[2 * from + 1]);
      EXPECT_TRUE(restored->save() == saved[2 * from + 1]);
      restored->step();
      EXPECT_EQ(restored->state_hash(), hashes[from]);
    }
  }
  original.restore(saved[0]);  // the same edits once more, with the same ids
  for (std::size_t k = 0; k < 30; ++k) {
    if (k % 3 == 1) again.edit(original);
    EXPECT_TRUE(original.save() == saved[2 * k + 1]) << k;
    original.step();
  }
}

}  // namespace
}  // namespace avo
