// SPDX-License-Identifier: Apache-2.0
// Robots of space: decisions and simulations.
#include "avo_c/space.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "avo/space/simulation.h"
#include "convert.h"
#include "handles.h"
#include "members.h"
#include "scene_files.h"
#include "space_convert.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_space_planner_id, avo::space::Planner> planners("space planner");
AVO_C_CONSTINIT Handles<avo_space_simulation_id, avo::space::Simulation> fleets("space simulation");

// The memory of one thread; it grows, and then nothing is allocated.
struct Scratch {
  avo::space::PlanWorkspace workspace;
  std::vector<avo::space::Neighbor> neighbors;
  std::vector<avo::space::Box> boxes;
};

Scratch& scratch() {
  thread_local Scratch own;
  return own;
}

constexpr auto for_each_of_space_robot_state = [](const auto& visit) {
  using Def = avo_space_robot;
  using avo::space::Robot;
  visit("position", &Def::position, &Robot::position);
  visit("velocity", &Def::velocity, &Robot::velocity);
  visit("preferred_velocity", &Def::preferred_velocity, &Robot::preferred_velocity);
  visit("radius", &Def::radius, &Robot::radius);
  visit("max_acceleration", &Def::max_acceleration, &Robot::max_acceleration);
  visit("max_speed", &Def::max_speed, &Robot::max_speed);
  visit("vertical", &Def::vertical, &Robot::vertical);
  visit("climb", &Def::climb, &Robot::climb);
  visit("sink", &Def::sink, &Robot::sink);
  visit("downwash", &Def::downwash, &Robot::downwash);
  visit("priority", &Def::priority, &Robot::priority);
  visit("max_braking", &Def::max_braking, &Robot::max_braking);
  visit("distance_to_goal", &Def::distance_to_goal, &Robot::distance_to_goal);
};

constexpr auto for_each_of_space_neighbor = [](const auto& visit) {
  using Def = avo_space_neighbor;
  using avo::space::Neighbor;
  visit("position", &Def::position, &Neighbor::position);
  visit("velocity", &Def::velocity, &Neighbor::velocity);
  visit("radius", &Def::radius, &Neighbor::radius);
  visit("max_acceleration", &Def::max_acceleration, &Neighbor::max_acceleration);
  visit("vertical", &Def::vertical, &Neighbor::vertical);
  visit("downwash", &Def::downwash, &Neighbor::downwash);
  visit("priority", &Def::priority, &Neighbor::priority);
  visit("max_braking", &Def::max_braking, &Neighbor::max_braking);
};

avo::space::Robot read_space_robot(const avo_space_robot* robot, const char* name) {
  avo::space::Robot own;
  take_members(read(robot, {name}, avo_default_space_robot()), own, {name},
               for_each_of_space_robot_state);
  return own;
}

const std::vector<avo::space::Neighbor>& read_neighbors(const avo_space_neighbor* neighbors,
                                                        std::size_t count) {
  std::vector<avo::space::Neighbor>& to = scratch().neighbors;
  to.clear();
  for_each(neighbors, count, "neighbors", avo_default_space_neighbor(),
           [&](const avo_space_neighbor& neighbor, const Where& where) {
             take_members(neighbor, to.emplace_back(), where, for_each_of_space_neighbor);
           });
  return to;
}

const std::vector<avo::space::Box>& read_boxes(const avo_space_box* boxes, std::size_t count) {
  require_array(boxes, count, "boxes");
  std::vector<avo::space::Box>& to = scratch().boxes;
  to.clear();
  for (std::size_t k = 0; k < count; ++k) to.push_back(from_c(boxes[k]));
  return to;
}

avo_space_plan plan_to_c(const avo::space::Plan& plan) {
  return {to_c(plan.new_velocity),
          to_c(plan.next_velocity),
          to_c(plan.acceleration),
          static_cast<avo_plan_status>(plan.status),
          static_cast<avo_safety_state>(plan.state),
          plan.neighbor,
          plan.box,
          plan.depth,
          plan.violation};
}

