// SPDX-License-Identifier: Apache-2.0
// The common part of the two halves of the assumptions: starts and sensing.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "avo/assumptions.h"
#include "certificate/certificate.h"
#include "guidance/wall_needs.h"
#include "robots/motion.h"

namespace avo::inline sim {

/// What a list of a scene has for that id. The lists of scenes are numbered by ids.
template <typename Listed, typename Id>
const Listed& listed_as(Id id, const std::vector<Listed>& list) {
  return list[static_cast<std::size_t>(id.value)];
}

/// The constants that the scene's robots with a certificate share.
CertificateLaw certificate_law(const Scenario& scenario);
/// Returns whether the robot keeps the certificate; where no robot does, whether it would. A parked
/// robot decides nothing, so it keeps none.
inline bool keeps(const Scenario& scenario, const RobotSetup& robot, const CertificateLaw& law) {
  if (is_parked(robot)) return false;
  return law.kind == Certificate::none || certificate_of(scenario, robot) != Certificate::none;
}

/// The law of one robot, which may have a time step of its own.
StepLaw step_law(const Scenario& scenario, const RobotSetup& robot, const CertificateLaw& law);

/// s: where clocks are free, the longest braking step of any robot; else 0.
double longest_first_step(const CertificateLaw& law);

/// m: the first step of a robot that starts in motion may then be short; this is how much farther
/// the robot then stops at most.
double late_phase(const RobotSetup& robot, double longest_step);

/// m, the displacement from the robot's start to where it would stop.
Vec2 vector_to_rest(const RobotSetup& robot, const CertificateLaw& law);

/// The start state of a robot of that setup.
MotionState start_of(const RobotSetup& robot);

/// Finds the pairs that the certificate cannot keep apart.
void find_broken_starts(const Scenario& scenario, const CertificateLaw& law,
                        BrokenAssumptions& result);
/// Finds the pairs of the scene's first robot alone, which also keeps `margin` (m).
void find_starts_of_first(const Scenario& scenario, const CertificateLaw& law, double margin,
                          BrokenAssumptions& result);

/// Includes the robot's demands on a grid of walls in that state.
void include_start(const Scenario& scenario, const RobotSetup& robot, const MotionState& state,
                   const CertificateLaw& law, WallNeeds& needs);
/// The wall to which the robot is too near by most in that state, if it is too near to any.
/// WallStart::obstacle is the position of the wall in `walls`. A robot in motion may move
/// differently from a robot that starts: the disc of a drive moves off its heading.
std::optional<WallStart> worst_wall(const Scenario& scenario, RobotId robot,
                                    const MotionState& state, std::span<const Wall> walls,
                                    const CertificateLaw& law);
/// Returns whether the obstacle's Fill lets any robot be there.
bool leaves_room(Vec2 p, const StaticObstacle& obstacle);
/// The same for a robot that may not heed the obstacle.
inline bool leaves_room(const RobotSetup& robot, Vec2 p, const StaticObstacle& obstacle) {
  return !heeds(robot.layers, obstacle) || leaves_room(p, obstacle);
}

/// Finds the robots in these states that break assumptions beside static obstacles, in solids and
/// out of bounds. `states` has one entry for each robot of the scene.
void find_wall_starts(const Scenario& scenario, std::span<const MotionState> states,
                      const CertificateLaw& law, BrokenAssumptions& result);

/// Returns whether some robot does not avoid another, or the robots have several methods.
bool is_mixed(const Scenario& scenario);

/// The need of a scene with the certificate braking_trajectories, whatever certificate it has.
std::optional<SensingNeed> sensing_need(const Scenario& scenario, const CertificateLaw& law);

/// The mean number of others within the radius, m, of a robot at the start, over a sample.
double mean_neighbors(const Scenario& scenario, double radius);

bool suffices(double sensing_radius, const std::optional<SensingNeed>& needed);

/// The relative tolerance of a length or speed that separates a broken start from the rounding of
/// decimal fractions.
inline constexpr double kStartTolerance = 1e-9;

inline bool exceeds(double speed, double max_speed) {
  return speed > (1.0 + kStartTolerance) * max_speed;
}

}  // namespace avo::inline sim
