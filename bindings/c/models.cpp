// SPDX-License-Identifier: Apache-2.0
// How robots move.
#include <type_traits>
#include <variant>

#include "convert.h"

namespace avo_c {
namespace {

avo::Car car_of(const avo_car& car, const avo_footprint& footprint, const Where& where) {
  avo::Car result;
  result.footprint = from_c(footprint);
  result.wheelbase = car.wheelbase;
  result.max_curvature = unless_zero(car.max_curvature);
  if (car.body.radius != 0.0) result.body = avo::CarBody{car.body.offset, car.body.radius};
  result.reverse = car.reverse;
  result.acceleration_set =
      word<avo::AccelerationSet>(car.acceleration_set, 2, where, "car.acceleration_set");
  return result;
}

avo_car to_c(const avo::Car& car) {
  const avo::CarBody body = car.body.value_or(avo::CarBody{0.0, 0.0});
  return {car.wheelbase,
          car.max_curvature.value_or(0.0),
          {body.offset, body.radius},
          static_cast<avo_acceleration_set>(car.acceleration_set),
          car.reverse};
}

avo_differential_drive to_c(const avo::DifferentialDrive& drive) {
  return {drive.track, drive.offset, drive.wheel_speed, drive.wheel_acceleration};
}

avo_airplane to_c(const avo::Airplane& airplane) {
  return {airplane.min_speed, airplane.lateral_acceleration,
          static_cast<avo_after_goal>(airplane.after_goal)};
}

// Only a robot of a simulation has a radius from which the offset can be chosen.
template <typename Def>
double offset_of(const Def& def) {
  if constexpr (std::is_same_v<Def, avo_robot_def>)
    if (def.drive.offset == 0.0) return avo::usual_offset(def.radius, def.drive.track);
  return def.drive.offset;
}

}  // namespace

template <typename Def>
avo::MotionModel model_of(const Def& def, const Where& where) {
  switch (word<std::int32_t>(def.model, 4, where, "model")) {
    case AVO_MODEL_CAR:
      return car_of(def.car, def.footprint, where);
    case AVO_MODEL_DIFFERENTIAL_DRIVE:
      return avo::DifferentialDrive{def.drive.track, offset_of(def), def.drive.wheel_speed,
                                    def.drive.wheel_acceleration, from_c(def.footprint)};
    case AVO_MODEL_AIRPLANE:
      return avo::Airplane{
          def.airplane.min_speed, def.airplane.lateral_acceleration,
          word<avo::AfterGoal>(def.airplane.after_goal, 2, where, "airplane.after_goal")};
    default:
      return avo::Holonomic{};
  }
}

template <typename Def>
void set_model(const avo::MotionModel& model, Def& def) {
  def.model = static_cast<avo_model>(model.index());
  def.car = to_c(avo::Car{});
  def.drive = to_c(avo::DifferentialDrive{});
  if constexpr (std::is_same_v<Def, avo_robot_def>) def.drive.offset = 0.0;
  def.airplane = to_c(avo::Airplane{});
  def.footprint = to_c(avo::Footprint{});
  if (const auto* car = std::get_if<avo::Car>(&model))
    def.car = to_c(*car), def.footprint = to_c(car->footprint);
  if (const auto* drive = std::get_if<avo::DifferentialDrive>(&model))
    def.drive = to_c(*drive), def.footprint = to_c(drive->footprint);
  if (const auto* airplane = std::get_if<avo::Airplane>(&model)) def.airplane = to_c(*airplane);
}

template avo::MotionModel model_of(const avo_robot&, const Where&);
template avo::MotionModel model_of(const avo_robot_def&, const Where&);
template void set_model(const avo::MotionModel&, avo_robot&);
template void set_model(const avo::MotionModel&, avo_robot_def&);

}  // namespace avo_c
