// SPDX-License-Identifier: Apache-2.0
// Each kind of event happens once, when it begins, whatever the host does between two steps.
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "unit/navigation/buildings.h"
#include "unit/sim/walled_scenes.h"
#include "watched_host.h"

namespace avo {
namespace {

using test::robot_at;
using test::told;
using test::watched_scene;
using Host = test::WatchedHost;

TEST(Events, are_arrivals_when_they_happen_and_once) {
  Host host(watched_scene({robot_at({0, 0}, {8, 0}), robot_at({0, 5}, {0, 5})}));
  EXPECT_EQ(host.look(), "") << "what holds at the start is no event";
  while (!host.simulation.is_at_goal({0})) {
    host.simulation.step();
    EXPECT_EQ(host.look(), host.simulation.is_at_goal({0}) ? "arrived 0" : "");
    ASSERT_LT(host.simulation.time(), 20.0);
  }
  EXPECT_EQ(host.run(100), "");
}

TEST(Events, are_departures_by_another_goal_by_the_host_or_by_hand) {
  Host host(watched_scene({robot_at({0, 0}, {0, 0}), robot_at({9, 0}, {9, 0}),
                           robot_at({18, 0}, {18, 0}), robot_at({27, 0}, {27, 0})}));
  host.simulation.set_goal({0}, {0, 6});
  host.simulation.set_goal({1}, {9, 0.1});  // within arrival_distance: it is there at once
  host.simulation.set_preferred_velocity({2}, Vec2{0, 1});
  host.simulation.move_robot({3}, {27, -8});
  EXPECT_EQ(host.step(), "left 0 left 1 arrived 1 left 2 left 3");
  EXPECT_EQ(host.run(150), "arrived 0 arrived 3");
  host.simulation.set_preferred_velocity({2}, std::nullopt);
  EXPECT_EQ(host.run(150), "arrived 2");
  host.simulation.set_goal({0}, {0, -6});
  host.simulation.set_goal({0}, {0, 6});
  EXPECT_EQ(host.step(), "") << "nothing is another than before";
}

TEST(Events, are_in_order_however_many_there_are) {
  std::vector<RobotSetup> robots;
  for (int k = 0; k < 60; ++k) robots.push_back(robot_at({3.0 * k, 0}, {3.0 * k, 0}));
  Host host(watched_scene(robots));
  std::string expected;
  for (std::uint64_t k = 0; k < 60; ++k) {
    host.simulation.set_goal({k}, {3.0 * static_cast<double>(k), 0.1});
    expected += (k == 0 ? "left " : " left ") + std::to_string(k) + " arrived " + std::to_string(k);
  }
  EXPECT_EQ(host.step(), expected);
}

TEST(Events, are_robots_that_come_and_go) {
  RobotSetup airplane = robot_at({-10, 20}, {0, 20}), parked = robot_at({0, -20}, {0, -20});
  airplane.model = Airplane{.after_goal = AfterGoal::leave};
  airplane.velocity = {1.5, 0};
  Scenario scene = watched_scene({airplane, robot_at({0, 0}, {9, 0}), robot_at({0, 5}, {9, 5})});
  Host host(scene);
  host.simulation.remove_robot({1});
  const RobotId there = host.simulation.add_robot(robot_at({-9, -5}, {-9, -5}));
  parked.behavior = Behavior::parked;
  const RobotId still = host.simulation.add_robot(parked);
  EXPECT_EQ(there.value, 3u);
  EXPECT_EQ(still.value, 4u);
  EXPECT_EQ(host.step(), "gone 1 came 3 arrived 3 came 4");
  host.simulation.remove_robot(still);
  host.simulation.remove_robot(host.simulation.add_robot(robot_at({-9, -8}, {-9, -8})));
  EXPECT_EQ(host.step(), "gone 4") << "nobody has seen the other one";
  EXPECT_EQ(host.run(150), "arrived 0 gone 0 arrived 2");
}

TEST(Events, are_goals_that_walls_shut_off) {
  Scenario scene = watched_scene(
      {robot_at({-8, 0}, {8, 0}), robot_at({-8, 3}, {-12, 3}), robot_at({8, 3}, {12, 3})});
  scene.obstacles = {test::pieces(test::doorway(2.0))};
  Host host(scene);
  const ObstacleId door =
      host.simulation.add_obstacle({{{{{0, -2}, {0, 2}}, false}}, 0.0, Fill::none});
  EXPECT_EQ(host.step(), "unreachable 0");
  ASSERT_EQ(host.simulation.unreachable(), std::vector<RobotId>{{0}});
  EXPECT_EQ(host.run(100), "arrived 1 arrived 2") << "it stands at the door, and is not stuck";
  host.simulation.set_goal({0}, {8, 1});
  EXPECT_EQ(host.step(), "unreachable 0") << "the host has to know of this goal, too";
  host.simulation.set_goal({1}, {9, 3});
  EXPECT_EQ(host.step(), "left 1 unreachable 1");
  host.simulation.remove_obstacle(door);
  EXPECT_EQ(host.run(300), "arrived 0 arrived 1");
}

TEST(Events, are_differences_after_a_restore) {
  Host host(watched_scene({robot_at({0, 0}, {4, 0}), robot_at({0, 5}, {30, 5})}));
  const std::vector<std::byte> start = host.simulation.save();
  host.simulation.remove_robot({1});
  EXPECT_EQ(host.run(100), "gone 1 arrived 0");
  host.simulation.add_robot(robot_at({-9, -9}, {-9, -9}));
  EXPECT_EQ(host.step(), "came 2 arrived 2");
  host.simulation.restore(start);
  EXPECT_EQ(host.look(), "left 0 came 1 gone 2");
  EXPECT_EQ(host.look(), "");
  EXPECT_EQ(host.run(100), "arrived 0") << "nobody is stuck since a time that is yet to come";
}

struct Seen {
  bool at_goal, unreachable;
  Vec2 goal;
};
using Fleet = std::map<std::uint64_t, Seen>;
using Kinds = std::vector<std::pair<std::uint64_t, EventKind>>;

Fleet asked(const Simulation& simulation) {
  Fleet seen;
  for (const RobotId id : simulation.fleet(Columns::id).id)
    seen[id.value] = {simulation.is_at_goal(id), false, simulation.robot(id).goal};
  for (const RobotId id : simulation.unreachable()) seen.at(id.value).unreachable = true;
  return seen;
}

Kinds differences(const Fleet& before, const Fleet& now) {
  Kinds kinds;
  for (const auto& [id, robot] : before)
    if (!now.contains(id)) kinds.emplace_back(id, EventKind::gone);
  for (const auto& [id, robot] : now) {
    const Seen& last = before.at(id);
    const bool is_new = !(last.goal == robot.goal);
    if (last.at_goal && (is_new || !robot.at_goal)) kinds.emplace_back(id, EventKind::left);
    if (robot.at_goal && (is_new || !last.at_goal)) kinds.emplace_back(id, EventKind::arrived);
    if (robot.unreachable && (is_new || !last.unreachable))
      kinds.emplace_back(id, EventKind::unreachable);
  }
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

// A fleet that the host edits at random, against what each robot says of itself.
TEST(Events, are_what_a_host_finds_that_asks_every_robot) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    test::Random random(9);
    Scenario scene = test::crowded_maze(60);
    scene.clock = clock;
    Host host(scene);
    Fleet before = asked(host.simulation);
    std::size_t number = 0;
    for (int k = 0; host.simulation.time() < 30.0; ++k) {
      const double share = random.uniform(0.0, 0.99);
      const auto any = static_cast<std::size_t>(share * static_cast<double>(before.size()));
      const RobotId robot = host.simulation.fleet(Columns::id).id[any];
      if (k % 3 == 0) host.simulation.set_goal(robot, test::cell_of_maze((13 * k) % 100));
      if (k % 31 == 0 && before.size() > 30) host.simulation.remove_robot(robot);
      host.simulation.step();
      Fleet now = asked(host.simulation);
      Kinds found;
      for (const Event& event : host.events.observe(host.simulation))
        if (event.kind != EventKind::stuck) found.emplace_back(event.robot.value, event.kind);
      EXPECT_EQ(found, differences(before, now)) << k;
      number += found.size();
      before = std::move(now);
    }
    EXPECT_GT(number, 30u);
  }
}

TEST(Events, are_equal_for_any_number_of_threads) {
  const auto story = [](int threads) {
    Host host(test::crowded_maze(300), 1.0, threads);
    std::string text;
    for (int k = 0; k < 60; ++k) {
      host.simulation.step();
      for (const Event& event : host.events.observe(host.simulation))
        text += std::to_string(k) + told({&event, 1}) + event.sentence + "\n";
    }
    return text;
  };
  const std::string alone = story(1);
  EXPECT_NE(alone.find("stuck"), std::string::npos);
  EXPECT_EQ(alone, story(3));
}

TEST(Events, are_refused_a_time_that_is_none) {
  const Simulation simulation(watched_scene({robot_at({0, 0}, {8, 0})}), 1);
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Events(simulation, {.stuck_after = wrong}), Error) << wrong;
}

}  // namespace
}  // namespace avo
