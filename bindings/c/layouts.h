// SPDX-License-Identifier: Apache-2.0
// Values with the same bytes in C and C++, so that columns are lent without a copy.
#pragma once
#include <bit>
#include <cstddef>
#include <type_traits>

#include "avo/execution.h"
#include "avo/planner.h"
#include "avo/simulation.h"
#include "avo/wall.h"
#include "avo_c/avo.h"

namespace avo_c {

template <typename C, typename Cpp>
inline constexpr bool kSameSize = sizeof(C) == sizeof(Cpp) &&
                                  alignof(C) == alignof(Cpp) && std::is_trivially_copyable_v<Cpp>;
#define AVO_SAME_PLACE(c, cpp, member) \
  static_assert(offsetof(c, member) == offsetof(cpp, member), #c "::" #member)

static_assert(kSameSize<avo_vec2, avo::Vec2>);
AVO_SAME_PLACE(avo_vec2, avo::Vec2, y);

static_assert(kSameSize<avo_timed_place, avo::TimedPlace>);
AVO_SAME_PLACE(avo_timed_place, avo::TimedPlace, position);

static_assert(kSameSize<avo_wall, avo::Wall>);
AVO_SAME_PLACE(avo_wall, avo::Wall, b);
AVO_SAME_PLACE(avo_wall, avo::Wall, radius);

static_assert(kSameSize<avo_detour, avo::Detour>);
AVO_SAME_PLACE(avo_detour, avo::Detour, beside);
AVO_SAME_PLACE(avo_detour, avo::Detour, congestion);
AVO_SAME_PLACE(avo_detour, avo::Detour, has_arrived);
AVO_SAME_PLACE(avo_detour, avo::Detour, goal_taken);
AVO_SAME_PLACE(avo_detour, avo::Detour, acceleration_x);
AVO_SAME_PLACE(avo_detour, avo::Detour, acceleration_y);

static_assert(kSameSize<avo_plan, avo::Plan>);
AVO_SAME_PLACE(avo_plan, avo::Plan, new_velocity);
AVO_SAME_PLACE(avo_plan, avo::Plan, next_velocity);
AVO_SAME_PLACE(avo_plan, avo::Plan, acceleration);
AVO_SAME_PLACE(avo_plan, avo::Plan, status);
AVO_SAME_PLACE(avo_plan, avo::Plan, state);
AVO_SAME_PLACE(avo_plan, avo::Plan, evading);
AVO_SAME_PLACE(avo_plan, avo::Plan, neighbor);
AVO_SAME_PLACE(avo_plan, avo::Plan, wall);
AVO_SAME_PLACE(avo_plan, avo::Plan, depth);
AVO_SAME_PLACE(avo_plan, avo::Plan, violation);

static_assert(kSameSize<avo_execution_model, avo::ExecutionModel>);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, time_constant_error);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, dead_time);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, dead_time_error);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, deadband);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, quantum);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, velocity_error);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, heading_age);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, measured_position_error);
AVO_SAME_PLACE(avo_execution_model, avo::ExecutionModel, measured_velocity_error);

static_assert(kSameSize<avo_base_command, avo::BaseCommand>);
AVO_SAME_PLACE(avo_base_command, avo::BaseCommand, next_reference);
AVO_SAME_PLACE(avo_base_command, avo::BaseCommand, next_velocity);
AVO_SAME_PLACE(avo_base_command, avo::BaseCommand, deviation);
AVO_SAME_PLACE(avo_base_command, avo::BaseCommand, has_left);

#undef AVO_SAME_PLACE

inline avo::ExecutionModel execution_of(const avo_execution_model& model) {
  return std::bit_cast<avo::ExecutionModel>(model);
}

// the numbers of words
template <typename Cpp>
constexpr bool is(int c, Cpp cpp) {
  return c == static_cast<int>(cpp);
}
static_assert(is(AVO_METHOD_EXTERNAL_CLAMPED, avo::Method::external_clamped));
static_assert(is(AVO_METHOD_EXTERNAL, avo::Method::external));
static_assert(is(AVO_METHOD_BUFFERED_VORONOI, avo::Method::buffered_voronoi));
static_assert(is(AVO_METHOD_RECIPROCAL_VELOCITY_OBSTACLE,
                 avo::Method::reciprocal_velocity_obstacle));
static_assert(is(AVO_METHOD_ORCA_CLAMPED, avo::Method::orca_clamped));
static_assert(is(AVO_METHOD_ORCA, avo::Method::orca));
static_assert(is(AVO_METHOD_VELOCITY_OBSTACLE, avo::Method::velocity_obstacle));
static_assert(is(AVO_METHOD_AVO_PAPER, avo::Method::avo_paper));
static_assert(is(AVO_CERTIFICATE_BRAKING_TRAJECTORIES, avo::Certificate::braking_trajectories));
static_assert(is(AVO_MOTION_EXPONENTIAL, avo::Motion::exponential));
static_assert(is(AVO_CLOCK_FREE, avo::Clock::free));
static_assert(is(AVO_RIGHT_OF_WAY_SEEN, avo::RightOfWay::seen));
static_assert(is(AVO_NOISE_UNIFORM, avo::NoiseDistribution::uniform));
static_assert(is(AVO_FILL_SOLID, avo::Fill::solid));
static_assert(is(AVO_FILL_BOUNDS, avo::Fill::bounds));
static_assert(is(AVO_BEHAVIOR_MOVES_ON, avo::Behavior::moves_on));
static_assert(is(AVO_BEHAVIOR_COOPERATES, avo::Behavior::cooperates));
static_assert(is(AVO_BEHAVIOR_PARKED, avo::Behavior::parked));
static_assert(is(AVO_ACCELERATION_SET_EXACT, avo::AccelerationSet::exact));
static_assert(is(AVO_AFTER_GOAL_LEAVE, avo::AfterGoal::leave));
static_assert(is(AVO_PLAN_LEAST_UNSAFE, avo::PlanStatus::least_unsafe));
static_assert(is(AVO_PLAN_REFUSED, avo::PlanStatus::refused));
static_assert(is(AVO_PLAN_BRAKING, avo::PlanStatus::braking));
static_assert(is(AVO_PLAN_OVERLAPPING, avo::PlanStatus::overlapping));
static_assert(is(AVO_PLAN_INVALID_INPUT, avo::PlanStatus::invalid_input));
static_assert(is(AVO_PLAN_DETOUR, avo::PlanStatus::detour));
static_assert(is(AVO_SAFETY_SAFE, avo::SafetyState::safe));
static_assert(is(AVO_SAFETY_DOOMED, avo::SafetyState::doomed));
static_assert(
    std::is_same_v<std::variant_alternative_t<AVO_MODEL_CAR, avo::MotionModel>, avo::Car>);
static_assert(
    std::is_same_v<std::variant_alternative_t<AVO_MODEL_DIFFERENTIAL_DRIVE, avo::MotionModel>,
                   avo::DifferentialDrive>);
static_assert(std::is_same_v<std::variant_alternative_t<AVO_MODEL_AIRPLANE, avo::MotionModel>,
                             avo::Airplane>);

}  // namespace avo_c
