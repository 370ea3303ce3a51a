// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <vector>

#include "avo/space/planner.h"
#include "space/bodies.h"
#include "space/choice.h"
#include "space/evasions.h"
#include "space/half_spaces.h"
#include "space/look.h"

namespace avo::space {

struct PlanWorkspace::Scratch {
  Bodies bodies;  ///< of neighbors that are given one by one
  Looked looked;
  HalfSpaceColumns hard;                      ///< in v', in the robot's own space
  HalfSpaces half_spaces;                     ///< the hard ones first
  bool has_all = false;                       ///< whether these are all that can cut
  std::vector<HalfSpace> speeds, own_speeds;  ///< of boxes; and all hard ones, in its own space
  ChoiceWorkspace choice;
  EvasionSearch evasions;            ///< out, beside moving obstacles
  std::vector<HalfSpace> of_movers;  ///< in space
};

}  // namespace avo::space
