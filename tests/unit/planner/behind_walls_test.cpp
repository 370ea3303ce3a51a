// SPDX-License-Identifier: Apache-2.0
// Neighbors behind walls do not count, until they can come round an end in time.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "avo/check.h"
#include "support/walls.h"

namespace avo {
namespace {

using test::gap_to;
using test::Random;
using test::seen;

constexpr double kRadius = 0.5;

PlannerOptions braking(Motion motion = Motion::held) {
  return test::options_of(Certificate::braking_trajectories, motion, 0.1, 2.0);
}

Robot robot_at(Vec2 position, Vec2 velocity, Vec2 preferred, double radius = kRadius) {
  Robot robot;
  robot.position = position, robot.velocity = velocity, robot.preferred_velocity = preferred;
  robot.radius = radius, robot.max_speed = 2.0, robot.max_acceleration = 1.0;
  robot.distance_to_goal = 100.0;
  return robot;
}

Plan plan_of(const Planner& planner, const Robot& robot, const std::vector<Neighbor>& neighbors,
             const std::vector<Wall>& walls) {
  PlanWorkspace workspace;
  Detour detour;
  return planner.plan(robot, neighbors, workspace, &detour, walls);
}

bool is_same(const Plan& one, const Plan& other) {
  return one.new_velocity == other.new_velocity && one.next_velocity == other.next_velocity &&
         one.status == other.status && one.violation == other.violation;
}

// Held motion.
void move(Robot& robot, const Plan& plan) {
  robot.position = robot.position + 0.05 * (robot.velocity + plan.next_velocity);
  robot.velocity = plan.next_velocity;
}

const Wall kWall{{-20, 0}, {20, 0}};

TEST(BehindWalls, TwoOnBothSidesOfAWallKeepTheirSpeedAndTheirLine) {
  const Planner planner(braking());
  std::vector<Robot> robots{robot_at({-6, 0.51}, {1.5, 0}, {1.5, 0}),
                            robot_at({6, -0.51}, {-1.5, 0}, {-1.5, 0})};
  for (int k = 0; k < 80; ++k) {
    const std::vector<Robot> now = robots;
    for (std::size_t i = 0; i < 2; ++i) {
      const Plan plan = plan_of(planner, now[i], {seen(now[1 - i])}, {kWall});
      EXPECT_EQ(plan.status, PlanStatus::optimal);
      EXPECT_NEAR(plan.next_velocity.x, now[i].preferred_velocity.x, 1e-9);
      EXPECT_NEAR(plan.next_velocity.y, 0.0, 1e-9);
      move(robots[i], plan);
    }
  }
  EXPECT_GT(robots[0].position.x, 5.9);
  EXPECT_LT(robots[1].position.x, -5.9);
}

// Towards the wall's end they come nearer and nearer: at first neither counts, at last each does.
TEST(BehindWalls, WhoCanComeRoundAnEndInTimeCounts) {
  const Planner planner(braking());
  int left_out = 0, counted = 0;
  for (double before = 12.0; before > 0.5; before -= 0.1) {
    const Robot robot = robot_at({20.0 - before, 0.6}, {1.5, 0}, {1.5, -0.2});
    const Robot other = robot_at({20.0 - before, -0.6}, {1.5, 0}, {1.5, 0.2});
    const Plan plan = plan_of(planner, robot, {seen(other)}, {kWall});
    const bool is_left_out = is_same(plan, plan_of(planner, robot, {}, {kWall}));
    // S dt + l(S) of 1.6 m/s is 0.16 m + 1.28 m and what steps cost, for each
    const double reach = 2.0 * (kRadius + 0.16 + 1.28 + 0.08);
    if (2.0 * std::hypot(before, 0.6) > reach + 0.01) {
      EXPECT_TRUE(is_left_out) << before;
      ++left_out;
    } else if (2.0 * std::hypot(before, 0.6) < reach - 0.1) {
      EXPECT_FALSE(is_left_out) << before;
      ++counted;
    }
  }
  EXPECT_GT(left_out, 50);
  EXPECT_GT(counted, 5);
}

TEST(BehindWalls, WhoIsOnTheSameSideOrInTheWallCounts) {
  const Planner planner(braking());
  const Robot robot = robot_at({0, 0.6}, {1.0, 0}, {1.5, 0});
  const Plan alone = plan_of(planner, robot, {}, {kWall});
  const auto counts = [&](Vec2 p, const std::vector<Wall>& walls) {
    const Neighbor other = seen(robot_at(p, {-1.0, 0.0}, {}));
    return !is_same(plan_of(planner, robot, {other}, walls), alone);
  };
  EXPECT_FALSE(counts({1.5, -0.6}, {kWall}));
  EXPECT_TRUE(counts({1.5, 0.6}, {kWall}));
  EXPECT_TRUE(counts({1.5, -0.6}, {{{-20, 0}, {0.5, 0}}})) << "beyond the end";
  EXPECT_TRUE(counts({1.5, -0.45}, {kWall})) << "one that the wall has not kept away";
}

TEST(BehindWalls, MoversAlwaysCount) {
  const Planner planner(braking());
  const Robot robot = robot_at({0, 0.6}, {1.0, 0}, {1.5, 0});
  const Neighbor friendly = seen(robot_at({-8, 0.6}, {}, {}));
  Neighbor other = seen(robot_at({2.0, -0.8}, {-0.3, 0.7}, {}));
  const Plan without = plan_of(planner, robot, {friendly}, {kWall});
  EXPECT_TRUE(is_same(plan_of(planner, robot, {friendly, other}, {kWall}), without));
  for (const Behavior behavior : {Behavior::moves_on, Behavior::cooperates}) {
    other.behavior = behavior;
    EXPECT_FALSE(is_same(plan_of(planner, robot, {friendly, other}, {kWall}), without));
  }
}

TEST(BehindWalls, WithSensingErrorsAllCount) {
  PlannerOptions options = braking();
  options.sensing_error = {0.01, 0.0};
  const Robot robot = robot_at({0, 0.6}, {1.0, 0}, {1.5, 0});
  const Neighbor other = seen(robot_at({1.5, -0.6}, {-1.0, 0}, {}));
  const Planner planner(options);
  EXPECT_FALSE(
      is_same(plan_of(planner, robot, {other}, {kWall}), plan_of(planner, robot, {}, {kWall})));
}

// Neighbors that are left out get no half-plane, and no farther neighbor gets one in their place.
TEST(BehindWalls, TheyCountAmongTheNearest) {
  PlannerOptions options = braking();
  options.max_neighbors = 1;
  const Robot robot = robot_at({0, 0.6}, {1.0, 0}, {1.5, 0});
  const Neighbor hidden = seen(robot_at({0.3, -0.6}, {}, {}));
  const Neighbor ahead = seen(robot_at({9.0, 0.6}, {-2.0, 0}, {}));
  const Planner planner(options), all(braking());
  const std::vector<Wall> walls{kWall};
  const Plan alone = plan_of(planner, robot, {}, walls);
  EXPECT_FALSE(is_same(plan_of(planner, robot, {ahead}, walls), alone));
  EXPECT_TRUE(is_same(plan_of(planner, robot, {hidden, ahead}, walls), alone));
  const auto planes = [&](const std::vector<Neighbor>& neighbors) {
    PlanWorkspace workspace;
    HalfPlanes half_planes;
    planner.collect_half_planes(robot, neighbors, workspace, half_planes, walls);
    return half_planes.planes.size();
  };
  EXPECT_EQ(planes({ahead}), 1u);
  EXPECT_EQ(planes({hidden, ahead}), 0u) << "listed as they are planned with";
  EXPECT_TRUE(
      is_same(plan_of(all, robot, {hidden, ahead}, walls), plan_of(all, robot, {ahead}, walls)));
}

// m, as Planner::plan() documents it.
double documented_reach(const Robot& robot, const PlannerOptions& options) {
  const StepLaw law = test::law_of(options).step;
  const double speed = std::max(norm(robot.velocity), robot.max_speed);
  const double u = braking_decrement(robot.max_acceleration, law);
  return (robot.radius + law.time_step * speed + stopping_length(speed, u, law)) * (1.0 + 1e-9);
}

TEST(BehindWalls, WallsBeyondTheReachChangeNoBit) {
  int with = 0, beyond = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Motion motion = seed % 2 == 0 ? Motion::held : Motion::exponential;
    const Planner planner(braking(motion));
    const std::vector<Wall> walls = test::random_walls(random, 16.0, 0.3);
    const Vec2 place = test::free_place(random, walls, 16.0, 0.31);
    const Robot robot = robot_at(place, {}, 1.5 * random.direction(), 0.3);
    Robot moving = robot;
    moving.velocity = random.uniform(0.0, 0.4) * random.direction();
    std::vector<Neighbor> neighbors;
    for (int k = 0; k < 6; ++k) {
      Robot other = robot_at(test::free_place(random, walls, 16.0, 0.31),
                             random.uniform(0.0, 0.4) * random.direction(), {}, 0.3);
      // one nearly in contact, which pushes
      if (k == 0) other.position = place + random.uniform(0.61, 0.74) * random.direction();
      const bool is_free = test::gap_to_all(other.position, walls) > 0.31;
      if (is_free && norm(other.position - place) > 0.6) neighbors.push_back(seen(other));
    }
    std::vector<Wall> near;
    for (const Wall& wall : walls) {
      if (gap_to(place, wall) <= documented_reach(moving, planner.options())) near.push_back(wall);
    }
    with += static_cast<int>(near.size());
    beyond += static_cast<int>(walls.size() - near.size());
    EXPECT_TRUE(is_same(plan_of(planner, moving, neighbors, walls),
                        plan_of(planner, moving, neighbors, near)));
  }
  EXPECT_GT(with, 10000);
  EXPECT_GT(beyond, 10000);
}

// Two robots on both sides of short walls that try to meet each other round an end.
struct Chase {
  std::vector<Wall> walls;
  std::vector<Robot> robots;
};

Chase random_chase(Random& random) {
  Chase chase;
  const double half = random.uniform(0.3, 2.5);
  chase.walls.push_back({{-half, 0}, {half, 0}, random.below(4) == 0 ? 0.1 : 0.0});
  if (random.below(3) == 0) {
    const Vec2 a{random.uniform(-4.0, 4.0), random.uniform(-3.0, 3.0)};
    chase.walls.push_back({a, a + random.uniform(0.2, 1.5) * random.direction()});
  }
  for (const double side : {1.0, -1.0}) {
    Vec2 place;
    do {
      const double away = random.uniform(0.0, 1.0);
      place = {random.uniform(-half - 0.5, half + 0.5), side * (0.41 + 2.0 * away * away)};
    } while (test::gap_to_all(place, chase.walls) < 0.301);
    chase.robots.push_back(robot_at(place, {}, {}, 0.3));
  }
  return chase;
}

// To the end or the other one, nearly; now and then anywhere.
Vec2 random_wish(Random& random, const Chase& chase, std::size_t i) {
  const int kind = random.below(8);
  const Vec2 p = chase.robots[i].position;
  if (kind == 0) return random.uniform(0.0, 2.0) * random.direction();
  const Vec2 end = chase.robots[0].position.x > 0.0 ? chase.walls[0].b : chase.walls[0].a;
  const Vec2 aim = kind < 6 ? end + 0.5 * random.direction() : chase.robots[1 - i].position;
  return (2.0 / std::max(norm(aim - p), 1e-3)) * (aim - p);
}

TEST(BehindWalls, NobodyWhoComesRoundAnEndIsTouched) {
  constexpr int kChases = 2000, kSteps = 60;
  PlanWorkspace workspace;
  std::int64_t robot_steps = 0, overlaps = 0, touched = 0;
  double least = 1.0;
  for (std::uint64_t seed = 1; seed <= kChases; ++seed) {
    Random random(seed);
    const Planner planner(
        test::options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
    Chase chase = random_chase(random);
    std::vector<CheckedRobot> judged(2, {.radius = 0.3, .max_acceleration = 1.0, .max_speed = 2.0});
    Check check(judged);
    std::vector<CheckedWall> walls;
    for (const Wall& wall : chase.walls) walls.push_back({wall.a, wall.b, wall.radius});
    check.set_walls(walls);
    std::vector<Detour> detours(2);
    for (int k = 0; k <= kSteps; ++k) {
      std::vector<CheckedState> rows;
      for (std::int64_t i = 0; i < 2; ++i) {
        const Robot& robot = chase.robots[static_cast<std::size_t>(i)];
        rows.push_back({i, robot.position, robot.velocity});
      }
      check.add(0.1 * k, rows);
      const std::vector<Robot> now = chase.robots;
      for (std::size_t i = 0; i < 2; ++i) {
        Robot robot = now[i];
        if (k % 8 == 0)
          chase.robots[i].preferred_velocity = robot.preferred_velocity =
              random_wish(random, chase, i);
        const Neighbor other = seen(now[1 - i]);
        move(chase.robots[i],
             planner.plan(robot, {&other, 1}, workspace, &detours[i], chase.walls));
      }
    }
    const CheckReport report = check.report();
    robot_steps += report.robot_steps;
    overlaps += report.overlaps.count, touched += report.static_contacts.count;
    least = std::min(least, report.least_clearance.value_or(1.0));
  }
  EXPECT_GE(robot_steps, 200000);
  EXPECT_EQ(overlaps, 0);
  EXPECT_EQ(touched, 0);
  EXPECT_LT(least, 0.01) << "nobody came near";
}

}  // namespace
}  // namespace avo
