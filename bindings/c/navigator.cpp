// SPDX-License-Identifier: Apache-2.0
// Robots on board.
#include "avo/navigator.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convert.h"
#include "handles.h"
#include "layouts.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_navigator_id, avo::Navigator> navigators("navigator");

static_assert(is(AVO_NAVIGATOR_UNREACHABLE, avo::NavigatorStatus::unreachable));
static_assert(is(AVO_NAVIGATOR_WAITING, avo::NavigatorStatus::waiting));
static_assert(is(AVO_GUIDE_HOST, avo::Guide::host));
static_assert(is(AVO_GUIDE_PASSAGE, avo::Guide::passage));

std::optional<double> unless_nan(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

avo::PlannerOptions planner_options_of(const avo_planner_def* planner) {
  return options_of(read(planner, {"planner"}, avo_default_planner_def(AVO_METHOD_AVO)));
}

avo::NavigatorOptions navigator_options_of(const avo_planner_def* planner,
                                           const avo_navigator_def* given) {
  const avo_navigator_def def = read(given, {"def"}, avo_default_navigator_def());
  require_array(def.fleet_radii, def.fleet_radius_count, "fleet_radii");
  avo::NavigatorOptions options;
  options.planner = planner_options_of(planner);
  if (def.preferred_speed != static_cast<double>(AVO_UNSET))
    options.preferred_speed = def.preferred_speed;
  options.id = {def.id};
  options.navigation = def.navigation;
  options.layers = {def.layers};
  options.right_of_way = word<avo::RightOfWay>(def.right_of_way, 2, {}, "right_of_way");
  options.fleet_radii.assign(def.fleet_radii, def.fleet_radii + def.fleet_radius_count);
  options.xy_goal_tolerance = unless_zero(def.xy_goal_tolerance);
  options.yaw_goal_tolerance = def.yaw_goal_tolerance;
  options.required_movement_radius = def.required_movement_radius;
  options.movement_time_allowance = def.movement_time_allowance;
  options.route_tolerance = unless_zero(def.route_tolerance);
  if (def.execution != nullptr) options.execution = execution_of(*def.execution);
  return options;
}

avo_navigator_decision decision_of(const avo::NavigatorDecision& decision) {
  avo_navigator_decision result = {};
  result.plan = std::bit_cast<avo_plan>(decision.plan);
  result.preferred_velocity = to_c(decision.preferred_velocity);
  result.route_left = decision.route_left, result.distance_left = decision.distance_left;
  result.stopping_distance = decision.stopping_distance;
  result.without_progress = decision.without_progress;
  result.waits_for = decision.wait ? decision.wait->neighbor : -1;
  if (decision.wait) {
    result.passage = to_c(decision.wait->passage), result.inside = decision.wait->inside;
    result.a = to_c(decision.wait->a), result.b = to_c(decision.wait->b);
  }
  result.status = static_cast<avo_navigator_status>(decision.status);
  result.guide = static_cast<avo_guide>(decision.guide);
  result.has_command = decision.command.has_value();
  if (decision.command) result.command = std::bit_cast<avo_base_command>(*decision.command);
  return result;
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_navigator_def avo_default_navigator_def(void) {
  const avo::NavigatorOptions options;
  avo_navigator_def def = {};
  def.size = sizeof def;
  def.preferred_speed = AVO_UNSET;
  def.yaw_goal_tolerance = options.yaw_goal_tolerance;
  def.required_movement_radius = options.required_movement_radius;
  def.movement_time_allowance = options.movement_time_allowance;
  def.right_of_way = static_cast<avo_right_of_way>(options.right_of_way);
  def.navigation = options.navigation;
  def.layers = options.layers.bits;
  return def;
}

avo_result avo_create_navigator(const avo_planner_def* planner, const avo_navigator_def* def,
                                const avo_obstacle_def* obstacles, size_t obstacle_count,
                                avo_navigator_id* navigator) {
  return guarded([&] {
    avo_navigator_id& id = at(navigator, "navigator");
    id = navigators.add(std::make_unique<avo::Navigator>(navigator_options_of(planner, def),
                                                         obstacles_of(obstacles, obstacle_count)));
  });
}

avo_result avo_destroy_navigator(avo_navigator_id navigator) {
  return guarded([&] { navigators.take(navigator); });
}

bool avo_navigator_is_valid(avo_navigator_id navigator) {
  return navigators.find(navigator) != nullptr;
}

avo_result avo_navigator_set_goal(avo_navigator_id navigator, avo_vec2 goal, double heading,
                                  bool is_shared) {
  return guarded(
      [&] { navigators.at(navigator).set_goal(from_c(goal), unless_nan(heading), is_shared); });
}

avo_result avo_navigator_set_route(avo_navigator_id navigator, const avo_vec2* points, size_t count,
                                   double heading) {
  return guarded([&] {
    navigators.at(navigator).set_route(points_of(points, count, "points"), unless_nan(heading));
  });
}

avo_result avo_navigator_set_stages(avo_navigator_id navigator, const avo_stage* stages,
                                    size_t count, double heading) {
  return guarded([&] {
    avo::Navigator& own = navigators.at(navigator);
    require_array(stages, count, "stages");
    std::vector<avo::Stage> all;
    for (std::size_t k = 0; k < count; ++k)
      all.push_back({from_c(stages[k].position), stages[k].wait});
    own.set_stages(std::move(all), unless_nan(heading));
  });
}

avo_result avo_navigator_go_on(avo_navigator_id navigator) {
  return guarded([&] { navigators.at(navigator).go_on(); });
}

avo_result avo_navigator_clear_goal(avo_navigator_id navigator) {
  return guarded([&] { navigators.at(navigator).clear_goal(); });
}

avo_result avo_navigator_set_obstacles(avo_navigator_id navigator,
                                       const avo_obstacle_def* obstacles, size_t obstacle_count,
                                       uint32_t layers) {
  return guarded([&] {
    const auto changed = layers != 0 ? std::optional(avo::LayerSet{layers}) : std::nullopt;
    navigators.at(navigator).set_obstacles(obstacles_of(obstacles, obstacle_count), changed);
  });
}

avo_result avo_navigator_step(avo_navigator_id navigator, const avo_robot* robot,
                              const avo_neighbor* neighbors, size_t neighbor_count, double time,
                              avo_navigator_decision* decision) {
  return guarded([&] {
    avo::Navigator& own = navigators.at(navigator);
    avo_navigator_decision& result = at(decision, "decision");
    result = decision_of(
        own.step(read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"), time));
  });
}

avo_result avo_navigator_explain(avo_navigator_id navigator, const avo_robot* robot,
                                 const avo_neighbor* neighbors, size_t neighbor_count, char* buffer,
                                 size_t capacity, size_t* size) {
  return guarded([&] {
    std::size_t& written = at(size, "size");
    const std::string words =
        navigators.at(navigator)
            .explain(read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"))
            .sentence;
    write_bytes(words.c_str(), words.size() + 1, buffer, capacity, written);
  });
}

avo_result avo_navigator_route(avo_navigator_id navigator, avo_vec2* buffer, size_t capacity,
                               size_t* count) {
  return guarded([&] {
    std::size_t& written = at(count, "count");
    const std::vector<avo::Vec2> route = navigators.at(navigator).route();
    written = route.size();
    if (buffer == nullptr) return;
    require_room(capacity, written);
    for (const avo::Vec2 corner : route) *buffer++ = to_c(corner);
  });
}

avo_result avo_navigator_get_detour(avo_navigator_id navigator, avo_detour* detour) {
  return guarded([&] {
    const avo::Navigator& own = navigators.at(navigator);
    at(detour, "detour") = std::bit_cast<avo_detour>(own.detour());
  });
}

avo_result avo_sensing_range(const avo_planner_def* planner, const avo_robot* robot,
                             const avo_robot* others, size_t other_count, bool has_map,
                             double* range) {
  return guarded([&] {
    double& result = at(range, "range");
    std::vector<avo::Robot> all;
    for_each(others, other_count, "others", avo_default_robot(),
             [&](const avo_robot& other, const Where&) { all.push_back(robot_of(other)); });
    result = avo::sensing_range(planner_options_of(planner), read_robot(robot), all, has_map);
  });
}

avo_result avo_wall_range(const avo_planner_def* planner, const avo_robot* robot, double* range) {
  return guarded([&] {
    at(range, "range") = avo::wall_range(planner_options_of(planner), read_robot(robot));
  });
}
