// SPDX-License-Identifier: Apache-2.0
// The keys of robots and scenes in scene files, for programs that offer the same fields.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "avo/export.h"
#include "avo/scenario.h"
#include "avo/space/scenario.h"

namespace avo_io {

/// A key, and the member of the struct T, which has one of the types Values.
template <class T, class... Values>
struct FieldOf {
  using Struct = T;
  std::string_view key;
  std::variant<Values T::*...> member;
  bool is_required = false;
  std::string_view unit;          ///< empty: none
  std::string_view doc;           ///< one line
  std::string_view default_text;  ///< empty: the default is that of the struct
};

/// A key of a robot.
using RobotField = FieldOf<avo::RobotSetup, double, std::optional<double>, avo::Vec2, avo::LayerSet,
                           avo::Behavior, std::optional<avo::Method>>;
/// An option of a planner.
using PlannerField = FieldOf<avo::PlannerOptions, double, std::optional<double>, std::optional<int>,
                             bool, avo::Method, avo::Motion, avo::Certificate, avo::Clock>;
/// A key of a scene.
using SceneField = FieldOf<avo::Scenario, double, std::optional<double>, int, std::optional<int>,
                           std::uint64_t, std::string, avo::Method, std::optional<avo::Certificate>,
                           avo::Motion, bool, std::optional<bool>, avo::RightOfWay, avo::Clock>;
/// A key of a robot of space.
using SpaceRobotField = FieldOf<avo::space::RobotSetup, double, std::optional<double>, avo::Vec3>;
/// A key of a scene of space.
using SpaceSceneField =
    FieldOf<avo::space::Scenario, double, std::optional<double>, std::optional<int>, std::uint64_t,
            std::string, bool, std::optional<avo::Certificate>, avo::Motion>;

/// All keys of a robot but those of its motion model, in the order of the documentation. `heading`
/// belongs to the model, and `parked` is a value of `behavior`.
AVO_API std::vector<RobotField> robot_fields();
/// All options of a planner but `sensing_error`, `sensing_noise` and `wall_range`.
AVO_API std::vector<PlannerField> planner_fields();
/// All keys of a scene that have one value.
AVO_API std::vector<SceneField> scene_fields();
/// All keys of a robot of space but `quadrotor`.
AVO_API std::vector<SpaceRobotField> space_robot_fields();
/// All keys of a scene of space that have one value.
AVO_API std::vector<SpaceSceneField> space_scene_fields();

}  // namespace avo_io
