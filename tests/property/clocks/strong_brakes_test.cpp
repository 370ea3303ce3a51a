// SPDX-License-Identifier: Apache-2.0
// Robots that brake harder than they accelerate, among others that brake less hard, in a crush in a
// room: every model that brakes, both clocks, both certificates, with and without sensing errors,
// beside walls and people. Judged by Check.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "property/crushes.h"
#include "robots/drive.h"
#include "sim/columns/fleet.h"

namespace avo::test {
namespace {

constexpr int kRobots = 36, kPeople = 3;
constexpr double kRally = 6.0;    // s, from one to the next
constexpr double kExtent = 14.0;  // m

struct Condition {
  std::string name;
  Clock clock = Clock::common;
  Certificate certificate = Certificate::braking_trajectories;
  Motion motion = Motion::held;
  SensingModel sensing = {};
};

// The robot gets wheels that can surely do its acceleration.
void give_wheels(Random& random, RobotSetup& robot) {
  const double most = std::max(robot.max_acceleration, *robot.max_braking);
  switch (random.below(4)) {
    case 0:
      robot.model = Car{0.3};
      break;
    case 1:
      robot.model = DifferentialDrive{0.2, 0.1, 1.5, random.uniform(1.5, 2.0) * most};
      robot.radius -= 0.1;
      break;
    case 2:
      robot.model = Car{0.4, random.uniform(0.5, 3.0),
                        CarBody{random.uniform(-0.4, 0.4), robot.radius}, random.below(2) == 0,
                        random.below(2) == 0 ? AccelerationSet::exact : AccelerationSet::incircle};
      break;
    default:
      break;
  }
}

RobotSetup any_robot(Random& random, const Condition& condition) {
  RobotSetup robot;
  robot.radius = random.uniform(0.2, 0.4);
  robot.position = in_square(random, kExtent - 1.5);
  robot.max_acceleration = random.uniform(0.5, 2.0);
  robot.max_braking = random.log_uniform(0.5, 6.0) * robot.max_acceleration;
  robot.max_speed = robot.preferred_speed = 1.5;
  robot.heading = random.uniform(-3.0, 3.0);
  if (condition.motion == Motion::held) give_wheels(random, robot);
  if (condition.clock == Clock::free) robot.time_step = 0.01 * (5 + random.below(16));
  return robot;
}

Scenario crush(Random& random, const Condition& condition) {
  Scenario scene;
  scene.sensing_radius = 40.0, scene.max_neighbors = 10, scene.duration = 1000.0;
  scene.clock = condition.clock, scene.certificate = condition.certificate;
  scene.motion = condition.motion, scene.sensing = condition.sensing;
  scene.navigation = false;
  if (condition.clock == Clock::free) scene.longest_step = 0.2;
  const double half = 0.5 * kExtent;
  scene.obstacles = {
      {{{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true}}, 0.0, Fill::bounds}};
  while (scene.robots.size() < kRobots) {
    const RobotSetup robot = any_robot(random, condition);
    if (is_clear(robot, scene.robots)) scene.robots.push_back(robot);
  }
  if (condition.sensing.delay > 0 || condition.sensing.dropped > 0.0) return scene;  // no paths
  for (int k = 0; k < kPeople; ++k) {
    MovingObstacle person;
    person.position = {half + 3.0 + k, half + 3.0};
    person.radius = 0.25, person.max_deviation = 2.0, person.max_speed = 1.0;
    for (int point = 0; point < 6; ++point) person.path.push_back(in_square(random, kExtent));
    scene.moving_obstacles.push_back(person);
  }
  return scene;
}

class StrongBrakesCrush : public testing::TestWithParam<Condition> {};

TEST_P(StrongBrakesCrush, nobody_touches_anybody_or_a_wall_in_motion) {
  Random random(7);
  const Scenario scene = crush(random, GetParam());
  Simulation simulation(scene, 1);
  Check check = judge_of(scene);
  observe(simulation, check);
  bool brakes_hard = false;
  const double end = scene.clock == Clock::free ? 36.0 : 90.0;  // s; many instants, or few
  for (double rallied = -kRally; simulation.time() < end;) {
    if (simulation.time() >= rallied + kRally) {
      rallied = simulation.time();
      // now and then beyond the walls
      const Vec2 rally = in_square(random, 1.4 * kExtent);
      for (std::size_t k = 0; k < scene.robots.size(); ++k) simulation.set_goal({k}, rally);
    }
    simulation.step();
    observe(simulation, check);
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < fleet.id.size(); ++k)
      brakes_hard =
          brakes_hard || fleet.applied_acceleration[k] > 1.5 * fleet.setup[k].max_acceleration;
  }
  const CheckReport report = check.report();
  EXPECT_EQ(report.overlaps.count, 0) << "deepest " << report.overlaps.worst;
  EXPECT_EQ(report.static_contacts.count, 0) << "deepest " << report.static_contacts.worst;
  EXPECT_EQ(report.mover_contacts_moving.count, 0) << report.mover_contacts_moving.worst;
  EXPECT_FALSE(report.broken());
  EXPECT_EQ(report.accelerations.count, 0) << "by up to " << report.accelerations.worst;
  EXPECT_GT(report.robot_steps, 30'000);
  ASSERT_TRUE(report.least_clearance && report.least_static_clearance);
  EXPECT_LT(*report.least_clearance, 0.2);  // it was tight
  EXPECT_LT(*report.least_static_clearance, 0.2);
  EXPECT_GT(report.largest_speed, 1.0);  // and fast
  EXPECT_TRUE(brakes_hard);              // and this was about it
}

SensingModel noisy() {
  SensingModel sensing;
  sensing.noise.position = 0.01, sensing.noise.velocity = 0.02;
  return sensing;
}

SensingModel late() {
  SensingModel sensing = noisy();
  sensing.delay = 1, sensing.dropped = 0.05;
  return sensing;
}

INSTANTIATE_TEST_SUITE_P(
    , StrongBrakesCrush,
    testing::Values(Condition{"exact"}, Condition{"free_clocks", Clock::free},
                    Condition{"exponential", Clock::common, Certificate::braking_trajectories,
                              Motion::exponential},
                    Condition{.name = "noise", .sensing = noisy()},
                    Condition{.name = "late", .sensing = late()},
                    Condition{
                        .name = "free_clocks_noise", .clock = Clock::free, .sensing = noisy()}),
    [](const auto& condition) { return condition.param.name; });

// One robot passes a person. The person stands beside the robot's course, and might walk into the
// robot.
Scenario past_a_person(std::optional<double> max_braking) {
  Scenario scene;
  scene.sensing_radius = 20.0;
  RobotSetup robot;
  robot.position = {-12.0, 0.0}, robot.goal = {12.0, 0.0}, robot.max_braking = max_braking;
  scene.robots = {robot};
  MovingObstacle person;
  person.position = {0.0, 1.0}, person.radius = 0.25;
  person.max_deviation = 2.0, person.max_speed = 1.5;
  scene.moving_obstacles = {person};
  return scene;
}

// s
double arrival(const Scenario& scene) {
  Simulation simulation(scene, 1);
  while (simulation.time() < scene.duration && !simulation.is_at_goal({0})) simulation.step();
  return simulation.time();
}

// A robot that rests sooner may be faster beside a body that may come nearer.
TEST(StrongBrakes, bring_a_robot_past_people_sooner) {
  EXPECT_LT(arrival(past_a_person(3.0)), arrival(past_a_person(std::nullopt)) - 2.0);
}

// One that does not mind another robot may brake before it.
TEST(StrongBrakes, are_reckoned_with_by_those_whom_a_robot_does_not_avoid) {
  RobotSetup robot;
  const auto deviation = [&robot] {
    const Conduct conduct = conduct_of(robot, {});
    return sensed(traits_of(robot), conduct, Expectation::does_as_it_likes, {}, {}).max_deviation;
  };
  robot.max_braking = 3.0;
  EXPECT_EQ(deviation(), 3.0);
  robot.max_braking = 0.5;
  EXPECT_EQ(deviation(), robot.max_acceleration);
}

// Wheels have to be able to brake q that hard, in whichever direction q moves.
TEST(StrongBrakes, a_drive_chooses_no_velocity_from_which_it_could_not_brake) {
  Random random(3);
  int refused = 0;
  for (int k = 0; k < 3000; ++k) {
    Robot robot;
    robot.max_acceleration = random.uniform(0.5, 1.0), robot.max_braking = 2.0;
    const DifferentialDrive drive{0.4, 0.2, 2.0, random.uniform(2.9, 4.0)};
    robot.model = drive, robot.heading = random.uniform(-3.0, 3.0);
    const auto most = [&](Vec2 v, double heading) {
      const Vec2 h{std::cos(heading), std::sin(heading)}, to = v / norm(v);
      return most_speed(drive, *robot.max_braking, dot(h, to), cross(h, to));
    };
    const Vec2 way = random.direction();
    robot.velocity = random.uniform(0.5, 0.99) * most(way, robot.heading) * way;
    const double step = random.uniform(0.05, 0.2), u = robot.max_acceleration * step;
    const Vec2 wanted = robot.velocity + u * random.direction();
    const Vec2 chosen = within_own_limits(robot, step, wanted);
    refused += chosen == wanted ? 0 : 1;
    Plan plan;
    plan.acceleration = (chosen - robot.velocity) / step;
    const MotionState next =
        advance_drive(drive, {{}, robot.velocity, robot.heading}, plan, step).next;
    ASSERT_LE(norm(next.velocity), (1.0 + 1e-9) * most(next.velocity, next.heading)) << k;
  }
  EXPECT_GT(refused, 100);
}

// What a robot sees coming, its goal, it slows down for as it speeds up.
TEST(StrongBrakes, change_nothing_where_nobody_is_in_the_way) {
  for (const Method method : {Method::avo, Method::avo_paper, Method::buffered_voronoi}) {
    Scenario weak = past_a_person(std::nullopt), strong = past_a_person(3.0);
    weak.moving_obstacles.clear(), strong.moving_obstacles.clear();
    weak.method = strong.method = method;
    Simulation one(weak, 1), other(strong, 1);
    for (int step = 0; step < 150; ++step) {
      one.step(), other.step();
      ASSERT_EQ(one.state_hash(), other.state_hash()) << to_string(method) << ' ' << step;
    }
  }
}

}  // namespace
}  // namespace avo::test
