// SPDX-License-Identifier: Apache-2.0
// The next velocity nearest to a wanted velocity that the certificate admits.
#pragma once
#include <cstdint>
#include <vector>

#include "certificate/certificate.h"
#include "lp/linear_program.h"
#include "planner/trace.h"

namespace avo::inline planner {

/// Covers rounding of a squared value within the limits.
inline constexpr double kLimitRounding = 1.0 + 0x1p-49;

enum class Chosen : std::uint8_t {
  wanted,     ///< the wanted velocity was admitted
  candidate,  ///< another velocity, admitted
  backup,     ///< nothing but braking was admitted
  detour,     ///< the wanted velocity off the route was admitted; only certify() says so
};

struct CertifiedChoice {
  Vec2 next_velocity;  ///< [v_1] m/s, after the step
  Chosen chosen = Chosen::wanted;
};

/// Scratch memory; allocates only while it grows.
struct CertifiedWorkspace {
  CertificateConstraints constraints;
  std::vector<HalfPlane> hard;
  ProgramRows rows;  // of programs
};

/// Whether the robot's model is known to follow a velocity: surely if within_own_limits() returned
/// it.
enum class Follows : std::uint8_t { perhaps, surely };

/// The velocity nearest to `wanted` with |v_1 - v| <= u and |v_1| <= v_max, as far as a few linear
/// programs find it. It is always admitted, or the backup. workspace.constraints are the robot's.
/// trace.is_refused() tells why the wanted velocity was not admitted.
template <typename Trace = NoTrace>
CertifiedChoice choose_certified(const Robot& robot, Vec2 wanted, const CertificateLaw& law,
                                 CertifiedWorkspace& workspace, Follows follows = Follows::perhaps,
                                 Trace trace = {});

/// Returns whether choose_certified() could choose the part of that velocity that the robot
/// follows.
bool may_choose(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
                CertifiedWorkspace& workspace);

}  // namespace avo::inline planner
