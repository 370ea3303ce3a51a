// SPDX-License-Identifier: Apache-2.0
// One robot's certificate for one decision: the constraints that its decision must keep.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "certificate/braking_trajectories.h"
#include "certificate/discs.h"
#include "certificate/fallback_areas.h"
#include "certificate/wall_constraints.h"
#include "core/neighbor_columns.h"

namespace avo::inline certificate {

/// The constants that all robots must share.
struct CertificateLaw {
  Certificate kind = Certificate::braking_trajectories;
  StepLaw step;
};

/// The demands of neighbors and walls on a robot. Scratch memory; allocates only while it grows.
struct CertificateConstraints {
  Invariant invariant;
  TrajectoryConstraints trajectories;
  std::vector<LoiterLine> loiterers;
  WallConstraints walls;           ///< by begin_walls_of()
  FootprintConstraints footprint;  ///< of a robot with a footprint: in place of those above
  CandidatePath path;              ///< of the last tested candidate
  NearPairs near;                  ///< of all robots that find_near() was given
  // of a robot that is planned alone
  RobotColumns alone;
  NeighborColumns seen;

  bool demand_nothing() const {
    return trajectories.columns.count == 0 && trajectories.waiting.empty() && loiterers.empty() &&
           walls.near.empty() && !invariant.unknown && !invariant.touched && footprint.count == 0;
  }
};

/// Reserves room for the constraints of so many neighbors, each of which brakes for so many steps.
void reserve_constraints(std::size_t neighbors, std::size_t braking_steps,
                         std::size_t most_constraints, CertificateConstraints& constraints);

/// Computes for many robots in lanes what begin_constraints() needs for each of them.
void find_near(const RobotColumns& robots, const CertificateLaw& law,
               CertificateConstraints& constraints);

/// Begins the constraints of the neighbors of robot i, an index into the robots that find_near()
/// was last given. admits() collects the constraints that may refuse a candidate. Its walls come
/// from begin_walls_of(), which must come first.
void begin_constraints(const Robot& robot, const Neighbors& neighbors, std::size_t i,
                       const CertificateLaw& law, CertificateConstraints& constraints);
/// Begins the constraints of the walls near a robot, or near its discs.
void begin_walls_of(const Robot& robot, std::span<const Wall> walls, const CertificateLaw& law,
                    CertificateConstraints& constraints);
/// Collects all constraints of one robot that is planned alone.
void collect_constraints(const Robot& robot, std::span<const Neighbor> neighbors,
                         const CertificateLaw& law, CertificateConstraints& constraints,
                         std::span<const Wall> walls = {});

/// Returns whether the robot may have the velocity v_1 after this step. It is true for
/// backup_velocity() wherever the invariant holds, up to rounding. Cuts need all constraints to be
/// asked.
bool admits(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
            CertificateConstraints& constraints, Asked asked_for = Asked::until_refused);

/// [v_1] of the decision that is always allowed: full braking.
Vec2 backup_velocity(const Robot& robot, const CertificateLaw& law);

/// Lists all constraints for inspection (see CertificateConstraint in avo/planner.h).
void list_constraints(const CertificateConstraints& constraints, Vec2 position,
                      std::vector<CertificateConstraint>& list);

}  // namespace avo::inline certificate
