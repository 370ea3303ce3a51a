// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "avo/space/planner.h"
#include "space/choice.h"
#include "space/half_spaces.h"
#include "space/ways.h"

namespace avo::space {

struct PlanWorkspace::Scratch {
  HalfSpaces half_spaces;
  std::vector<HalfSpace> speeds;  ///< of boxes, in space
  std::vector<HalfSpace> planes;  ///< in v', in the robot's own space: the hard ones first
  std::size_t hard = 0;           ///< the number of hard ones
  ChoiceWorkspace choice;
  WaySearch ways;  ///< out, beside moving obstacles
};

}  // namespace avo::space