std::size_t checked(const avo::space::Simulation& fleet, std::size_t robot) {
  if (robot >= fleet.size())
    fail(AVO_ERROR_INVALID_ARGUMENT,
         "robot: found " + std::to_string(robot) + ", must be < " + std::to_string(fleet.size()));
  return robot;
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

avo_space_robot avo_default_space_robot(void) {
  avo_space_robot def = {};
  def.size = sizeof def;
  give_members(avo::space::Robot{}, def, for_each_of_space_robot_state);
  return def;
}

avo_space_neighbor avo_default_space_neighbor(void) {
  avo_space_neighbor def = {};
  def.size = sizeof def;
  give_members(avo::space::Neighbor{}, def, for_each_of_space_neighbor);
  return def;
}

avo_result avo_create_space_planner(const avo_planner_def* def, avo_space_planner_id* planner) {
  return guarded([&] {
    avo_space_planner_id& id = at(planner, "planner");
    const avo_planner_def known = read(def, {"def"}, avo_default_planner_def(AVO_METHOD_AVO));
    id = planners.add(std::make_unique<avo::space::Planner>(options_of(known)));
  });
}

avo_result avo_destroy_space_planner(avo_space_planner_id planner) {
  return guarded([&] { planners.take(planner); });
}

bool avo_space_planner_is_valid(avo_space_planner_id planner) {
  return planners.find(planner) != nullptr;
}

avo_result avo_space_planner_plan(avo_space_planner_id planner, const avo_space_robot* robot,
                                  const avo_space_neighbor* neighbors, size_t neighbor_count,
                                  const avo_space_box* boxes, size_t box_count,
                                  avo_space_detour* detour, avo_space_plan* plan) {
  return guarded([&] {
    const avo::space::Planner& own = planners.at(planner);
    avo_space_plan& result = at(plan, "plan");
    avo::space::Detour memory;
    if (detour != nullptr)
      memory = {detour->angle,       detour->beside,     detour->congestion,
                detour->has_arrived, detour->goal_taken, from_c(detour->acceleration)};
    result = plan_to_c(own.plan(
        read_space_robot(robot, "robot"), read_neighbors(neighbors, neighbor_count),
        scratch().workspace, detour == nullptr ? nullptr : &memory, read_boxes(boxes, box_count)));
    if (detour != nullptr)
      *detour = {memory.angle,       memory.beside,     memory.congestion,
                 memory.has_arrived, memory.goal_taken, to_c(memory.acceleration)};
  });
}

avo_result avo_space_planner_get_box_range(avo_space_planner_id planner,
                                           const avo_space_robot* robot, double* range) {
  return guarded([&] {
    at(range, "range") =
        avo::space::box_range(read_space_robot(robot, "robot"), planners.at(planner).options());
  });
}

avo_result avo_space_planner_get_sensing_range(avo_space_planner_id planner,
                                               const avo_space_robot* robot,
                                               const avo_space_robot* other, double* range) {
  return guarded([&] {
    at(range, "range") =
        avo::space::sensing_range(read_space_robot(robot, "robot"),
                                  read_space_robot(other, "other"), planners.at(planner).options());
  });
}

avo_result avo_create_space_simulation(const avo_space_simulation_def* def,
                                       avo_space_simulation_id* simulation) {
  return guarded([&] {
    avo_space_simulation_id& id = at(simulation, "simulation");
    const avo_space_simulation_def known = read(def, {"def"}, avo_default_space_simulation_def());
    id = fleets.add(std::make_unique<avo::space::Simulation>(scenario_of(known),
                                                             checked_threads(known.threads)));
  });
}

avo_result avo_load_space_simulation(const char* path, const char* const* overrides,
                                     size_t override_count, int32_t threads,
                                     avo_space_simulation_id* simulation) {
  return guarded([&] {
    avo_space_simulation_id& id = at(simulation, "simulation");
    const std::vector<std::string> words = words_of(overrides, override_count);
    id = fleets.add(std::make_unique<avo::space::Simulation>(
        load_space_scene(&at(path, "path"), words), checked_threads(threads)));
  });
}

avo_result avo_destroy_space_simulation(avo_space_simulation_id simulation) {
  return guarded([&] { fleets.take(simulation); });
}

bool avo_space_simulation_is_valid(avo_space_simulation_id simulation) {
  return fleets.find(simulation) != nullptr;
}

avo_result avo_space_simulation_step(avo_space_simulation_id simulation) {
  return guarded([&] { fleets.at(simulation).step(); });
}

avo_result avo_space_simulation_get_time(avo_space_simulation_id simulation, double* time) {
  return guarded([&] { at(time, "time") = fleets.at(simulation).time(); });
}

avo_result avo_space_simulation_get_robot_count(avo_space_simulation_id simulation, size_t* count) {
  return guarded([&] { at(count, "count") = fleets.at(simulation).size(); });
}

avo_result avo_space_simulation_get_states(avo_space_simulation_id simulation, avo_vec3* positions,
                                           avo_vec3* velocities, size_t capacity) {
  return guarded([&] {
    const std::span<const avo::space::Robot> robots = fleets.at(simulation).robots();
    require_room(capacity, robots.size());
    for (std::size_t k = 0; k < robots.size(); ++k) {
      if (positions != nullptr) positions[k] = to_c(robots[k].position);
      if (velocities != nullptr) velocities[k] = to_c(robots[k].velocity);
    }
  });
}

avo_result avo_space_simulation_get_plan(avo_space_simulation_id simulation, size_t robot,
                                         avo_space_plan* plan) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    at(plan, "plan") = plan_to_c(fleet.plans()[checked(fleet, robot)]);
  });
}

avo_result avo_space_simulation_is_at_goal(avo_space_simulation_id simulation, size_t robot,
                                           bool* is_at_goal) {
  return guarded([&] {
    const avo::space::Simulation& fleet = fleets.at(simulation);
    at(is_at_goal, "is_at_goal") = fleet.is_at_goal({checked(fleet, robot)});
  });
}

avo_result avo_space_simulation_set_goal(avo_space_simulation_id simulation, size_t robot,
                                         avo_vec3 goal) {
  return guarded([&] {
    avo::space::Simulation& fleet = fleets.at(simulation);
    fleet.set_goal({checked(fleet, robot)}, from_c(goal));
  });
}

avo_result avo_space_simulation_set_boxes(avo_space_simulation_id simulation,
                                          const avo_space_box* boxes, size_t box_count) {
  return guarded([&] { fleets.at(simulation).set_boxes(read_boxes(boxes, box_count)); });
}

avo_result avo_space_simulation_get_state_hash(avo_space_simulation_id simulation, uint64_t* hash) {
  return guarded([&] { at(hash, "hash") = fleets.at(simulation).state_hash(); });
}
