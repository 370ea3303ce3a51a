// SPDX-License-Identifier: Apache-2.0
// The fields of public structs, as src/fields has them.
#include "io/fields/fields.h"

#include <algorithm>

#include "fields/model_fields.h"
#include "fields/robot_fields.h"
#include "fields/scene_fields.h"

namespace avo_io {
namespace {

template <class Rows>
auto listed(const Rows& rows) {
  return std::vector(rows.begin(), rows.end());
}

}  // namespace

template <>
const std::vector<Field<avo::RobotSetup>>& fields() {
  static const auto table = listed(avo::kRobotFields);
  return table;
}

template <>
const std::vector<Field<avo::Car>>& fields() {
  static const auto table = listed(avo::kCarFields);
  return table;
}

template <>
const std::vector<Field<avo::CarBody>>& fields() {
  static const auto table = listed(avo::kCarBodyFields);
  return table;
}

template <>
const std::vector<Field<avo::DifferentialDrive>>& fields() {
  static const auto table = listed(avo::kDriveFields);
  return table;
}

template <>
const std::vector<Field<avo::Airplane>>& fields() {
  static const auto table = listed(avo::kAirplaneFields);
  return table;
}

template <>
const std::vector<Field<avo::Scenario>>& fields() {
  static const auto table = listed(avo::kScenarioFields);
  return table;
}

template <>
const std::vector<Field<avo::SensingModel>>& fields() {
  static const auto table = listed(avo::kSensingFields);
  return table;
}

template <>
const std::vector<Field<avo::MeasurementNoise>>& fields() {
  static const auto table = listed(avo::kMeasurementNoiseFields);
  return table;
}

template <>
const std::vector<Field<avo::LocalizationNoise>>& fields() {
  static const auto table = listed(avo::kLocalizationNoiseFields);
  return table;
}

template <>
const std::vector<Field<avo::SensingError>>& fields() {
  static const auto table = listed(avo::kSensingErrorFields);
  return table;
}

template <>
const std::vector<Field<avo::ExecutionModel>>& fields() {
  static const auto table = listed(avo::kExecutionFields);
  return table;
}

template <>
const std::vector<Field<avo::MovingObstacle>>& fields() {
  static const auto table = listed(avo::kMoverFields);
  return table;
}

}  // namespace avo_io
