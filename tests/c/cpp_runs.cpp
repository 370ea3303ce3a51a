// SPDX-License-Identifier: Apache-2.0
#include "cpp_runs.h"

#include "avo/simulation.h"
#include "avo/space/explanation.h"
#include "avo/space/planner.h"
#include "avo/space/simulation.h"
#include "avo_io/scene.h"

namespace {

void step(avo::Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

std::vector<avo::RobotSetup> robots() {
  std::vector<avo::RobotSetup> robots(6);
  robots[0].position = {-8.0, -6.0}, robots[0].goal = {8.0, -5.0};
  robots[0].priority = 3.0;
  robots[1].position = {8.0, -3.0}, robots[1].goal = {-8.0, -4.0}, robots[1].heading = 3.1;
  robots[1].model = avo::Car{.wheelbase = 0.8,
                             .max_curvature = 0.9,
                             .body = avo::CarBody{0.3, 0.6},
                             .reverse = true,
                             .acceleration_set = avo::AccelerationSet::exact};
  robots[2].position = {-8.0, 2.0}, robots[2].goal = {8.0, 4.0};
  robots[2].max_speed = robots[2].preferred_speed = 1.2;
  robots[2].model = avo::DifferentialDrive{
      .track = 0.5, .offset = 0.25, .wheel_speed = 1.5, .wheel_acceleration = 2.5};
  robots[3].position = {-12.0, 8.0}, robots[3].goal = {12.0, 6.0}, robots[3].radius = 0.7;
  robots[3].behavior = avo::Behavior::cooperates;
  robots[4].position = robots[4].goal = {3.0, 7.0}, robots[4].behavior = avo::Behavior::parked;
  robots[5].position = {8.0, 5.0}, robots[5].goal = {-8.0, 3.0};
  robots[5].max_braking = 0.8, robots[5].layers = {4}, robots[5].avoids = {0xff};
  return robots;
}

avo::Scenario yard() {
  avo::Scenario scene;
  scene.sensing_radius = 20.0;
  scene.max_neighbors = 8;
  scene.control_time = 1.5;
  scene.response_time = 0.2, scene.margin = 0.1;
  scene.comfort_acceleration = 0.6, scene.comfort_jerk = 2.0;
  scene.never_swerves = true;
  scene.seed = 7;
  scene.right_of_way = avo::RightOfWay::none;
  scene.sensing.noise = {0.01, 0.02, avo::NoiseDistribution::uniform, {}};
  scene.robots = robots();
  scene.moving_obstacles = {{.position = {0.0, -12.0}, .velocity = {0.0, 0.5}, .radius = 0.4},
                            {.position = {12.0, 10.0},
                             .radius = 0.3,
                             .max_deviation = 0.5,
                             .max_speed = 1.0,
                             .path = {{12.0, 10.0}, {-12.0, 10.0}, {0.0, 12.0}}}};
  scene.obstacles = {
      {.chains = {{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, true}},
       .radius = 0.1,
       .fill = avo::Fill::solid},
      {.chains = {{{{-4.0, 0.0}, {-4.0, 1.0}}, false}, {{{4.0, 0.0}}, false}}, .radius = 0.2}};
  return scene;
}

}  // namespace

uint64_t cpp_scene_hash(const char* scene, const char* override, int steps) {
  std::vector<std::string> overrides;
  if (override != nullptr) overrides.emplace_back(override);
  const avo::Scenario scenario = avo_io::load_scenario(scene, overrides);
  avo::Simulation simulation(scenario, 1);
  step(simulation,
       steps > 0 ? steps : static_cast<int>(avo::last_step(scenario, scenario.duration)));
  return simulation.state_hash();
}

uint64_t cpp_sky_hash(int steps) {
  avo::Scenario scene;
  scene.sensing_radius = 80.0;
  scene.robots.resize(2);
  for (avo::RobotSetup& robot : scene.robots)
    robot.model = avo::Airplane{.min_speed = 1.0, .lateral_acceleration = 0.9};
  scene.robots[0].position = {-30.0, 20.0}, scene.robots[0].goal = {30.0, 20.0};
  scene.robots[0].velocity = {1.5, 0.0};
  scene.robots[1].position = {30.0, 19.5}, scene.robots[1].goal = {-30.0, 19.5};
  scene.robots[1].heading = 3.0;
  std::get<avo::Airplane>(scene.robots[0].model).after_goal = avo::AfterGoal::leave;
  avo::Simulation simulation(scene, 1);
  step(simulation, steps);
  return simulation.state_hash();
}

void cpp_yard_hashes(uint64_t hashes[3]) {
  avo::Simulation simulation(yard(), 1);
  step(simulation, 40);
  hashes[0] = simulation.state_hash();
  simulation.remove_robot({0});
  avo::RobotSetup added;
  added.position = {-14.0, -14.0}, added.goal = {14.0, -14.0};
  const avo::RobotId robot = simulation.add_robot(added);
  simulation.set_goal(robot, {14.0, -13.0});
  simulation.move_robot(robot, {-13.0, -14.0});
  simulation.add_obstacle({.chains = {{{{-20.0, -20.0}, {-18.0, -20.0}}, false}}});
  simulation.remove_obstacle({0});
  step(simulation, 40);
  hashes[1] = simulation.state_hash();
  step(simulation, 40);
  hashes[2] = simulation.state_hash();
}

namespace {

avo::space::Simulation space_after(int steps, bool senses_late) {
  avo::space::Scenario scenario;
  for (int k = 0; k < 6; ++k) {
    avo::space::RobotSetup& robot = scenario.robots.emplace_back();
    robot.position = {-9.0 + 0.1 * k, 2.5 * k - 6.0, 0.3 * k};
    robot.goal = {9.0, 6.0 - 2.5 * k, 1.0};
  }
  scenario.robots[1].downwash = 1.0;
  scenario.robots[2].vertical = 0.5;
  scenario.robots[2].climb = 0.7;
  scenario.robots[3].max_braking = 0.8;
  scenario.robots[3].priority = 2.0;
  scenario.robots[4].radius = 0.8;
  scenario.robots[4].preferred_speed = 1.5;
  scenario.robots[5].quadrotor = {
      .mass = 1.2, .max_thrust = 26.0, .max_tilt = 0.6, .attitude_time = 0.12};
  avo::space::Box floor;
  floor.max.z = -4.0;
  scenario.boxes.push_back(floor);
  if (senses_late) {
    scenario.seed = 7;
    scenario.sensing = {
        .noise = {.position = 0.02}, .delay = 2, .localization = {.position = 0.03}};
    scenario.sensing_error = avo::SensingError{0.3, 0.4};
  }
  avo::space::Simulation simulation(scenario);
  for (int k = 0; k < steps; ++k) simulation.step();
  return simulation;
}

}  // namespace

std::uint64_t cpp_space_hash(int steps, bool senses_late) {
  return space_after(steps, senses_late).state_hash();
}

void cpp_space_words(int steps, int robot, char* words, std::size_t capacity) {
  const avo::space::Simulation simulation = space_after(steps, false);
  const std::string sentence = simulation.explain({static_cast<std::uint64_t>(robot)}).sentence;
  words[sentence.copy(words, capacity - 1)] = '\0';
}

void cpp_space_decision(int neighbor_age, int mover_age, double next_velocity[3]) {
  avo::PlannerOptions options{.method = avo::Method::avo};
  options.sensing_error = {0.0, 0.05};
  avo::space::Robot robot;
  robot.velocity = {1.0, 0.0, 0.0}, robot.preferred_velocity = {2.0, 0.0, 0.0};
  options.wall_range = evasion_range(robot);
  avo::space::Neighbor other;
  other.position = {3.0, 0.1, 0.0}, other.velocity = {-1.0, 0.0, 0.0}, other.age = neighbor_age;
  avo::space::Mover mover;
  mover.position = {2.0, 8.0, 0.0}, mover.velocity = {0.0, -4.0, 0.0};
  mover.radius = 1.0, mover.max_deviation = 0.05, mover.age = mover_age;
  avo::space::Box floor;
  floor.max.z = -1.0;
  avo::space::PlanWorkspace workspace;
  const avo::space::Plan plan = avo::space::Planner(options).plan(
      robot, {&other, 1}, workspace, nullptr, {&floor, 1}, {&mover, 1});
  next_velocity[0] = plan.next_velocity.x, next_velocity[1] = plan.next_velocity.y;
  next_velocity[2] = plan.next_velocity.z;
}
