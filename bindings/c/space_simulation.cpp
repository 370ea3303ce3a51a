// SPDX-License-Identifier: Apache-2.0
// Simulations of space.
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "convert.h"
#include "definitions.h"
#include "ids.h"
#include "scene_files.h"
#include "space_convert.h"
#include "space_simulations.h"

namespace avo_c {
namespace {

avo::space::MovingObstacle read_obstacle(const avo_space_moving_obstacle_def* def) {
  const Where where{"moving_obstacle"};
  return obstacle_of(read(def, {"def"}, avo_default_space_moving_obstacle_def()), where);
}

// Writes the states of robots or moving obstacles into those of the two arrays that are there.
template <typename Body>
void write_states(std::span<const Body> bodies, avo_vec3* positions, avo_vec3* velocities,
                  std::size_t capacity) {
  require_room(capacity, bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (positions != nullptr) positions[k] = to_c(bodies[k].position);
    if (velocities != nullptr) velocities[k] = to_c(bodies[k].velocity);
  }
}

int checked_threads(std::int32_t threads) {
  if (threads < 0 || threads > 1024)
    fail(AVO_ERROR_INVALID_VALUE,
         "threads: found " + std::to_string(threads) + ", must be 0 to 1024");
  return threads;
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_create_space_simulation(const avo_space_simulation_def* def,
                                       avo_space_simulation_id* simulation) {
  return guarded([&] {
    avo_space_simulation_id& id = at(simulation, "simulation");
    const avo_space_simulation_def known = read(def, {"def"}, avo_default_space_simulation_def());
    id = fleets.add(
        std::make_unique<SpaceSimulation>(scenario_of(known), checked_threads(known.threads)));
  });
}

avo_result avo_load_space_simulation(const char* path, const char* const* overrides,
                                     size_t override_count, int32_t threads,
                                     avo_space_simulation_id* simulation) {
  return guarded([&] {
    avo_space_simulation_id& id = at(simulation, "simulation");
    const std::vector<std::string> words = words_of(overrides, override_count);
    id = fleets.add(std::make_unique<SpaceSimulation>(load_space_scene(&at(path, "path"), words),
                                                      checked_threads(threads)));
  });
}

avo_result avo_destroy_space_simulation(avo_space_simulation_id simulation) {
  return guarded([&] { fleets.take(simulation); });
}

bool avo_space_simulation_is_valid(avo_space_simulation_id simulation) {
  return fleets.find(simulation) != nullptr;
}

avo_result avo_space_simulation_step(avo_space_simulation_id simulation) {
  return guarded([&] {
    SpaceSimulation& own = fleets.at(simulation);
    own.step();
    require_events(own.watch.observe(own));
  });
}

avo_result avo_space_simulation_get_time(avo_space_simulation_id simulation, double* time) {
  return guarded([&] { at(time, "time") = fleets.at(simulation).time(); });
}

avo_result avo_space_simulation_get_steps(avo_space_simulation_id simulation, int64_t* steps) {
  return guarded([&] { at(steps, "steps") = fleets.at(simulation).steps(); });
}

avo_result avo_space_simulation_can_step_by(avo_space_simulation_id simulation, double time,
                                            bool* can_step) {
  return guarded([&] { at(can_step, "can_step") = fleets.at(simulation).can_step_by(time); });
}

avo_result avo_space_simulation_get_robot_count(avo_space_simulation_id simulation, size_t* count) {
  return guarded([&] { at(count, "count") = fleets.at(simulation).size(); });
}

avo_result avo_space_simulation_get_states(avo_space_simulation_id simulation, avo_vec3* positions,
                                           avo_vec3* velocities, size_t capacity) {
  return guarded(
      [&] { write_states(fleets.at(simulation).robots(), positions, velocities, capacity); });
}

avo_result avo_space_simulation_get_plan(avo_space_simulation_id simulation, avo_robot_id robot,
                                         avo_space_plan* plan) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    at(plan, "plan") = to_c(fleet.plans()[present(fleet, robot).value]);
  });
}

avo_result avo_space_simulation_get_touched(avo_space_simulation_id simulation, avo_robot_id robot,
                                            avo_space_touched* touched) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    const auto number = [](const auto& id) { return id ? id->value + 1 : 0; };
    const avo::space::Simulation::Touched none;
    const auto found = fleet.touched(present(fleet, robot)).value_or(none);
    at(touched, "touched") = {
        {number(found.robot)}, {number(found.moving_obstacle)}, {number(found.obstacle)}};
  });
}

