// SPDX-License-Identifier: Apache-2.0
// The only place that distinguishes motion models.
#include "robots/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/plane.h"
#include "core/ranges.h"
#include "robots/ahead.h"
#include "robots/airplane.h"
#include "robots/car.h"
#include "robots/drive.h"
#include "robots/footprint.h"

namespace avo {

const char* to_string(AccelerationSet set) {
  return set == AccelerationSet::exact ? "exact" : "incircle";
}

bool moves_along_heading(const MotionModel& model) {
  return std::holds_alternative<Car>(model) || !can_rest(model);
}

double usual_offset(double radius, double track) {
  return 0.5 * std::min(radius, track);
}

double acceleration_limit(const MotionModel& model, double max_acceleration) {
  const Airplane* airplane = std::get_if<Airplane>(&model);
  if (airplane != nullptr) return norm(Vec2{max_acceleration, airplane->lateral_acceleration});
  return max_acceleration;
}

double disc_radius(const MotionModel& model, double radius) {
  if (const Footprint footprint = footprint_of(model)) return bounding_radius(footprint);
  if (const auto* drive = std::get_if<DifferentialDrive>(&model)) return radius + drive->offset;
  const Car* car = std::get_if<Car>(&model);
  return car != nullptr && car->body ? car->body->radius : radius;
}

Vec2 disc_center(const MotionModel& model, Vec2 position, double heading) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&model))
    return position + drive->offset * ahead_of(heading);
  const Car* car = std::get_if<Car>(&model);
  if (car == nullptr || offset_of(*car) == 0.0) return position;
  return position + offset_of(*car) * ahead_of(heading);
}

}  // namespace avo

namespace avo::inline robots {
namespace {

ModelTraits traits_of(const Holonomic&) {
  return {};
}

ModelTraits traits_of(const Car& car) {
  const bool swings = offset_of(car) != 0.0;
  return {.turns_in_place = turns_in_place(car),
          .can_reverse = car.reverse,
          .swings = swings,
          .has_own_half_planes = has_own_half_planes(car),
          .reach = reach_of(car),
          .speed_ratio = swings ? 1.0 + std::abs(offset_of(car)) * sharpest(car) : 1.0,
          .maneuver_room = room_for_maneuvers(car)};
}

ModelTraits traits_of(const DifferentialDrive& drive) {
  return {.has_limits_within_steps = true, .maneuver_room = room_for_maneuvers(drive)};
}

ModelTraits traits_of(const Airplane& airplane) {
  return {.leaves_at_goal = airplane.after_goal == AfterGoal::leave,
          .least_speed = airplane.min_speed};
}

}  // namespace

ModelTraits own_traits(const MotionModel& model) {
  return std::visit([](const auto& own) { return traits_of(own); }, model);
}

MotionStep advance(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&model))
    return advance_drive(*drive, state, plan, time_step);
  if (const Airplane* airplane = std::get_if<Airplane>(&model))
    return fly(*airplane, limits, state, plan, time_step).motion;
  return advance_car(std::get<Car>(model), limits, state, plan, time_step);
}

void advance_together(std::span<ModelStep> steps, double time_step) {
  std::array<ModelStep*, kMostModelSteps> drives, cars;
  std::size_t drive_count = 0, car_count = 0;
  for (ModelStep& step : steps) {
    if (std::holds_alternative<DifferentialDrive>(*step.model)) {
      drives[drive_count++] = &step;
    } else if (std::holds_alternative<Car>(*step.model)) {
      cars[car_count++] = &step;
    } else {
      step.result = advance(*step.model, step.limits, step.state, *step.plan, time_step);
    }
  }
  if (drive_count > 0) advance_drives(std::span(drives).first(drive_count), time_step);
  if (car_count > 0) advance_cars(std::span(cars).first(car_count), time_step);
}

void advance_discs(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
                   const Plan& plan, double time_step, std::span<MotionStep> discs) {
  if (const Car* car = std::get_if<Car>(&model))
    return advance_discs(*car, limits, state, plan, time_step, discs);
  const MotionStep step = advance(model, limits, state, plan, time_step);
  std::fill(discs.begin(), discs.end(), step);
}

BrakingPose turn_while_braking(const MotionModel& model, Vec2 velocity, double heading,
                               double length) {
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  if (drive != nullptr) return turn_while_braking(*drive, velocity, ahead_of(heading), length);
  return {ahead_of(heading), 0.0};
}

std::optional<BrakingPose> turn_within(const MotionModel& model, const MotionState& from,
                                       const MotionState& to, double time_step) {
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  return drive != nullptr ? std::optional(turn_within(*drive, from, to, time_step)) : std::nullopt;
}

MotionState within(const MotionModel& model, const MotionState& from, const MotionState& to,
                   double time, double duration) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&model))
    return within_step(*drive, from, to, time, duration);
  return within_arc(std::get<Car>(model), from, to, time, duration);
}

Stray stray_of(const MotionModel& model, double max_acceleration, double time_step) {
  const Car* car = std::get_if<Car>(&model);
  return car != nullptr ? stray_of_car(*car, max_acceleration, time_step) : Stray{};
}

SensingError unforeseen(const MotionModel& model, double max_acceleration, double time_step) {
  const Car* car = std::get_if<Car>(&model);
  return car != nullptr ? unforeseen_of_car(*car, max_acceleration, time_step) : SensingError{};
}

