// SPDX-License-Identifier: Apache-2.0
// The one table of the fields of a scene file: the parser, overrides, the JSON Schema and error
// messages all read it. The fields of public structs are those of src/fields.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "avo/scenario.h"
#include "avo/vec.h"
#include "core/ranges.h"
#include "fields/field.h"
#include "fields/robot_fields.h"
#include "fields/space_fields.h"
#include "io/scene/scene_parts.h"
#include "io/space/space_parts.h"

namespace avo_io {
using avo::kHeadingField;
using avo::kLayer;
using avo::kNested;
using avo::kNoNumber;
using avo::kOptional;
using avo::kRequired;
using avo::MemberOf;
using avo::Need;

template <class T>
struct MembersOf : avo::MembersOf<T> {};
template <>
struct MembersOf<FormationGoals> {
  using type = MemberOf<FormationGoals, double, avo::Vec2, avo::Formation>;
};
template <>
struct MembersOf<RosMap> {
  using type = MemberOf<RosMap, std::string, double, RosMode>;
};
template <class T>
using Member = typename MembersOf<T>::type;

template <class T>
using Field = avo::Field<T, Member<T>>;

/// How many robots.
inline constexpr avo::Range kNumber{1.0, static_cast<double>(avo::kMostRobots), false};

/// The fields of T, in the order of the documentation.
template <class T>
const std::vector<Field<T>>& fields();

/// RobotSetup's fields without position and goal, for groups.
const std::vector<Field<avo::RobotSetup>>& group_robot_fields();

/// Choices with the names that the library has for them.
template <class Choice, class... Others>
auto by_name(Choice first, Others... others) {
  const auto named = [](Choice choice) {
    return std::pair{std::string_view(to_string(choice)), choice};
  };
  return std::array{named(first), named(others)...};
}
/// The words of an enum in scene files, in the order of the documentation.
template <class Choice>
AVO_LOCAL inline constexpr std::array<std::pair<std::string_view, Choice>, 0> kWords{};
template <>
AVO_LOCAL inline const auto kWords<avo::Method> =
    by_name(avo::Method::avo, avo::Method::avo_paper, avo::Method::velocity_obstacle,
            avo::Method::orca, avo::Method::orca_clamped, avo::Method::reciprocal_velocity_obstacle,
            avo::Method::buffered_voronoi, avo::Method::external, avo::Method::external_clamped);
template <>
AVO_LOCAL inline const auto kWords<avo::Certificate> =
    by_name(avo::Certificate::none, avo::Certificate::braking_trajectories);
template <>
AVO_LOCAL inline const auto kWords<avo::Motion> = by_name(avo::Motion::held,
                                                          avo::Motion::exponential);
template <>
AVO_LOCAL inline const auto kWords<avo::Clock> = by_name(avo::Clock::common, avo::Clock::free);
template <>
AVO_LOCAL inline const auto kWords<avo::RightOfWay> = by_name(avo::RightOfWay::none,
                                                              avo::RightOfWay::seen);
template <>
AVO_LOCAL inline const auto kWords<avo::NoiseDistribution> =
    by_name(avo::NoiseDistribution::gaussian, avo::NoiseDistribution::uniform);
template <>
AVO_LOCAL inline const auto kWords<avo::AccelerationSet> = by_name(avo::AccelerationSet::incircle,
                                                                   avo::AccelerationSet::exact);

template <>
AVO_LOCAL inline const auto kWords<avo::Behavior> = by_name(avo::Behavior::decides,
                                                            avo::Behavior::cooperates,
                                                            avo::Behavior::moves_on,
                                                            avo::Behavior::parked);
template <>
AVO_LOCAL inline const auto kWords<avo::Formation> = by_name(avo::Formation::line,
                                                             avo::Formation::column,
                                                             avo::Formation::wedge,
                                                             avo::Formation::block,
                                                             avo::Formation::ring);
template <>
AVO_LOCAL inline const auto kWords<avo::AfterGoal> = by_name(avo::AfterGoal::loiter,
                                                             avo::AfterGoal::leave);

/// The alternatives of avo::MotionModel, in their order.
enum class ModelKind : std::uint8_t { holonomic, car, differential_drive, airplane };
inline constexpr std::array<std::pair<std::string_view, ModelKind>, 4> kModels{
    {{"holonomic", ModelKind::holonomic},
     {"car", ModelKind::car},
     {"differential_drive", ModelKind::differential_drive},
     {"airplane", ModelKind::airplane}}};
constexpr std::string_view model_name(ModelKind kind) {
  return kModels[static_cast<std::size_t>(kind)].first;
}
inline constexpr std::array<std::pair<std::string_view, GroupHeading>, 2> kHeadings{
    {{"goal", GroupHeading::goal}, {"random", GroupHeading::random}}};

template <>
AVO_LOCAL inline constexpr std::array<std::pair<std::string_view, avo::Fill>, 2> kWords<avo::Fill>{
    {{"solid", avo::Fill::solid}, {"bounds", avo::Fill::bounds}}};
template <>
AVO_LOCAL inline constexpr std::array<std::pair<std::string_view, RosMode>, 3> kWords<RosMode>{
    {{"trinary", RosMode::trinary}, {"scale", RosMode::scale}, {"raw", RosMode::raw}}};

template <class T>
std::vector<std::string_view> keys_of(const std::vector<Field<T>>& table) {
  std::vector<std::string_view> keys;
  keys.reserve(table.size());
  for (const Field<T>& field : table) keys.push_back(field.key);
  return keys;
}

}  // namespace avo_io
