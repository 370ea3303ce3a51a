// SPDX-License-Identifier: Apache-2.0
// What the two halves of the assumptions share: starts and sensing.
#pragma once
#include <span>

#include "avo/assumptions.h"
#include "certificate/certificate.h"
#include "robots/motion.h"

namespace avo {

/// What the robots of the scene agree on.
CertificateLaw certificate_law(const Scenario& scenario);

/// That of a robot, which may have a time step of its own.
StepLaw step_law(const Scenario& scenario, const RobotSetup& robot, const CertificateLaw& law);

/// s: where clocks are free, the longest step of anybody's braking; else 0.
double longest_first_step(const CertificateLaw& law);

/// m: the first step of a robot that starts in motion may then be a short one, with which it stops
/// at most so much farther.
double late_phase(const RobotSetup& robot, double longest_step);

/// m, from where the robot starts to where it would stop.
Vec2 way_to_rest(const RobotSetup& robot, const CertificateLaw& law);

/// The state in which a robot of that setup starts.
MotionState start_of(const RobotSetup& robot);

/// Robots in these states beside static obstacles, in solids and out of bounds: `states` has one
/// for each robot of the scene. A robot on its way may move otherwise than one that starts: the
/// disc of a drive moves off its heading.
void find_wall_starts(const Scenario& scenario, std::span<const MotionState> states,
                      const CertificateLaw& law, BrokenAssumptions& result);

/// Whether not everybody avoids everybody.
bool is_layered(const Scenario& scenario);

bool suffices(double sensing_radius, const std::optional<SensingNeed>& needed);

/// What separates a broken start from the rounding of decimal fractions, of the length or speed.
inline constexpr double kStartTolerance = 1e-9;

inline bool exceeds(double speed, double max_speed) {
  return speed > (1.0 + kStartTolerance) * max_speed;
}

}  // namespace avo
