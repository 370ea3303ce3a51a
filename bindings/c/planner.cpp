// SPDX-License-Identifier: Apache-2.0
// One robot's decisions.
#include "avo/planner.h"

#include <memory>
#include <span>
#include <vector>

#include "convert.h"
#include "layouts.h"
#include "members.h"
#include "planners.h"

namespace avo_c {
namespace {

// The memory of one thread; it grows, and then nothing is allocated.
struct Scratch {
  avo::PlanWorkspace workspace;
  std::vector<avo::Neighbor> neighbors;
};

Scratch& scratch() {
  thread_local Scratch own;
  return own;
}

}  // namespace

std::span<const avo::Neighbor> neighbors_of(const avo_neighbor* neighbors, std::size_t count,
                                            const char* list) {
  std::vector<avo::Neighbor>& to = scratch().neighbors;
  to.clear();
  for_each(neighbors, count, list, avo_default_neighbor(),
           [&](const avo_neighbor& neighbor, const Where& where) {
             to.push_back(neighbor_of(neighbor, where));
           });
  return to;
}

avo::Robot read_robot(const avo_robot* robot) {
  return robot_of(read(robot, {"robot"}, avo_default_robot()));
}

namespace {

std::span<const avo::Wall> walls_of(const avo_wall* walls, std::size_t count) {
  require_array(walls, count, "walls");
  return {reinterpret_cast<const avo::Wall*>(walls), count};
}

}  // namespace

namespace {

// The members of a definition and of a planner's options, except for the noise.
constexpr auto for_each_option = [](const auto& visit) {
  using Def = avo_planner_def;
  using Options = avo::PlannerOptions;
  visit("method", &Def::method, &Options::method);
  visit("motion", &Def::motion, &Options::motion);
  visit("control_time", &Def::control_time, &Options::control_time);
  visit("time_horizon", &Def::time_horizon, &Options::time_horizon);
  visit("time_step", &Def::time_step, &Options::time_step);
  visit("certificate", &Def::certificate, &Options::certificate);
  visit("max_neighbors", &Def::max_neighbors, &Options::max_neighbors);
  visit("sensing_error", &Def::sensing_error, &Options::sensing_error);
  visit("clock", &Def::clock, &Options::clock);
  visit("longest_step", &Def::longest_step, &Options::longest_step);
  visit("arrival_distance", &Def::arrival_distance, &Options::arrival_distance);
  visit("localization_error", &Def::localization_error, &Options::localization_error);
  visit("response_time", &Def::response_time, &Options::response_time);
  visit("comfort_acceleration", &Def::comfort_acceleration, &Options::comfort_acceleration);
  visit("comfort_jerk", &Def::comfort_jerk, &Options::comfort_jerk);
  visit("margin", &Def::margin, &Options::margin);
  visit("wall_range", &Def::wall_range, &Options::wall_range);
  visit("never_swerves", &Def::never_swerves, &Options::never_swerves);
};

}  // namespace

avo::PlannerOptions options_of(const avo_planner_def& def) {
  const Where here;
  require_unused(def.unused, here, "samples");
  avo::PlannerOptions options;
  take_members(def, options, here, for_each_option);
  options.sensing_noise = {def.sensing_noise.position, def.sensing_noise.velocity,
                           def.sensing_noise.quantile};
  return options;
}

}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_planner_def avo_default_planner_def(avo_method method) {
  const bool is_known = method >= AVO_METHOD_AVO && method <= AVO_METHOD_BUFFERED_VORONOI;
  const avo::PlannerOptions options =
      avo::default_options(is_known ? static_cast<avo::Method>(method) : avo::Method::avo);
  avo_planner_def def = {};
  def.size = sizeof def;
  give_members(options, def, for_each_option);
  def.sensing_noise = {options.sensing_noise.position, options.sensing_noise.velocity,
                       options.sensing_noise.quantile};
  return def;
}

avo_result avo_create_planner(const avo_planner_def* def, avo_planner_id* planner) {
  return guarded([&] {
    avo_planner_id& id = at(planner, "planner");
    const avo_planner_def known = read(def, {"def"}, avo_default_planner_def(AVO_METHOD_AVO));
    id = planners.add(std::make_unique<avo::Planner>(options_of(known)));
  });
}

avo_result avo_destroy_planner(avo_planner_id planner) {
  return guarded([&] { planners.take(planner); });
}

