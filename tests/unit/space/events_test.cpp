// SPDX-License-Identifier: Apache-2.0
// Each kind of event in space happens once, when it begins, whatever the host does in between.
#include "avo/space/events.h"

#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/space/explanation.h"
#include "unit/metrics/watched_host.h"
#include "unit/space/draws.h"

namespace avo::space::tests {
namespace {

using test::told;

constexpr double kEndless = std::numeric_limits<double>::infinity();

RobotSetup robot_at(Vec3 position, Vec3 goal) {
  RobotSetup robot;
  robot.position = position, robot.goal = goal;
  return robot;
}

Scenario scene_of(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.robots = std::move(robots);
  return scene;
}

using Host = test::WatchedHostOf<Scenario, Simulation, Events>;

TEST(EventsInSpace, are_arrivals_when_they_happen_and_once) {
  Host host(scene_of({robot_at({0, 0, 0}, {4, 4, 4}), robot_at({0, 0, 5}, {0, 0, 5})}));
  EXPECT_EQ(host.look(), "") << "what holds at the start is no event";
  while (!host.simulation.is_at_goal({0})) {
    host.simulation.step();
    EXPECT_EQ(host.look(), host.simulation.is_at_goal({0}) ? "arrived 0" : "");
    ASSERT_LT(host.simulation.time(), 20.0);
  }
  EXPECT_EQ(host.run(100), "");
}

TEST(EventsInSpace, are_departures_by_another_goal) {
  Host host(scene_of({robot_at({0, 0, 0}, {0, 0, 0}), robot_at({9, 0, 0}, {9, 0, 0})}));
  host.simulation.set_goal({0}, {0, 0, 6});
  host.simulation.set_goal({1}, {9, 0, 0.1});  // within arrival_distance: it is there at once
  EXPECT_EQ(host.step(), "left 0 left 1 arrived 1");
  EXPECT_EQ(host.run(150), "arrived 0");
  host.simulation.set_goal({0}, {0, 0, -6});
  host.simulation.set_goal({0}, {0, 0, 6});
  EXPECT_EQ(host.step(), "") << "nothing is another than before";
}

// A wall with a hole, and what closes it.
std::vector<Box> wall(bool is_closed) {
  std::vector<Box> boxes{{.min = {0, 2, -kEndless}, .max = {1, kEndless, kEndless}},
                         {.min = {0, -kEndless, -kEndless}, .max = {1, -2, kEndless}},
                         {.min = {0, -2, 2}, .max = {1, 2, kEndless}},
                         {.min = {0, -2, -kEndless}, .max = {1, 2, -2}}};
  if (is_closed) boxes.push_back({.min = {0, -2, -2}, .max = {1, 2, 2}});
  return boxes;
}

TEST(EventsInSpace, are_goals_that_boxes_shut_off) {
  Scenario scene = scene_of({robot_at({-8, 0, 0}, {8, 0, 0}), robot_at({-8, 3, 0}, {-12, 3, 0})});
  scene.boxes = wall(false);
  Host host(scene);
  host.simulation.set_boxes(wall(true));
  EXPECT_EQ(host.step(), "unreachable 0");
  EXPECT_EQ(host.run(100), "arrived 1") << "it stands at the door, and is not stuck";
  host.simulation.set_goal({0}, {8, 1, 0});
  EXPECT_EQ(host.step(), "unreachable 0") << "the host has to know of this goal, too";
  host.simulation.set_boxes(wall(false));
  EXPECT_EQ(host.run(300), "arrived 0");
}

// A robot in a shaft of one lane, behind one that hardly moves and has its goal there.
Scenario blocked_shaft() {
  Scenario scene = scene_of({robot_at({0, 0, 0}, {0, 0, 0}), robot_at({-6, 0, 0}, {12, 0, 0})});
  scene.robots[0].max_speed = scene.robots[0].preferred_speed = 1e-3;
  scene.boxes = {{.min = {-20, 0.8, -kEndless}, .max = {20, kEndless, kEndless}},
                 {.min = {-20, -kEndless, -kEndless}, .max = {20, -0.8, kEndless}},
                 {.min = {-20, -0.8, 0.8}, .max = {20, 0.8, kEndless}},
                 {.min = {-20, -0.8, -kEndless}, .max = {20, 0.8, -0.8}},
                 {.min = {-20, -0.8, -0.8}, .max = {-19, 0.8, 0.8}}};
  return scene;
}

TEST(EventsInSpace, are_robots_without_progress_once_and_why) {
  Host host(blocked_shaft());
  int stuck = 0;
  double since = 0.0;  // s
  for (int k = 0; k < 300; ++k) {
    host.simulation.step();
    for (const Event& event : host.events.observe(host.simulation)) {
      EXPECT_EQ(told({&event, 1}), "stuck 1");
      EXPECT_EQ(event.sentence, host.simulation.explain({1}).sentence);
      ++stuck;
      since = host.simulation.time();
    }
  }
  EXPECT_EQ(stuck, 1);
  EXPECT_GT(since, 4.0) << "it has made progress before";
  host.simulation.set_goal({1}, {12, 0, 0.1});
  EXPECT_EQ(host.run(25), "") << "a new goal counts anew";
  EXPECT_EQ(host.run(25), "stuck 1");
}

TEST(EventsInSpace, are_contacts_with_moving_obstacles_when_they_begin) {
  Scenario scene = scene_of({robot_at({0, 0, 0}, {0, 0, 0}), robot_at({9, 30, 0}, {9, 30, 0})});
  scene.certificate = Certificate::none;
  scene.sensing_radius = 1e-3;  // no robot evades
  scene.moving_obstacles = {{.position = {-6, 0.2, 0}, .velocity = {1, 0, 0}, .radius = 0.5},
                            {.position = {0, 0, 4.03}, .velocity = {0, 0, -1}, .radius = 0.4},
                            {.position = {9, 36, 0.95}, .velocity = {0, -1, 0}, .radius = 0.4}};
  Host host(scene);
  const std::vector<std::pair<std::size_t, std::size_t>> pairs{{0, 0}, {0, 1}, {1, 2}};
  std::vector<bool> before(3, false);
  std::string all;
  for (int k = 0; k < 150; ++k) {
    const std::string now = host.step();
    std::string expected;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      const auto [robot, mover] = pairs[p];
      const Mover& ball = host.simulation.movers()[mover];
      const bool touches =
          norm(ball.position - host.simulation.robots()[robot].position) < 0.5 + ball.radius;
      if (touches && !before[p])
        expected += (expected.empty() ? "contact " : " contact ") + std::to_string(robot) + "/" +
                    std::to_string(mover) + " rest";
      before[p] = touches;
    }
    EXPECT_EQ(now, expected) << k;
    if (!now.empty()) all += now + "; ";
  }
  EXPECT_EQ(all, "contact 0/1 rest; contact 0/0 rest; ") << "the third passes above";
}

struct Seen {
  bool at_goal, unreachable;
  Vec3 goal;
};

std::vector<Seen> asked(const Simulation& simulation) {
  std::vector<Seen> seen;
  for (std::uint64_t k = 0; k < simulation.size(); ++k)
    seen.push_back({simulation.is_at_goal({k}), false, simulation.goal({k})});
  for (const RobotId id : simulation.unreachable())
    seen[static_cast<std::size_t>(id.value)].unreachable = true;
  return seen;
}

// A fleet that the host edits at random, against what each robot says of itself.
TEST(EventsInSpace, are_what_a_host_finds_that_asks_every_robot) {
  Scenario scene;
  Draws draws(4);
  for (int k = 0; k < 40; ++k) {
    const Vec3 place{-10.0 + 1.5 * (k % 4), 1.5 * (k / 4 % 4), 1.5 * (k / 16)};
    scene.robots.push_back(robot_at(place, {-place.x, place.y, place.z}));
  }
  scene.boxes = wall(false);
  Host host(scene);
  std::vector<Seen> before = asked(host.simulation);
  std::size_t number = 0;
  for (int k = 0; host.simulation.time() < 30.0; ++k) {
    const RobotId any{static_cast<std::uint64_t>(draws.below(40))};
    const double side = draws.below(2) == 0 ? -6.0 : 6.0;
    if (k % 4 == 0) host.simulation.set_goal(any, {side, draws.between(-3, 3), 0.0});
    if (k == 200) host.simulation.set_goal({7}, {0.5, 3.0, 0.0});  // in the wall
    host.simulation.step();
    const std::vector<Seen> now = asked(host.simulation);
    std::vector<std::pair<std::uint64_t, EventKind>> found, expected;
    for (const Event& event : host.events.observe(host.simulation))
      if (event.kind != EventKind::stuck) found.emplace_back(event.robot.value, event.kind);
    for (std::size_t r = 0; r < now.size(); ++r) {
      const bool is_new = !(now[r].goal == before[r].goal);
      if (before[r].at_goal && (is_new || !now[r].at_goal))
        expected.emplace_back(r, EventKind::left);
      if (now[r].at_goal && (is_new || !before[r].at_goal))
        expected.emplace_back(r, EventKind::arrived);
      if (now[r].unreachable && (is_new || !before[r].unreachable))
        expected.emplace_back(r, EventKind::unreachable);
    }
    EXPECT_EQ(found, expected) << k;
    number += found.size();
    before = now;
  }
  EXPECT_GT(number, 50U);
}

TEST(EventsInSpace, are_equal_for_any_number_of_threads) {
  const auto story = [](int threads) {
    Scenario scene;
    Draws draws(8);
    for (int k = 0; k < 300; ++k) {
      const Vec3 place{1.6 * (k % 7), 1.6 * (k / 7 % 7), 1.6 * (k / 49)};
      scene.robots.push_back(robot_at(place, k % 2 == 0 ? place : place + draws.within(9.0)));
    }
    Host host(scene, 1.0, threads);
    std::string text;
    for (int k = 0; k < 50; ++k) {
      host.simulation.step();
      for (const Event& event : host.events.observe(host.simulation))
        text += std::to_string(k) + told({&event, 1}) + event.sentence + "\n";
    }
    return text;
  };
  const std::string alone = story(1);
  EXPECT_NE(alone.find("stuck"), std::string::npos);
  EXPECT_NE(alone.find("arrived"), std::string::npos);
  EXPECT_EQ(alone, story(3));
}

TEST(EventsInSpace, change_no_decision) {
  const Scenario scene = blocked_shaft();
  Host host(scene, 0.5);
  Simulation alone(scene);
  for (int k = 0; k < 150; ++k) {
    host.step();
    alone.step();
    ASSERT_EQ(host.simulation.state_hash(), alone.state_hash()) << k;
  }
}

TEST(EventsInSpace, are_refused_a_time_that_is_none) {
  const Simulation simulation(scene_of({robot_at({0, 0, 0}, {8, 0, 0})}));
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Events(simulation, {.stuck_after = wrong}), Error) << wrong;
}

}  // namespace
}  // namespace avo::space::tests
