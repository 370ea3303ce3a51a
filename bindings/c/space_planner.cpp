// SPDX-License-Identifier: Apache-2.0
// Robots of space: decisions of one robot.
#include <memory>
#include <vector>

#include "avo/space/planner.h"
#include "avo_c/space.h"
#include "convert.h"
#include "handles.h"
#include "members.h"
#include "space_convert.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_space_planner_id, avo::space::Planner> planners("space planner");

// The memory of one thread; it grows, and then nothing is allocated.
struct Scratch {
  avo::space::PlanWorkspace workspace;
  std::vector<avo::space::Neighbor> neighbors;
  std::vector<avo::space::Box> boxes;
  std::vector<avo::space::Mover> movers;
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
  visit("age", &Def::age, &Neighbor::age);
};

constexpr auto for_each_of_space_mover = [](const auto& visit) {
  using Def = avo_space_mover;
  using avo::space::Mover;
  visit("position", &Def::position, &Mover::position);
  visit("velocity", &Def::velocity, &Mover::velocity);
  visit("acceleration", &Def::acceleration, &Mover::acceleration);
  visit("radius", &Def::radius, &Mover::radius);
  visit("max_deviation", &Def::max_deviation, &Mover::max_deviation);
  visit("max_speed", &Def::max_speed, &Mover::max_speed);
  visit("age", &Def::age, &Mover::age);
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

const std::vector<avo::space::Mover>& read_movers(const avo_space_mover* movers,
                                                  std::size_t count) {
  std::vector<avo::space::Mover>& to = scratch().movers;
  to.clear();
  for_each(movers, count, "movers", avo_default_space_mover(),
           [&](const avo_space_mover& mover, const Where& where) {
             take_members(mover, to.emplace_back(), where, for_each_of_space_mover);
           });
  return to;
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

avo_space_mover avo_default_space_mover(void) {
  avo_space_mover def = {};
  def.size = sizeof def;
  give_members(avo::space::Mover{}, def, for_each_of_space_mover);
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
                                  const avo_space_mover* movers, size_t mover_count,
                                  avo_space_detour* detour, avo_space_plan* plan) {
  return guarded([&] {
    const avo::space::Planner& own = planners.at(planner);
    avo_space_plan& result = at(plan, "plan");
    avo::space::Detour memory;
    if (detour != nullptr)
      memory = {detour->angle,       detour->beside,     detour->congestion,
                detour->has_arrived, detour->goal_taken, from_c(detour->acceleration)};
    Scratch& here = scratch();
    read_boxes(boxes, box_count, here.boxes);
    result = to_c(own.plan(
        read_space_robot(robot, "robot"), read_neighbors(neighbors, neighbor_count), here.workspace,
        detour == nullptr ? nullptr : &memory, here.boxes, read_movers(movers, mover_count)));
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

avo_result avo_space_planner_get_mover_range(avo_space_planner_id planner,
                                             const avo_space_robot* robot,
                                             const avo_space_mover* mover, double* range) {
  return guarded([&] {
    avo::space::Mover other;
    take_members(read(mover, {"mover"}, avo_default_space_mover()), other, {"mover"},
                 for_each_of_space_mover);
    at(range, "range") = avo::space::sensing_range(read_space_robot(robot, "robot"), other,
                                                   planners.at(planner).options());
  });
}

avo_result avo_space_evasion_range(const avo_space_robot* robot, double* range) {
  return guarded(
      [&] { at(range, "range") = avo::space::evasion_range(read_space_robot(robot, "robot")); });
}
