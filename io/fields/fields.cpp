// SPDX-License-Identifier: Apache-2.0
// The fields of public structs, as src/fields has them.
#include "io/fields/fields.h"

#include "fields/model_fields.h"
#include "fields/robot_fields.h"
#include "fields/scene_fields.h"
#include "fields/space_fields.h"
#include "fields/team_fields.h"

namespace avo_io {

template <class T>
const std::vector<Field<T>>& fields() {
  static const std::vector<Field<T>> table(avo::kFields<T>.begin(), avo::kFields<T>.end());
  return table;
}

template const std::vector<Field<avo::RobotSetup>>& fields();
template const std::vector<Field<avo::Car>>& fields();
template const std::vector<Field<avo::CarBody>>& fields();
template const std::vector<Field<avo::DifferentialDrive>>& fields();
template const std::vector<Field<avo::Airplane>>& fields();
template const std::vector<Field<avo::Scenario>>& fields();
template const std::vector<Field<avo::SensingModel>>& fields();
template const std::vector<Field<avo::MeasurementNoise>>& fields();
template const std::vector<Field<avo::LocalizationNoise>>& fields();
template const std::vector<Field<avo::SensingError>>& fields();
template const std::vector<Field<avo::ExecutionModel>>& fields();
template const std::vector<Field<avo::MovingObstacle>>& fields();
template const std::vector<Field<avo::Queue>>& fields();
template const std::vector<Field<avo::Follow>>& fields();
template const std::vector<Field<avo::Patrol>>& fields();
template const std::vector<Field<avo::Flow>>& fields();
template const std::vector<Field<avo::space::RobotSetup>>& fields();
template const std::vector<Field<avo::space::Quadrotor>>& fields();
template const std::vector<Field<avo::space::Scenario>>& fields();
template const std::vector<Field<avo::space::MovingObstacle>>& fields();

}  // namespace avo_io
