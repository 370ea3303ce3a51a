// SPDX-License-Identifier: Apache-2.0
// Phrases of decisions that are the same in the plane and in space.
#pragma once
#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "guidance/names.h"

namespace avo::inline guidance {

inline constexpr double kResting = 0.01;      // of v_max: a slower robot is at rest
inline constexpr double kLittleGain = 0.002;  // of the speed, in a step: not worth a word
inline constexpr double kLittleTurn = 0.004;  // rad, in a step: not worth a word
inline constexpr double kAsPreferred = 1e-6;  // m/s

/// E.g. "robot 7, which is inside".
Words goes_first(const Words& whom, bool inside);
/// What the rule does; nothing of rules that need no word.
Words does(WishRule rule, const Words& whom);
/// The certificate has refused what the robot wants, or its detour.
Words refused(PlanStatus status, const Words& whom, bool is_off);
/// No velocity keeps to all half-planes, which have that name. violation: m/s.
Words misses(double violation, const Words& whom, const Words& half_planes, bool is_certified);
/// E.g. "the half-plane of robot 7 binds".
Words binds(const Words& whom, bool are_several, const Words& half_plane);
/// A robot off its route by that angle, or nearly off.
Words is_on_detour(double radians, const Words& whom, bool is_refused, const Words& half_planes);
Words evades(const Words& whom, bool brakes);
/// An empty name is an unknown one.
Words is_in_contact(const Words& whom);
/// Nothing limits the robot. has_it: it has the velocity that it prefers.
Words is_free(bool has_it);
/// It is as near to its goal as walls, or other obstacles of that name, let it come. m: left.
Words is_kept_from_goal(const Words& walls, double left);
extern const char* const kInvalidInput;

/// Appends the words to a reason.
void add_words(const Words& words, Words& reason);

}  // namespace avo::inline guidance