double swing_of(const MotionModel& model, double max_acceleration, double top_speed,
                double time_step) {
  const Car* car = std::get_if<Car>(&model);
  if (car == nullptr || offset_of(*car) == 0.0) return 0.0;
  const double turning = std::min(top_speed * sharpest(*car),
                                  std::sqrt(max_acceleration * sharpest(*car)));  // [v κ] rad/s
  const double driving = std::abs(offset_of(*car)) * turning;
  if (!turns_in_place(*car)) return driving;
  return std::max(driving, 0.5 * max_acceleration * time_step);
}

double top_speed_of(const Robot& robot, double u) {
  const Car* car = std::get_if<Car>(&robot.model);
  return car != nullptr ? std::min(top_speed_of(*car, robot, u), robot.max_speed) : robot.max_speed;
}

Vec2 within_own_limits(const Robot& robot, double time, Vec2 v) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot.model))
    return within_own_limits(*drive, robot, time, v);
  const Car* car = std::get_if<Car>(&robot.model);
  return car != nullptr && has_own_half_planes(*car) ? within_own_limits(*car, robot, time, v) : v;
}

Vec2 approached(const Robot& robot, double time, double increment, Vec2 w) {
  if (const Car* car = std::get_if<Car>(&robot.model))
    return approached(*car, robot, time, increment, w);
  return within_own_limits(robot, time, approach(robot.velocity, w, increment));
}

void append_own_half_planes(const Robot& robot, double time, std::vector<HalfPlane>& half_planes) {
  if (const Car* car = std::get_if<Car>(&robot.model))
    append_own_half_planes(*car, robot, time, half_planes);
  if (const Airplane* airplane = std::get_if<Airplane>(&robot.model))
    append_own_half_planes(*airplane, robot, time, half_planes);
}

Vec2 steered(const Robot& robot, const Approach& approach) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot.model))
    return steered(*drive, robot, approach);
  if (const Car* car = std::get_if<Car>(&robot.model)) return steered(*car, robot, approach);
  const Airplane* airplane = std::get_if<Airplane>(&robot.model);
  return airplane != nullptr ? steered(*airplane, robot) : robot.preferred_velocity;
}

Vec2 within_steering(const Robot& robot, Vec2 v) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&robot.model))
    return within_steering(*drive, robot, v);
  if (const Car* car = std::get_if<Car>(&robot.model)) return within_steering(*car, robot, v);
  const Airplane* airplane = std::get_if<Airplane>(&robot.model);
  return airplane != nullptr ? within_steering(*airplane, robot, v) : v;
}

Vec2 turning_first(const Robot& robot, Vec2 v) {
  const Car* car = std::get_if<Car>(&robot.model);
  return car != nullptr ? turning_first(*car, robot, v) : v;
}

std::optional<Vec2> maneuver(const Robot& robot, const Approach& approach, bool is_beside,
                             const ClearPlaces& is_clear, ManeuverMemory& memory) {
  if (const Car* car = std::get_if<Car>(&robot.model))
    return maneuver(*car, robot, approach, is_beside, is_clear, memory);
  const auto* drive = std::get_if<DifferentialDrive>(&robot.model);
  return drive != nullptr ? maneuver(*drive, robot, approach, is_clear) : std::nullopt;
}

double pass(const MotionModel& model, const MotionLimits& limits, const MotionState& state,
            const Plan& plan, double time_step, Vec2 goal) {
  return distance(fly(std::get<Airplane>(model), limits, state, plan, time_step).arc, goal);
}

std::optional<LoiterCircle> circle_of(const MotionModel& model, Vec2 position, Vec2 velocity) {
  const Airplane* airplane = std::get_if<Airplane>(&model);
  if (airplane == nullptr) return std::nullopt;
  return loiter_circle(*airplane, position, velocity);
}

double room_to_turn(const MotionModel& model, double max_speed) {
  const Airplane* airplane = std::get_if<Airplane>(&model);
  if (airplane == nullptr) return 0.0;
  return 2.0 * max_speed * max_speed / usable_acceleration(*airplane);
}

double turning_radius(const MotionModel& model) {
  const Car* car = std::get_if<Car>(&model);
  return car != nullptr && car->max_curvature ? 1.0 / *car->max_curvature : 0.0;
}

double towed_length(const MotionModel& model) {
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  return drive != nullptr ? drive->offset : 0.0;
}

double route_radius(const MotionModel& model, double radius) {
  const Footprint footprint = footprint_of(model);
  return footprint ? footprint.radius : radius;
}

bool is_valid(const MotionModel& model, double most_change, double max_speed) {
  if (const auto* drive = std::get_if<DifferentialDrive>(&model)) {
    return kPositive.contains(drive->track) && kPositive.contains(drive->offset) &&
           kPositive.contains(drive->wheel_speed) &&
           kPositive.contains(drive->wheel_acceleration) && is_valid(drive->footprint) &&
           max_speed <= drive->wheel_speed && most_change < most_acceleration(*drive);
  }
  if (const Airplane* airplane = std::get_if<Airplane>(&model))
    return kPositive.contains(airplane->min_speed) &&
           kPositive.contains(airplane->lateral_acceleration);
  const Car* car = std::get_if<Car>(&model);
  if (car == nullptr) return true;
  const bool body = !car->body || (kAnyValue.contains(car->body->offset) &&
                                   kPositive.contains(car->body->radius));
  const bool footprint = is_valid(car->footprint) && !(car->footprint && car->body);
  return kPositive.contains(car->wheelbase) && body && footprint &&
         (!car->max_curvature || kPositive.contains(*car->max_curvature));
}

}  // namespace avo::inline robots