avo_result avo_space_simulation_is_at_goal(avo_space_simulation_id simulation, avo_robot_id robot,
                                           bool* is_at_goal) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    at(is_at_goal, "is_at_goal") = fleet.is_at_goal(present(fleet, robot));
  });
}

avo_result avo_space_simulation_all_at_goal(avo_space_simulation_id simulation, bool* all_at_goal) {
  return guarded([&] { at(all_at_goal, "all_at_goal") = fleets.at(simulation).all_at_goal(); });
}

avo_result avo_space_simulation_get_distance_left(avo_space_simulation_id simulation,
                                                  avo_robot_id robot, double* distance) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    at(distance, "distance") = fleet.route(present(fleet, robot)).distance_left;
  });
}

avo_result avo_space_simulation_get_route(avo_space_simulation_id simulation, avo_robot_id robot,
                                          avo_space_route* route) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    const auto [length, next, distance_left] = fleet.route(present(fleet, robot));
    at(route, "route") = {length, to_c(next), distance_left};
  });
}

avo_result avo_space_simulation_unreachable(avo_space_simulation_id simulation,
                                            avo_robot_id* buffer, size_t capacity, size_t* count) {
  return guarded([&] { list(fleets.at(simulation).unreachable(), buffer, capacity, count); });
}

avo_result avo_space_simulation_set_goal(avo_space_simulation_id simulation, avo_robot_id robot,
                                         avo_vec3 goal) {
  return guarded([&] {
    avo::space::Simulation& fleet = fleets.at(simulation);
    fleet.set_goal(present(fleet, robot), from_c(goal));
  });
}

avo_result avo_space_simulation_set_boxes(avo_space_simulation_id simulation,
                                          const avo_space_box* boxes, size_t box_count) {
  return guarded([&] {
    std::vector<avo::space::Box> given;
    read_boxes(boxes, box_count, given);
    fleets.at(simulation).set_boxes(given);
  });
}

avo_result avo_space_simulation_add_moving_obstacle(avo_space_simulation_id simulation,
                                                    const avo_space_moving_obstacle_def* def,
                                                    avo_moving_obstacle_id* obstacle) {
  return guarded([&] {
    avo::space::Simulation& fleet = fleets.at(simulation);
    avo_moving_obstacle_id& id = at(obstacle, "obstacle");
    id = {fleet.add_moving_obstacle(read_obstacle(def)).value + 1};
  });
}

avo_result avo_space_simulation_change_moving_obstacle(avo_space_simulation_id simulation,
                                                       avo_moving_obstacle_id obstacle,
                                                       const avo_space_moving_obstacle_def* def) {
  return guarded([&] {
    avo::space::Simulation& fleet = fleets.at(simulation);
    fleet.change_moving_obstacle(among(fleet.moving_obstacle_ids(), obstacle.value),
                                 read_obstacle(def));
  });
}

avo_result avo_space_simulation_remove_moving_obstacle(avo_space_simulation_id simulation,
                                                       avo_moving_obstacle_id obstacle) {
  return guarded([&] {
    avo::space::Simulation& fleet = fleets.at(simulation);
    fleet.remove_moving_obstacle(among(fleet.moving_obstacle_ids(), obstacle.value));
  });
}

avo_result avo_space_simulation_moving_obstacle_ids(avo_space_simulation_id simulation,
                                                    avo_moving_obstacle_id* buffer, size_t capacity,
                                                    size_t* count) {
  return guarded(
      [&] { list(fleets.at(simulation).moving_obstacle_ids(), buffer, capacity, count); });
}

avo_result avo_space_simulation_get_moving_obstacles(avo_space_simulation_id simulation,
                                                     avo_vec3* positions, avo_vec3* velocities,
                                                     size_t capacity) {
  return guarded(
      [&] { write_states(fleets.at(simulation).movers(), positions, velocities, capacity); });
}

avo_result avo_space_simulation_get_state_hash(avo_space_simulation_id simulation, uint64_t* hash) {
  return guarded([&] { at(hash, "hash") = fleets.at(simulation).state_hash(); });
}
