// SPDX-License-Identifier: Apache-2.0
// Bases that do not execute commands exactly.
#include <bit>
#include <memory>

#include "avo/execution.h"
#include "convert.h"
#include "handles.h"
#include "layouts.h"
#include "planners.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_reference_tracker_id, avo::ReferenceTracker> trackers(
    "reference_tracker");

avo_execution_error bounds_of(const avo::ExecutionError& error) {
  return {error.position, error.velocity, error.command};
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_find_execution_error(const avo_execution_model* model, const avo_robot* robot,
                                    double time_step, avo_execution_error* error) {
  return guarded([&] {
    const avo::ExecutionError found =
        avo::execution_error(execution_of(at(model, "model")), read_robot(robot), time_step);
    at(error, "error") = bounds_of(found);
  });
}

avo_result avo_drive_command(const avo_execution_model* model, const avo_robot* body,
                             avo_vec2 velocity, avo_wheel_command* command) {
  return guarded([&] {
    const avo::DriveCommand found =
        avo::drive_command(execution_of(at(model, "model")), read_robot(body), from_c(velocity));
    at(command, "command") = {found.speed, found.turning_rate};
  });
}

avo_result avo_create_reference_tracker(const avo_execution_model* model, avo_planner_id planner,
                                        avo_reference_tracker_id* tracker) {
  return guarded([&] {
    avo_reference_tracker_id& id = at(tracker, "tracker");
    id = trackers.add(std::make_unique<avo::ReferenceTracker>(execution_of(at(model, "model")),
                                                              planners.at(planner)));
  });
}

avo_result avo_destroy_reference_tracker(avo_reference_tracker_id tracker) {
  return guarded([&] { trackers.take(tracker); });
}

bool avo_reference_tracker_is_valid(avo_reference_tracker_id tracker) {
  return trackers.find(tracker) != nullptr;
}

avo_result avo_reference_tracker_reference(avo_reference_tracker_id tracker, const avo_robot* body,
                                           avo_robot* reference) {
  return guarded([&] {
    const avo::Robot led = trackers.at(tracker).reference(read_robot(body));
    avo_robot robot = read(body, {"body"}, avo_default_robot());
    robot.position = to_c(led.position), robot.velocity = to_c(led.velocity);
    robot.radius = led.radius;
    write(reference, robot, {"reference"});
  });
}

avo_result avo_reference_tracker_follow(avo_reference_tracker_id tracker, const avo_robot* body,
                                        const avo_plan* plan, avo_base_command* command) {
  return guarded([&] {
    avo::ReferenceTracker& own = trackers.at(tracker);
    avo_base_command& result = at(command, "command");
    const auto decided = std::bit_cast<avo::Plan>(at(plan, "plan"));
    result = std::bit_cast<avo_base_command>(own.follow(read_robot(body), decided));
  });
}

avo_result avo_reference_tracker_forget(avo_reference_tracker_id tracker) {
  return guarded([&] { trackers.at(tracker).forget(); });
}

avo_result avo_reference_tracker_error(avo_reference_tracker_id tracker, const avo_robot* body,
                                       avo_execution_error* error) {
  return guarded(
      [&] { at(error, "error") = bounds_of(trackers.at(tracker).error(read_robot(body))); });
}
