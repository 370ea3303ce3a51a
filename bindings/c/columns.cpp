// SPDX-License-Identifier: Apache-2.0
// The values of a simulation: lent columns, and values of one robot.
#include <algorithm>
#include <cstring>

#include "layouts.h"
#include "simulations.h"

namespace avo_c {

avo::RobotId present(const avo::Simulation& simulation, avo_robot_id robot) {
  if (robot.value != 0 && simulation.index_of(from_c(robot))) return from_c(robot);
  fail_absent(robot);
}

namespace {

template <typename C, typename Cpp>
const C* lent(std::span<const Cpp> column) {
  static_assert(kSameSize<C, Cpp>);
  return reinterpret_cast<const C*>(column.data());
}

const avo_robot_id* ids_of(Simulation& simulation, const avo::FleetView& fleet) {
  if (!simulation.has_ids.load(std::memory_order_acquire)) {
    const std::lock_guard lock(simulation.looking);
    if (!simulation.has_ids.load(std::memory_order_relaxed)) {
      simulation.ids.resize(fleet.id.size());
      std::transform(fleet.id.begin(), fleet.id.end(), simulation.ids.begin(),
                     [](avo::RobotId id) { return to_c(id); });
      simulation.has_ids.store(true, std::memory_order_release);
    }
  }
  return simulation.ids.data();
}

// value = of(simulation, robot) for a robot that is present.
template <typename Value, typename Of>
avo_result get_by_id(avo_simulation_id id, avo_robot_id robot, Value* value, const Of& of) {
  return guarded([&] {
    const Simulation& own = simulations.at(id);
    Value& result = at(value, "result");
    result = of(own.simulation, present(own.simulation, robot));
  });
}

// value = of(state) for a robot.
template <typename Value, typename Of>
avo_result get(avo_simulation_id id, avo_robot_id robot, Value* value, const Of& of) {
  return get_by_id(id, robot, value, [&](const avo::Simulation& own, avo::RobotId present) {
    return of(own.robot(present));
  });
}

// velocity = of(simulation, robot), if there is one.
template <typename Of>
avo_result get_velocity(avo_simulation_id id, avo_robot_id robot, avo_vec2* velocity, bool* is_set,
                        const Of& of) {
  return get_by_id(id, robot, is_set, [&](const avo::Simulation& own, avo::RobotId present) {
    avo_vec2& result = at(velocity, "velocity");
    const std::optional<avo::Vec2> given = of(own, present);
    if (given) result = to_c(*given);
    return given.has_value();
  });
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_columns(avo_simulation_id simulation, avo_columns* columns) {
  return guarded([&] {
    Simulation& own = simulations.at(simulation);
    avo_columns& result = at(columns, "columns");
    using avo::Columns;
    const avo::FleetView fleet = own.simulation.fleet(
        Columns::id | Columns::position | Columns::velocity | Columns::heading | Columns::goal |
        Columns::plan | Columns::detour | Columns::applied_acceleration);
    result = {fleet.id.size(),
              ids_of(own, fleet),
              lent<avo_vec2>(fleet.position),
              lent<avo_vec2>(fleet.velocity),
              fleet.heading.data(),
              lent<avo_vec2>(fleet.goal),
              lent<avo_plan>(fleet.plan),
              lent<avo_detour>(fleet.detour),
              fleet.applied_acceleration.data()};
  });
}

avo_result avo_simulation_moving_obstacles(avo_simulation_id simulation,
                                           avo_moving_obstacle_columns* columns) {
  return guarded([&] {
    const avo::MovingObstacleView obstacles =
        simulations.at(simulation).simulation.moving_obstacles();
    at(columns, "columns") = {obstacles.position.size(), lent<avo_vec2>(obstacles.position),
                              lent<avo_vec2>(obstacles.velocity), obstacles.next_point.data()};
  });
}

avo_result avo_simulation_get_position(avo_simulation_id simulation, avo_robot_id robot,
                                       avo_vec2* position) {
  return get(simulation, robot, position,
             [](const avo::RobotState& state) { return to_c(state.position); });
}

avo_result avo_simulation_get_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                       avo_vec2* velocity) {
  return get(simulation, robot, velocity,
             [](const avo::RobotState& state) { return to_c(state.velocity); });
}

avo_result avo_simulation_get_heading(avo_simulation_id simulation, avo_robot_id robot,
                                      double* heading) {
  return get(simulation, robot, heading,
             [](const avo::RobotState& state) { return state.heading; });
}

avo_result avo_simulation_get_goal(avo_simulation_id simulation, avo_robot_id robot,
                                   avo_vec2* goal) {
  return get(simulation, robot, goal,
             [](const avo::RobotState& state) { return to_c(state.goal); });
}

avo_result avo_simulation_get_plan(avo_simulation_id simulation, avo_robot_id robot,
                                   avo_plan* plan) {
  return get(simulation, robot, plan,
             [](const avo::RobotState& state) { return std::bit_cast<avo_plan>(state.plan); });
}

avo_result avo_simulation_get_applied_acceleration(avo_simulation_id simulation, avo_robot_id robot,
                                                   double* acceleration) {
  return get(simulation, robot, acceleration,
             [](const avo::RobotState& state) { return state.applied_acceleration; });
}

avo_result avo_simulation_is_at_goal(avo_simulation_id simulation, avo_robot_id robot,
                                     bool* is_at_goal) {
  return get_by_id(simulation, robot, is_at_goal,
                   [](const avo::Simulation& own, avo::RobotId id) { return own.is_at_goal(id); });
}

avo_result avo_simulation_get_next_decision(avo_simulation_id simulation, avo_robot_id robot,
                                            double* time) {
  return get_by_id(simulation, robot, time, [](const avo::Simulation& own, avo::RobotId id) {
    return own.next_decision(id);
  });
}

avo_result avo_simulation_get_preferred_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                                 avo_vec2* velocity, bool* is_set) {
  return get_velocity(
      simulation, robot, velocity, is_set,
      [](const avo::Simulation& own, avo::RobotId id) { return own.preferred_velocity(id); });
}

avo_result avo_simulation_get_host_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                            avo_vec2* velocity, bool* is_set) {
  return get_velocity(
      simulation, robot, velocity, is_set,
      [](const avo::Simulation& own, avo::RobotId id) { return own.host_velocity(id); });
}

