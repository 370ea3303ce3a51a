// SPDX-License-Identifier: Apache-2.0
// The common part of the two halves of the advice: settings, and starts.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {

inline std::string in_short(double value) {
  return rounded(value, 6);
}
std::string robot_name(std::size_t index);
/// Returns whether broken_assumptions() tells what is wrong with the robot.
bool keeps_certificate(const Scenario& scenario, const RobotSetup& robot);

/// Names the bodies that overlap at the start.
void advise_overlaps(const Scenario& scenario, std::vector<std::string>& lines);

}  // namespace avo::inline sim