bool avo_planner_is_valid(avo_planner_id planner) {
  return planners.find(planner) != nullptr;
}

avo_result avo_planner_response_time(avo_planner_id planner, double max_speed,
                                     double max_acceleration, double* time) {
  return guarded([&] {
    at(time, "time") =
        avo::response_time_of(planners.at(planner).options(), max_speed, max_acceleration);
  });
}

avo_result avo_planner_braking_pose(avo_planner_id planner, const avo_robot* robot,
                                    avo_braking_pose* pose, avo_footprint* footprint) {
  return guarded([&] {
    avo_braking_pose& to = at(pose, "pose");
    avo_footprint& about_disc = at(footprint, "footprint");
    const avo::Robot own = read_robot(robot);
    const avo::BrakingPose found = planners.at(planner).braking_pose(own);
    to = {to_c(found.ahead), found.spread};
    about_disc = to_c(avo::footprint_of(own.model));
  });
}

avo_result avo_planner_plan(avo_planner_id planner, const avo_robot* robot,
                            const avo_neighbor* neighbors, size_t neighbor_count,
                            const avo_wall* walls, size_t wall_count, avo_detour* detour,
                            avo_plan* plan) {
  return guarded([&] {
    const avo::Planner& own = planners.at(planner);
    avo_plan& result = at(plan, "plan");
    avo::Detour remembered;
    if (detour != nullptr) remembered = std::bit_cast<avo::Detour>(*detour);
    result = std::bit_cast<avo_plan>(
        own.plan(read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"),
                 scratch().workspace, detour == nullptr ? nullptr : &remembered,
                 walls_of(walls, wall_count)));
    if (detour != nullptr) *detour = std::bit_cast<avo_detour>(remembered);
  });
}

avo_result avo_planner_plan_among_movers(avo_planner_id planner, const avo_robot* robot,
                                         const avo_neighbor* movers, size_t mover_count,
                                         avo_plan* plan) {
  return guarded([&] {
    const avo::Planner& own = planners.at(planner);
    avo_plan& result = at(plan, "plan");
    result = std::bit_cast<avo_plan>(own.plan_among_movers(
        read_robot(robot), neighbors_of(movers, mover_count, "movers"), scratch().workspace));
  });
}

avo_result avo_planner_evasion(avo_planner_id planner, const avo_robot* robot,
                               const avo_neighbor* neighbors, size_t neighbor_count,
                               const avo_wall* walls, size_t wall_count, const avo_detour* detour,
                               avo_evasion* evasion) {
  return guarded([&] {
    const avo::Planner& own = planners.at(planner);
    avo_evasion& result = at(evasion, "evasion");
    avo::Detour remembered;
    if (detour != nullptr) remembered = std::bit_cast<avo::Detour>(*detour);
    const auto known =
        own.evasion(read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"),
                    scratch().workspace, detour == nullptr ? nullptr : &remembered,
                    walls_of(walls, wall_count));
    const avo::Evasion none;
    const avo::Evasion& shown = known ? *known : none;
    result = {to_c(shown.velocity), shown.duration, shown.neighbor};
  });
}

avo_result avo_planner_has_evasive_maneuver(avo_planner_id planner, const avo_robot* robot,
                                            const avo_neighbor* neighbors, size_t neighbor_count,
                                            const avo_wall* walls, size_t wall_count,
                                            bool* has_evasive_maneuver) {
  return guarded([&] {
    const avo::Planner& own = planners.at(planner);
    at(has_evasive_maneuver, "has_evasive_maneuver") = own.has_evasive_maneuver(
        read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"),
        scratch().workspace, walls_of(walls, wall_count));
  });
}

avo_result avo_planner_state(avo_planner_id planner, const avo_robot* robot,
                             const avo_neighbor* neighbors, size_t neighbor_count,
                             const avo_wall* walls, size_t wall_count, avo_safety_report* report) {
  return guarded([&] {
    const avo::Planner& own = planners.at(planner);
    avo_safety_report& result = at(report, "report");
    const avo::SafetyReport known =
        own.state(read_robot(robot), neighbors_of(neighbors, neighbor_count, "neighbors"),
                  scratch().workspace, walls_of(walls, wall_count));
    result = {known.time, known.depth, known.neighbor, known.wall,
              static_cast<avo_safety_state>(known.state)};
  });
}
