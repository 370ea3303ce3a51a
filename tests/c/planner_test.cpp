// SPDX-License-Identifier: Apache-2.0
// A planner from C decides as one of C++ does, bit by bit, for all that robots of built-in scenes
// see; and several threads may share it.
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <variant>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "check.h"

namespace {

avo_vec2 to_c(avo::Vec2 v) {
  return {v.x, v.y};
}

avo_loiter_circle to_c(const std::optional<avo::LoiterCircle>& circle) {
  if (!circle) return {{0.0, 0.0}, 0.0};
  return {to_c(circle->center), circle->radius};
}

avo_footprint to_c(const avo::Footprint& footprint) {
  return {footprint.radius, footprint.first, footprint.spacing, footprint.discs};
}

avo_robot to_c(const avo::Robot& robot) {
  avo_robot c = avo_default_robot();
  c.position = to_c(robot.position);
  c.velocity = to_c(robot.velocity);
  c.preferred_velocity = to_c(robot.preferred_velocity);
  c.radius = robot.radius;
  c.max_acceleration = robot.max_acceleration;
  c.max_speed = robot.max_speed;
  c.distance_to_goal = robot.distance_to_goal;
  c.heading = robot.heading;
  c.priority = robot.priority;
  c.max_braking = robot.max_braking.value_or(0.0);
  c.loiter = to_c(robot.loiter);
  c.footprint = to_c(avo::footprint_of(robot.model));
  c.lookahead = robot.lookahead;
  c.model = static_cast<avo_model>(robot.model.index());
  if (const auto* car = std::get_if<avo::Car>(&robot.model)) {
    c.car.wheelbase = car->wheelbase;
    c.car.max_curvature = car->max_curvature.value_or(0.0);
    if (car->body) c.car.body = {car->body->offset, car->body->radius};
    c.car.reverse = car->reverse;
    c.car.acceleration_set = static_cast<avo_acceleration_set>(car->acceleration_set);
  }
  if (const auto* drive = std::get_if<avo::DifferentialDrive>(&robot.model))
    c.drive = {drive->track, drive->offset, drive->wheel_speed, drive->wheel_acceleration};
  if (const auto* airplane = std::get_if<avo::Airplane>(&robot.model))
    c.airplane = {airplane->min_speed, airplane->lateral_acceleration,
                  static_cast<avo_after_goal>(airplane->after_goal)};
  return c;
}

avo_neighbor to_c(const avo::Neighbor& neighbor) {
  avo_neighbor c = avo_default_neighbor();
  c.position = to_c(neighbor.position);
  c.velocity = to_c(neighbor.velocity);
  c.radius = neighbor.radius;
  c.max_acceleration = neighbor.max_acceleration;
  c.priority = neighbor.priority;
  c.max_braking = neighbor.max_braking.value_or(0.0);
  c.loiter = to_c(neighbor.loiter);
  c.max_deviation = neighbor.max_deviation;
  c.position_error = neighbor.position_error;
  c.acceleration = to_c(neighbor.acceleration);
  c.max_speed = neighbor.max_speed;
  c.likely_deviation = neighbor.likely_deviation;
  c.behavior = static_cast<avo_behavior>(neighbor.behavior);
  c.age = neighbor.age;
  c.parting = to_c(neighbor.parting);
  c.footprint = to_c(neighbor.footprint);
  c.pose = {to_c(neighbor.ahead), neighbor.spread};
  if (neighbor.trajectory == nullptr) return c;
  std::vector<avo_timed_place> places;
  for (const auto& [time, position] : neighbor.trajectory->places())
    places.push_back({time, to_c(position)});
  REQUIRE(avo_create_trajectory(places.data(), places.size(), neighbor.trajectory->error(),
                                neighbor.trajectory->repeats_from().value_or(std::nan("")),
                                &c.trajectory));
  c.trajectory_time = neighbor.trajectory_time;
  return c;
}

avo_planner_def to_c(const avo::PlannerOptions& options) {
  avo_planner_def def = avo_default_planner_def(static_cast<avo_method>(options.method));
  def.motion = static_cast<avo_motion>(options.motion);
  def.control_time = options.control_time;
  def.time_horizon = options.time_horizon;
  def.time_step = options.time_step;
  def.certificate = static_cast<avo_certificate>(options.certificate);
  def.max_neighbors = options.max_neighbors.value_or(0);
  def.clock = static_cast<avo_clock>(options.clock);
  def.sensing_error = {options.sensing_error.position, options.sensing_error.velocity};
  def.sensing_noise = {options.sensing_noise.position, options.sensing_noise.velocity,
                       options.sensing_noise.quantile};
  def.longest_step = options.longest_step;
  def.arrival_distance = options.arrival_distance;
  def.response_time = options.response_time;
  def.comfort_acceleration = options.comfort_acceleration.value_or(0.0);
  def.comfort_jerk = options.comfort_jerk.value_or(0.0);
  def.margin = options.margin, def.wall_range = options.wall_range;
  def.never_swerves = options.never_swerves;
  return def;
}

bool is_same(avo_vec2 a, avo::Vec2 b) {
  return std::bit_cast<avo::Vec2>(a) == b;
}

bool is_same(const avo_plan& a, const avo::Plan& b) {
  return is_same(a.new_velocity, b.new_velocity) && is_same(a.next_velocity, b.next_velocity) &&
         is_same(a.acceleration, b.acceleration) &&
         a.status == static_cast<avo_plan_status>(b.status) &&
         a.state == static_cast<avo_safety_state>(b.state) && a.violation == b.violation &&
         a.neighbor == b.neighbor && a.wall == b.wall && a.depth == b.depth &&
         a.evading == b.evading;
}

// What one robot sees, as C and as C++ plan with it.
void check_decision(avo_planner_id planner, const avo::Planner& own,
                    const avo::Simulation::Perception& seen) {
  const avo_robot robot = to_c(seen.robot);
  std::vector<avo_neighbor> neighbors;
  for (const avo::Neighbor& neighbor : seen.neighbors) neighbors.push_back(to_c(neighbor));
  std::vector<avo_wall> walls;
  for (const avo::Wall& wall : seen.walls)
    walls.push_back({to_c(wall.a), to_c(wall.b), wall.radius});

  avo::PlanWorkspace workspace;
  avo::Detour detour = seen.detour;
  auto remembered = std::bit_cast<avo_detour>(seen.detour);
  avo_plan plan;
  REQUIRE(avo_planner_plan(planner, &robot, neighbors.data(), neighbors.size(), walls.data(),
                           walls.size(), &remembered, &plan));
  CHECK(is_same(plan, own.plan(seen.robot, seen.neighbors, workspace, &detour, seen.walls)));
  CHECK(remembered.angle == detour.angle && remembered.beside == detour.beside);
  CHECK(remembered.congestion == detour.congestion);
  CHECK(remembered.has_arrived == detour.has_arrived);
  CHECK(remembered.acceleration_x == detour.acceleration_x);
  CHECK(remembered.acceleration_y == detour.acceleration_y);

  REQUIRE(
      avo_planner_plan_among_movers(planner, &robot, neighbors.data(), neighbors.size(), &plan));
  CHECK(is_same(plan, own.plan_among_movers(seen.robot, seen.neighbors, workspace)));

  avo_safety_report report;
  REQUIRE(avo_planner_state(planner, &robot, neighbors.data(), neighbors.size(), walls.data(),
                            walls.size(), &report));
  const avo::SafetyReport expected = own.state(seen.robot, seen.neighbors, workspace, seen.walls);
  CHECK(report.state == static_cast<avo_safety_state>(expected.state));
  CHECK(report.neighbor == expected.neighbor && report.wall == expected.wall);
  CHECK(report.time == expected.time && report.depth == expected.depth);
  for (const avo_neighbor& neighbor : neighbors) {
    if (avo_trajectory_is_valid(neighbor.trajectory))
      REQUIRE(avo_destroy_trajectory(neighbor.trajectory));
  }
}

void check_decisions(const char* name, const avo::Scenario& scene) {
  avo::Simulation simulation(scene, 1);
  const avo_planner_def def = to_c(simulation.planner().options());
  avo_planner_id planner;
  REQUIRE(avo_create_planner(&def, &planner));
  std::vector<avo::Simulation::Perception> seen;
  for (int step = 0; step < 60; ++step) {
    simulation.step();
    if (step % 12 != 0) continue;
    for (std::size_t i = 0; i < simulation.fleet().id.size(); ++i)
      seen.push_back(simulation.perceive({i}));
  }
  const auto check_all = [&] {
    for (const auto& one : seen) check_decision(planner, simulation.planner(), one);
  };
  std::thread other(check_all);
  check_all();
  other.join();
  std::printf("%s: %zu decisions\n", name, seen.size());
  REQUIRE(avo_destroy_planner(planner));
}

void check_scene(const char* name, const std::vector<std::string>& overrides) {
  check_decisions(name, avo_io::load_scenario(name, overrides));
}

// Trucks at a corner maneuver by `lookahead`, and know each other's footprints.
void check_trucks() {
  avo::Scenario scene;
  scene.obstacles = {{.chains = {avo::Chain{{{-30, -4}, {4, -4}, {4, 30}}, false}}},
                     {.chains = {avo::Chain{{{-30, 4}, {-4, 4}, {-4, 30}}, false}}}};
  for (const double back : {0.0, 9.0}) {
    avo::Car car{.wheelbase = 3.5, .max_curvature = 0.2, .reverse = true};
    car.footprint = avo::cover_rectangle(6.0, 2.0, 1.75, 0.5);
    scene.robots.push_back({.position = {-8.0 - back, 0.0}, .goal = {0.0, 24.0 - back}});
    scene.robots.back().model = car;
  }
  check_decisions("trucks at a corner", scene);
}

void check_invalid_input() {
  const avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_planner_id planner;
  REQUIRE(avo_create_planner(&def, &planner));
  avo_robot robot = avo_default_robot();
  avo_neighbor neighbor = avo_default_neighbor();
  neighbor.position = {5.0, 0.0};
  avo_plan plan;
  REQUIRE(avo_planner_plan(planner, &robot, &neighbor, 1, nullptr, 0, nullptr, &plan));
  CHECK(plan.status == AVO_PLAN_OPTIMAL);
  neighbor.velocity.x = std::nan("");
  REQUIRE(avo_planner_plan(planner, &robot, &neighbor, 1, nullptr, 0, nullptr, &plan));
  CHECK(plan.status == AVO_PLAN_INVALID_INPUT);
  neighbor.behavior = 5;
  plan.violation = 7.0;
  REFUSES(avo_planner_plan(planner, &robot, &neighbor, 1, nullptr, 0, nullptr, &plan),
          AVO_ERROR_INVALID_VALUE, "neighbors.0.behavior: found 5, must be 0 to 3");
  neighbor.size = 0;
  REFUSES(avo_planner_plan(planner, &robot, &neighbor, 1, nullptr, 0, nullptr, &plan),
          AVO_ERROR_INVALID_DEFINITION, "neighbors.0.size: found 0");
  robot.size = 0;
  REFUSES(avo_planner_plan(planner, &robot, nullptr, 0, nullptr, 0, nullptr, &plan),
          AVO_ERROR_INVALID_DEFINITION, "robot.size: found 0");
  CHECK(plan.violation == 7.0);
  REQUIRE(avo_destroy_planner(planner));
}

void check_evasion() {
  const avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_planner_id planner;
  REQUIRE(avo_create_planner(&def, &planner));
  avo_robot robot = avo_default_robot();
  robot.velocity = robot.preferred_velocity = {2.0, 0.0};
  avo_neighbor others[2] = {avo_default_neighbor(), avo_default_neighbor()};
  others[0].position = {9.0, 9.0};
  others[1].position = {2.0, 3.0}, others[1].velocity = {0.0, -1.0};
  others[0].behavior = others[1].behavior = AVO_BEHAVIOR_MOVES_ON;
  avo_plan plan;
  REQUIRE(avo_planner_plan(planner, &robot, others, 2, nullptr, 0, nullptr, &plan));
  CHECK(plan.evading);
  avo_evasion evasion;
  REQUIRE(avo_planner_evasion(planner, &robot, others, 2, nullptr, 0, nullptr, &evasion));
  CHECK(evasion.neighbor == 1);
  CHECK(evasion.velocity.x != 0.0 || evasion.velocity.y != 0.0);
  CHECK(evasion.duration > 0.0);
  bool has_evasive_maneuver = false;
  REQUIRE(avo_planner_has_evasive_maneuver(planner, &robot, others, 2, nullptr, 0,
                                           &has_evasive_maneuver));
  CHECK(has_evasive_maneuver);
  others[1].position.x = 0.5, others[1].velocity.y = -30.0;
  REQUIRE(avo_planner_has_evasive_maneuver(planner, &robot, others, 2, nullptr, 0,
                                           &has_evasive_maneuver));
  CHECK(!has_evasive_maneuver);
  REQUIRE(avo_planner_evasion(planner, &robot, others, 1, nullptr, 0, nullptr, &evasion));
  CHECK(evasion.neighbor == -1);
  REFUSES(avo_planner_evasion(planner, &robot, others, 1, nullptr, 0, nullptr, nullptr),
          AVO_ERROR_INVALID_ARGUMENT, "evasion: found null");
  REQUIRE(avo_destroy_planner(planner));
}

void check_trajectories() {
  const avo_timed_place places[] = {{0.0, {0.0, 4.0}}, {1.0, {0.0, 0.0}}, {0.5, {1.0, 0.0}}};
  const double nan = std::nan("");
  avo_trajectory_id trajectory;
  REFUSES(avo_create_trajectory(places, 3, 0.0, nan, &trajectory), AVO_ERROR_INVALID_VALUE,
          "places.2.time: found 0.5, must be > 1 s");
  REFUSES(avo_create_trajectory(places, 0, 0.0, nan, &trajectory), AVO_ERROR_INVALID_VALUE,
          "places: found none, must be one or more");
  REFUSES(avo_create_trajectory(places, 2, 0.0, 0.5, &trajectory), AVO_ERROR_INVALID_VALUE,
          "repeats_from: found 0.5, must be the time of one of the places");
  REQUIRE(avo_create_trajectory(places, 2, 0.0, 0.0, &trajectory));
  CHECK(avo_trajectory_is_valid(trajectory));
  REQUIRE(avo_destroy_trajectory(trajectory));
  CHECK(!avo_trajectory_is_valid(trajectory));

  const avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_planner_id planner;
  REQUIRE(avo_create_planner(&def, &planner));
  const avo_robot robot = avo_default_robot();
  avo_neighbor neighbor = avo_default_neighbor();
  neighbor.behavior = AVO_BEHAVIOR_MOVES_ON;
  neighbor.trajectory = trajectory;
  avo_plan plan;
  REFUSES(avo_planner_plan(planner, &robot, &neighbor, 1, nullptr, 0, nullptr, &plan),
          AVO_ERROR_INVALID_ID, "trajectory: found an id of none that there is");
  REQUIRE(avo_destroy_planner(planner));
}

void check_response_time() {
  avo_planner_def def = avo_default_planner_def(AVO_METHOD_AVO);
  avo_planner_id planner;
  REQUIRE(avo_create_planner(&def, &planner));
  double time = 7.0;
  REQUIRE(avo_planner_response_time(planner, 2.0, 0.5, &time));
  CHECK(std::abs(time - 0.4) < 1e-15);
  REFUSES(avo_planner_response_time(planner, 2.0, 0.5, nullptr), AVO_ERROR_INVALID_ARGUMENT,
          "time: found null");
  REQUIRE(avo_destroy_planner(planner));
  def.response_time = 0.0;
  REQUIRE(avo_create_planner(&def, &planner));
  REQUIRE(avo_planner_response_time(planner, 2.0, 0.5, &time));
  CHECK(time == 0.0);
  REQUIRE(avo_destroy_planner(planner));
}

}  // namespace

int main() {
  check_response_time();
  check_trajectories();
  check_invalid_input();
  check_scene("circle-10", {});
  check_scene("circle-10",
              {"response_time=0.2", "comfort_acceleration=0.6", "comfort_jerk=2", "margin=0.1"});
  check_scene("circle-10", {"method=orca"});
  check_scene("circle-10", {"method=velocity_obstacle"});
  check_scene("circle-10", {"method=orca_clamped"});
  check_scene("circle-10", {"method=reciprocal_velocity_obstacle"});
  check_scene("circle-10", {"method=buffered_voronoi"});
  check_scene("circle-10", {"method=avo_paper"});
  check_scene("mixed-yard", {});
  check_scene("planes-12", {});
  check_trucks();
  check_scene("person", {});
  check_scene("person", {"never_swerves=true"});
  check_scene("mixed-fleet", {});
  check_scene("circle-10", {"robots.3.behavior=cooperates"});
  check_evasion();
  check_scene("reversing-cars", {});
  check_scene("drives-100", {"sensing.dropped=0.3", "sensing.delay=1"});
  check_scene("doorway", {});
  return 0;
}
