// SPDX-License-Identifier: Apache-2.0
// The methods by which robots choose new velocities, and what distinguishes them. SI units.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "avo/export.h"

namespace avo {

/// How new velocities are chosen.
enum class Method : std::uint8_t {
  avo,                ///< the paper's half-planes, a certificate, and rules for arriving
  avo_paper,          ///< the paper alone: acceleration-velocity obstacles, reciprocal half-planes
  velocity_obstacle,  ///< the paper's §III-A: others keep their velocity, v' is adopted at once
  orca,               ///< the limit δ -> 0, δ a_max -> infinity: v' is adopted at once
  /// orca's choice, of which the velocity takes the part that a_max allows within a step
  orca_clamped,
  reciprocal_velocity_obstacle,  ///< velocity obstacles with their apex between v_A and v_B
  buffered_voronoi,              ///< the robot's Voronoi cell less its radius, braking within it
  external,  ///< v' is the preferred velocity, which another planner chose; it is adopted at once
  /// external's choice, of which the velocity takes the part that a_max allows within a step
  external_clamped,
};

/// What no decision may break, whatever the half-planes ask for (docs/certificate.md).
enum class Certificate : std::uint8_t {
  none = 0,
  // 1 was a certificate of earlier versions
  braking_trajectories = 2,  ///< the places of braking robots are disjoint at every time
};

/// Returns the name that scene files use.
AVO_API const char* to_string(Method method);
AVO_API const char* to_string(Certificate certificate);

/// What distinguishes a method, and its usual options: by default those of the paper (§VI-A).
struct MethodTraits {
  Method method = Method::avo;
  bool has_rules = false;       ///< rules shape what the robot wants
  bool lags = false;            ///< v' is approached with the lag of Eq. (7)
  bool adopts_at_once = false;  ///< there is no acceleration limit and no δ
  bool clamps = false;  ///< of its choice the velocity takes the part that a_max allows in a step
  bool stays_in_cell = false;  ///< the robot keeps to its Voronoi cell, in place of half-planes
  bool avoids_union = false;  ///< it chooses outside the union of all neighbors' obstacles (§III-A)
  bool is_external = false;   ///< another planner chooses the velocity (avo/external_method.h)
  bool is_reciprocal = false;  ///< the apexes of obstacles lie between v_A and v_B
  double control_time = 4.0;   ///< [δ] s
  double time_horizon = 10.0;  ///< [τ] s
  double response_time = 0.0;  ///< [κ] in units of T = v_max/a_max
  Certificate certificate = Certificate::none;
};

/// One row for each method, in the order of Method.
inline constexpr std::array<MethodTraits, 9> kMethodTraits{{
    {.method = Method::avo,
     .has_rules = true,
     .control_time = 2.0,
     .time_horizon = 3.0,
     .response_time = 0.1,
     .certificate = Certificate::braking_trajectories},
    {.method = Method::avo_paper, .lags = true},
    {.method = Method::velocity_obstacle, .adopts_at_once = true, .avoids_union = true},
    {.method = Method::orca, .adopts_at_once = true},
    {.method = Method::orca_clamped, .clamps = true},
    {.method = Method::reciprocal_velocity_obstacle,
     .adopts_at_once = true,
     .avoids_union = true,
     .is_reciprocal = true},
    {.method = Method::buffered_voronoi, .stays_in_cell = true},
    {.method = Method::external, .adopts_at_once = true, .is_external = true},
    {.method = Method::external_clamped, .clamps = true, .is_external = true},
}};

/// Returns the row of the method.
constexpr const MethodTraits& method_traits(Method method) {
  return kMethodTraits[static_cast<std::size_t>(method)];
}

/// Returns whether the method has no acceleration limit and no δ: v' is adopted at once.
constexpr bool adopts_at_once(Method method) {
  return method_traits(method).adopts_at_once;
}

/// Returns whether v' keeps a_max and is reached at the end of the step: δ is Δt.
constexpr bool reaches_within_step(Method method) {
  return method_traits(method).clamps || method_traits(method).stays_in_cell;
}

/// Returns whether another planner chooses the velocity.
constexpr bool is_external(Method method) {
  return method_traits(method).is_external;
}

/// Returns whether a certificate may be behind the method: it then admits the method's choice, or
/// replaces it by the nearest velocity that it admits.
constexpr bool may_be_certified(Method method) {
  return method_traits(method).has_rules || reaches_within_step(method);
}

/// Returns whether the method chooses a velocity without regard to the acceleration that it takes.
constexpr bool disregards_acceleration(Method method) {
  return method_traits(method).adopts_at_once || method_traits(method).clamps;
}

/// Returns whether the method chooses outside the union of all neighbors' obstacles (§III-A).
constexpr bool avoids_union(Method method) {
  return method_traits(method).avoids_union;
}

/// The usual options of a method.
constexpr double usual_control_time(Method method) {
  return method_traits(method).control_time;
}
constexpr double usual_time_horizon(Method method) {
  return method_traits(method).time_horizon;
}
constexpr double usual_response_time(Method method) {
  return method_traits(method).response_time;
}
constexpr Certificate usual_certificate(Method method) {
  return method_traits(method).certificate;
}

}  // namespace avo
