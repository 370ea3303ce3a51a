// SPDX-License-Identifier: Apache-2.0
// The one table of the fields of a scene file: the parser, overrides, the JSON Schema and error
// messages all read it. Default values are those of the structs themselves.
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
#include "io/scene/scene_parts.h"
#include "io/space/space_parts.h"

namespace avo_io {

/// The kinds of values that T may be. std::monostate stands for a value with keys of its own, which
/// code reads.
template <class T, class... Kinds>
using MemberOf = std::variant<std::monostate, Kinds T::*...>;
template <class T>
struct MembersOf {
  using type = MemberOf<T, double, avo::Vec2>;
};
template <>
struct MembersOf<avo::RobotSetup> {
  using type = MemberOf<avo::RobotSetup, double, std::optional<double>, avo::Vec2, bool,
                        avo::LayerSet, avo::Behavior, std::optional<avo::Method>>;
};
template <>
struct MembersOf<avo::MovingObstacle> {
  using type = MemberOf<avo::MovingObstacle, double, std::optional<double>, avo::Vec2,
                        std::vector<avo::Vec2>, std::vector<avo::TimedPlace>>;
};
template <>
struct MembersOf<avo::Car> {
  using type = MemberOf<avo::Car, double, std::optional<double>, bool, avo::AccelerationSet>;
};
template <>
struct MembersOf<avo::DifferentialDrive> {
  using type = MemberOf<avo::DifferentialDrive, double>;
};
template <>
struct MembersOf<FootprintShape> {
  using type = MemberOf<FootprintShape, double, std::optional<double>, std::vector<avo::Vec2>>;
};
template <>
struct MembersOf<avo::Airplane> {
  using type = MemberOf<avo::Airplane, double, avo::AfterGoal>;
};
template <>
struct MembersOf<AntipodalGoals> {
  using type = MemberOf<AntipodalGoals>;
};
template <>
struct MembersOf<PermutationGoals> {
  using type = MemberOf<PermutationGoals>;
};
template <>
struct MembersOf<GridPlacement> {
  using type = MemberOf<GridPlacement, double, avo::Vec2, int>;
};
template <>
struct MembersOf<FormationGoals> {
  using type = MemberOf<FormationGoals, double, avo::Vec2, avo::Formation>;
};
template <>
struct MembersOf<avo::Queue> {
  using type = MemberOf<avo::Queue, double, std::optional<double>, std::vector<avo::Vec2>>;
};
template <>
struct MembersOf<avo::Follow> {
  using type = MemberOf<avo::Follow, double, std::vector<avo::Vec2>>;
};
template <>
struct MembersOf<avo::Patrol> {
  using type = MemberOf<avo::Patrol, double, std::vector<avo::Vec2>>;
};
template <>
struct MembersOf<avo::Flow> {
  using type = MemberOf<avo::Flow, double, std::vector<avo::Vec2>>;
};
template <>
struct MembersOf<Group> {
  using type = MemberOf<Group, int, double>;
};
template <>
struct MembersOf<RobotsFrom> {
  using type = MemberOf<RobotsFrom, std::string, int>;
};
template <>
struct MembersOf<PolylineObstacle> {
  using type = MemberOf<PolylineObstacle, std::vector<avo::Vec2>, avo::LayerSet>;
};
template <>
struct MembersOf<PolygonObstacle> {
  using type = MemberOf<PolygonObstacle, std::vector<avo::Vec2>, bool, avo::LayerSet>;
};
template <>
struct MembersOf<DiscObstacle> {
  using type = MemberOf<DiscObstacle, avo::LayerSet>;
};
template <>
struct MembersOf<WktObstacle> {
  using type = MemberOf<WktObstacle, avo::Fill, avo::LayerSet>;
};
template <>
struct MembersOf<WktFileObstacle> {
  using type = MemberOf<WktFileObstacle, std::string, avo::Fill, avo::LayerSet>;
};
template <>
struct MembersOf<GeojsonObstacle> {
  using type = MemberOf<GeojsonObstacle, std::string, avo::Fill, avo::LayerSet>;
};
template <>
struct MembersOf<MapObstacle> {
  using type = MemberOf<MapObstacle, std::string, double, avo::Vec2, avo::LayerSet>;
};
template <>
struct MembersOf<RosMapObstacle> {
  using type = MemberOf<RosMapObstacle, std::string, avo::LayerSet>;
};
template <>
struct MembersOf<RosMap> {
  using type = MemberOf<RosMap, std::string, double, RosMode>;
};
template <>
struct MembersOf<avo::Scenario> {
  using type = MemberOf<avo::Scenario, double, std::optional<double>, int, std::optional<int>,
                        std::uint64_t, std::string, avo::Method, std::optional<avo::Certificate>,
                        avo::Motion, bool, std::optional<bool>, avo::RightOfWay, avo::Clock>;
};
template <>
struct MembersOf<avo::SensingModel> {
  using type = MemberOf<avo::SensingModel, double, int, bool>;
};
template <>
struct MembersOf<avo::MeasurementNoise> {
  using type =
      MemberOf<avo::MeasurementNoise, double, std::optional<double>, avo::NoiseDistribution>;
};
template <>
struct MembersOf<avo::LocalizationNoise> {
  using type =
      MemberOf<avo::LocalizationNoise, double, std::optional<double>, avo::NoiseDistribution>;
};
template <>
struct MembersOf<avo::space::RobotSetup> {
  using type = MemberOf<avo::space::RobotSetup, double, std::optional<double>, avo::Vec3>;
};
template <>
struct MembersOf<avo::space::Quadrotor> {
  using type = MemberOf<avo::space::Quadrotor, double, std::optional<double>>;
};
template <>
struct MembersOf<avo::space::Scenario> {
  using type =
      MemberOf<avo::space::Scenario, double, std::optional<double>, std::optional<int>,
               std::uint64_t, std::string, bool, std::optional<avo::Certificate>, avo::Motion>;
};
template <>
struct MembersOf<SpaceGroup> {
  using type = MemberOf<SpaceGroup, int, double>;
};
template <>
struct MembersOf<SpherePlacement> {
  using type = MemberOf<SpherePlacement, double, avo::Vec3>;
};
template <>
struct MembersOf<BoxPlacement> {
  using type = MemberOf<BoxPlacement, double, avo::Vec3>;
};
template <>
struct MembersOf<SpaceGridPlacement> {
  using type = MemberOf<SpaceGridPlacement, double, int, avo::Vec3>;
};
template <>
struct MembersOf<SpaceBox> {
  using type = MemberOf<SpaceBox, double, avo::Vec3>;
};
template <>
struct MembersOf<SpaceOffset> {
  using type = MemberOf<SpaceOffset, avo::Vec3>;
};
template <class T>
using Member = typename MembersOf<T>::type;

enum class Need : std::uint8_t { required, optional };
inline constexpr Need kRequired = Need::required;
inline constexpr Need kOptional = Need::optional;

template <class T>
struct Field {
  std::string_view key;
  Member<T> member;
  Need need = Need::optional;
  avo::Range range = {};  ///< of numbers; of both components of points; of the byte counts of texts
  std::string_view unit;  ///< empty: none
  std::string_view doc;   ///< one line
  std::string_view default_text = "";  ///< if the default is not the struct's value
};

/// Fields with keys of their own; ranges of values that are not numbers; ranges of numbers of
/// robots.
inline constexpr std::monostate kNested;
inline constexpr avo::Range kLayer{0.0, 31.0, false};
inline constexpr avo::Range kNoNumber{};
inline constexpr avo::Range kNumber{1.0, static_cast<double>(avo::kMostRobots), false};

/// The fields of T, in the order of the documentation.
template <class T>
const std::vector<Field<T>>& fields();

/// The heading of a robot; a car has this key too.
struct HeadingField {
  std::string_view key, unit, doc;
  avo::Range range;
};
inline constexpr HeadingField kHeadingField{"heading", "rad", "counter-clockwise from +x",
                                            avo::kAngle};

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
inline const auto kMethods =
    by_name(avo::Method::avo, avo::Method::avo_paper, avo::Method::velocity_obstacle,
            avo::Method::orca, avo::Method::orca_clamped, avo::Method::reciprocal_velocity_obstacle,
            avo::Method::buffered_voronoi, avo::Method::external, avo::Method::external_clamped);
inline const auto kCertificates =
    by_name(avo::Certificate::none, avo::Certificate::braking_trajectories);
inline const auto kMotions = by_name(avo::Motion::held, avo::Motion::exponential);
inline const auto kClocks = by_name(avo::Clock::common, avo::Clock::free);
inline const auto kRightsOfWay = by_name(avo::RightOfWay::none, avo::RightOfWay::seen);
inline constexpr std::array<std::pair<std::string_view, avo::NoiseDistribution>, 2> kDistributions{
    {{"gaussian", avo::NoiseDistribution::gaussian}, {"uniform", avo::NoiseDistribution::uniform}}};
inline const auto kAccelerationSets =
    by_name(avo::AccelerationSet::incircle, avo::AccelerationSet::exact);

inline const auto kBehaviors =
    by_name(avo::Behavior::decides, avo::Behavior::cooperates, avo::Behavior::moves_on);
inline const auto kFormations =
    by_name(avo::Formation::line, avo::Formation::column, avo::Formation::wedge,
            avo::Formation::block, avo::Formation::ring);
inline const auto kAfterGoals = by_name(avo::AfterGoal::loiter, avo::AfterGoal::leave);

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

inline constexpr std::array<std::pair<std::string_view, avo::Fill>, 2> kFills{
    {{"solid", avo::Fill::solid}, {"bounds", avo::Fill::bounds}}};
inline constexpr std::array<std::pair<std::string_view, RosMode>, 3> kRosModes{
    {{"trinary", RosMode::trinary}, {"scale", RosMode::scale}, {"raw", RosMode::raw}}};

template <class T>
std::vector<std::string_view> keys_of(const std::vector<Field<T>>& table) {
  std::vector<std::string_view> keys;
  keys.reserve(table.size());
  for (const Field<T>& field : table) keys.push_back(field.key);
  return keys;
}

}  // namespace avo_io
