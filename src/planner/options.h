// SPDX-License-Identifier: Apache-2.0
// The options of a planner.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "avo/scenario.h"
#include "avo/teams.h"

namespace avo::inline planner {

/// The names of the values of an enum in scene files, in their order. The template is hidden
/// explicitly: the instances of public enums would be exported.
template <typename Choice>
AVO_LOCAL inline constexpr std::array<const char*, 0> kNames{};
template <>
AVO_LOCAL inline constexpr std::array kNames<Method>{"avo",
                                                     "avo_paper",
                                                     "velocity_obstacle",
                                                     "orca",
                                                     "orca_clamped",
                                                     "reciprocal_velocity_obstacle",
                                                     "buffered_voronoi",
                                                     "external",
                                                     "external_clamped"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Certificate>{"none", "unknown",
                                                          "braking_trajectories"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Motion>{"held", "exponential"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Clock>{"common", "free"};
template <>
AVO_LOCAL inline constexpr std::array kNames<RightOfWay>{"none", "seen"};
template <>
AVO_LOCAL inline constexpr std::array kNames<NoiseDistribution>{"gaussian", "uniform"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Behavior>{"decides", "moves_on", "cooperates",
                                                       "parked"};
template <>
AVO_LOCAL inline constexpr std::array kNames<PlanStatus>{
    "optimal", "least_unsafe", "refused", "braking", "overlapping", "invalid_input", "detour"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Guide>{"route", "lane",  "passage", "back",
                                                    "mover", "place", "host"};
template <>
AVO_LOCAL inline constexpr std::array kNames<WishRule>{
    "none", "steers", "keeps_right", "yields", "settles", "leaves_wall", "in_cell"};
template <>
AVO_LOCAL inline constexpr std::array kNames<Formation>{"line", "column", "wedge", "block", "ring"};
template <>
AVO_LOCAL inline constexpr std::array kNames<SafetyState>{"unknown", "safe", "doomed"};

/// Returns whether a certificate may refuse what the method proposes, and rule 3 then turns it.
constexpr bool goes_through_certificate(const PlannerOptions& options) {
  return method_traits(options.method).has_rules || options.certificate != Certificate::none;
}

/// The key in scene files of an enum of which values were removed.
template <typename Choice>
AVO_LOCAL inline constexpr std::string_view kKey{};
template <>
AVO_LOCAL inline constexpr std::string_view kKey<Certificate>{"certificate"};
template <>
AVO_LOCAL inline constexpr std::string_view kKey<RightOfWay>{"right_of_way"};

template <typename Choice>
const char* name_of(Choice choice) {
  const auto number = static_cast<std::size_t>(choice);
  return number < kNames<Choice>.size() ? kNames<Choice>[number] : "unknown";
}

/// Throws Error naming the first option out of range, with the prefix.
void validate(const PlannerOptions& options, const std::string& prefix);

}  // namespace avo::inline planner
