// SPDX-License-Identifier: Apache-2.0
// What the two halves of the assumptions share: starts and sensing.
#pragma once
#include <optional>
#include <span>

#include "avo/assumptions.h"
#include "certificate/certificate.h"
#include "robots/motion.h"

namespace avo::inline sim {

struct WallNeeds;

/// What the robots of the scene that keep a certificate agree on.
CertificateLaw certificate_law(const Scenario& scenario);
/// Whether the robot is one of these; where nobody is, whether it would be.
inline bool keeps(const Scenario& scenario, const RobotSetup& robot, const CertificateLaw& law) {
  return law.kind == Certificate::none || certificate_of(scenario, robot) != Certificate::none;
}

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

/// Pairs of the scene's first robot alone, which keeps `margin` (m) besides.
void find_starts_of_first(const Scenario& scenario, const CertificateLaw& law, double margin,
                          BrokenAssumptions& result);

/// What the robot asks of a grid of walls in that state.
void include_start(const Scenario& scenario, const RobotSetup& robot, const MotionState& state,
                   const CertificateLaw& law, WallNeeds& needs);
/// Of these walls the one that the robot lacks most of, if it is too near any in that state;
/// WallStart::obstacle is the wall's index. A robot on its way may move otherwise than one that
/// starts: the disc of a drive moves off its heading.
std::optional<WallStart> worst_wall(const Scenario& scenario, int robot, const MotionState& state,
                                    std::span<const Wall> walls, const CertificateLaw& law);
/// Whether the obstacle's Fill lets a robot be there.
bool leaves_room(Vec2 p, const StaticObstacle& obstacle);

/// Robots in these states beside static obstacles, in solids and out of bounds: `states` has one
/// for each robot of the scene.
void find_wall_starts(const Scenario& scenario, std::span<const MotionState> states,
                      const CertificateLaw& law, BrokenAssumptions& result);

/// Whether not everybody avoids everybody, or not all by one method.
bool is_mixed(const Scenario& scenario);

/// As if the scene had the certificate braking_trajectories, whatever it has.
std::optional<SensingNeed> sensing_need(const Scenario& scenario, const CertificateLaw& law);

/// How many others within the radius, m, a robot has at the start, in the mean of a sample.
double mean_neighbors(const Scenario& scenario, double radius);

bool suffices(double sensing_radius, const std::optional<SensingNeed>& needed);

/// What separates a broken start from the rounding of decimal fractions, of the length or speed.
inline constexpr double kStartTolerance = 1e-9;

inline bool exceeds(double speed, double max_speed) {
  return speed > (1.0 + kStartTolerance) * max_speed;
}

}  // namespace avo::inline sim
