// SPDX-License-Identifier: Apache-2.0
// The next velocity nearest to a wanted one that the certificate admits.
#pragma once
#include <cstdint>
#include <vector>

#include "certificate/certificate.h"
#include "lp/linear_program.h"

namespace avo::inline planner {

/// Covers rounding of what is within the limits, squared.
inline constexpr double kLimitRounding = 1.0 + 0x1p-49;

enum class Chosen : std::uint8_t {
  wanted,     ///< it was admitted as it was
  candidate,  ///< another one, admitted
  backup,     ///< none but braking
};

struct CertifiedChoice {
  Vec2 next_velocity;  ///< [v_1] m/s, after the step
  Chosen chosen = Chosen::wanted;
};

/// A neighbor is cut off by so many half-planes at most.
inline constexpr std::size_t kMostCuts = 6;

/// Scratch memory; allocates only while it grows.
struct CertifiedWorkspace {
  CertificateConstraints constraints;
  std::vector<HalfPlane> hard;
  ProgramRows rows;  // of programs
};

/// Whether the robot's model is known to follow a velocity: within_own_limits() returned it.
enum class Follows : std::uint8_t { perhaps, surely };

/// Nearest to `wanted` with |v_1 - v| <= u and |v_1| <= v_max, as far as a few linear programs
/// tell; always admitted, or the backup. workspace.constraints are the robot's.
CertifiedChoice choose_certified(const Robot& robot, Vec2 wanted, const CertificateLaw& law,
                                 CertifiedWorkspace& workspace, Follows follows = Follows::perhaps);

/// Whether choose_certified() could choose what the robot follows of that velocity.
bool may_choose(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
                CertifiedWorkspace& workspace);

}  // namespace avo::inline planner
