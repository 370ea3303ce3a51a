// SPDX-License-Identifier: Apache-2.0
// The velocity nearest the preferred one that a certificate admits: the program's own choice where
// that is admitted, else one found by cutting off what is refused.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "certificate/braking_trajectories.h"
#include "lp/linear_program.h"

namespace avo {

enum class Chosen : std::uint8_t {
  program,    ///< the program's choice was admitted as it was
  candidate,  ///< another one, admitted
  braking,    ///< none but braking
};

struct CertifiedChoice {
  Vec2 velocity;  ///< [v'_A] m/s
  Chosen chosen = Chosen::program;
  bool discs_disjoint = false;
};

/// Scratch memory; allocates only while it grows.
struct CertifiedWorkspace {
  TrajectoryWalls walls;
  CandidatePath path;
  std::vector<HalfPlane> cuts, projected;
};

/// What the choice is made from.
struct CertifiedProgram {
  const Robot& robot;
  StepLaw law;
  double rate;  ///< the part of v' - v that a step turns into velocity
  std::span<const HalfPlane> soft;
  Disc acceleration, speed;
  Vec2 braking;  ///< [v'] of full braking
};

/// Nearest to `preferred`; workspace.walls hold the walls of the robot.
CertifiedChoice choose_certified(const CertifiedProgram& program, Vec2 preferred,
                                 CertifiedWorkspace& workspace);

}  // namespace avo
