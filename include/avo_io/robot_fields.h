// SPDX-License-Identifier: Apache-2.0
// The keys of a robot in scene files, for programs that offer the same fields.
#pragma once
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"

namespace avo_io {

/// A key of a robot, and the member of its setup.
struct RobotField {
  std::string_view key;
  std::variant<double avo::RobotSetup::*, std::optional<double> avo::RobotSetup::*,
               avo::Vec2 avo::RobotSetup::*, bool avo::RobotSetup::*,
               avo::LayerSet avo::RobotSetup::*, avo::Behavior avo::RobotSetup::*,
               std::optional<avo::Method> avo::RobotSetup::*>
      member;
  bool is_required = false;
  std::string_view unit;          ///< empty: none
  std::string_view doc;           ///< one line
  std::string_view default_text;  ///< empty: the default is that of RobotSetup
};

/// All keys but those of the motion model, in the order of the documentation. `heading` belongs to
/// the model.
AVO_API std::vector<RobotField> robot_fields();

}  // namespace avo_io