avo_result avo_simulation_is_moved(avo_simulation_id simulation, avo_robot_id robot,
                                   bool* is_moved) {
  return get_by_id(simulation, robot, is_moved,
                   [](const avo::Simulation& own, avo::RobotId id) { return own.is_moved(id); });
}

avo_result avo_simulation_decided(avo_simulation_id simulation, avo_robot_id robot, bool* decided) {
  return get_by_id(simulation, robot, decided,
                   [](const avo::Simulation& own, avo::RobotId id) { return own.decided(id); });
}

avo_result avo_simulation_get_distance_left(avo_simulation_id simulation, avo_robot_id robot,
                                            double* distance) {
  return get_by_id(simulation, robot, distance, [](const avo::Simulation& own, avo::RobotId id) {
    return own.route(id).distance_left;
  });
}

avo_result avo_simulation_get_route(avo_simulation_id simulation, avo_robot_id robot,
                                    avo_route* route) {
  return get_by_id(simulation, robot, route, [](const avo::Simulation& own, avo::RobotId id) {
    const avo::Simulation::Route found = own.route(id);
    return avo_route{found.length, to_c(found.next), found.distance_left};
  });
}

avo_result avo_simulation_get_wait(avo_simulation_id simulation, avo_robot_id robot,
                                   avo_wait* wait) {
  return get_by_id(simulation, robot, wait, [](const avo::Simulation& own, avo::RobotId id) {
    const std::optional<avo::Simulation::Wait> found = own.wait(id);
    if (!found) return avo_wait{};
    return avo_wait{true,          to_c(found->passage), to_c(found->robot),
                    found->inside, to_c(found->a),       to_c(found->b)};
  });
}

avo_result avo_simulation_index_of(avo_simulation_id simulation, avo_robot_id robot,
                                   size_t* index) {
  return get_by_id(simulation, robot, index,
                   [](const avo::Simulation& own, avo::RobotId id) { return *own.index_of(id); });
}

avo_result avo_simulation_get_robot_def(avo_simulation_id simulation, avo_robot_id robot,
                                        avo_robot_def* def) {
  return guarded([&] {
    const Simulation& own = simulations.at(simulation);
    write(def, def_of(own.simulation.setup(present(own.simulation, robot))), {"def"});
  });
}

avo_result avo_simulation_get_time(avo_simulation_id simulation, double* time) {
  return get(simulation, time, [](const avo::Simulation& own) { return own.time(); });
}

avo_result avo_simulation_get_steps(avo_simulation_id simulation, int64_t* steps) {
  return get(simulation, steps, [](const avo::Simulation& own) { return own.steps(); });
}

avo_result avo_simulation_get_sensing_radius(avo_simulation_id simulation, double* radius) {
  return get(simulation, radius, [](const avo::Simulation& own) { return own.sensing_radius(); });
}

avo_result avo_simulation_get_robot_count(avo_simulation_id simulation, size_t* count) {
  return get(simulation, count, [](const avo::Simulation& own) { return own.size(); });
}

avo_result avo_simulation_get_roster(avo_simulation_id simulation, uint64_t* roster) {
  return get(simulation, roster, [](const avo::Simulation& own) { return own.roster(); });
}

avo_result avo_simulation_get_threads(avo_simulation_id simulation, int32_t* threads) {
  return get(simulation, threads, [](const avo::Simulation& own) { return own.threads(); });
}

avo_result avo_simulation_can_step_by(avo_simulation_id simulation, double time, bool* can_step) {
  return get(simulation, can_step,
             [&](const avo::Simulation& own) { return own.can_step_by(time); });
}

avo_result avo_simulation_all_at_goal(avo_simulation_id simulation, bool* all_at_goal) {
  return get(simulation, all_at_goal, [](const avo::Simulation& own) { return own.all_at_goal(); });
}

avo_result avo_simulation_get_state_hash(avo_simulation_id simulation, uint64_t* hash) {
  return get(simulation, hash, [](const avo::Simulation& own) { return own.state_hash(); });
}

avo_result avo_simulation_unreachable(avo_simulation_id simulation, avo_robot_id* buffer,
                                      size_t capacity, size_t* count) {
  return guarded(
      [&] { list(simulations.at(simulation).simulation.unreachable(), buffer, capacity, count); });
}
