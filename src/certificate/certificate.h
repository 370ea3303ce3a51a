// SPDX-License-Identifier: Apache-2.0
// One robot's certificate for one decision, of any kind: what it must keep to, whatever it wants.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "certificate/braking_trajectories.h"
#include "certificate/stopping_capsules.h"
#include "certificate/wall_constraints.h"
#include "core/neighbor_columns.h"

namespace avo::inline certificate {

/// What all robots have to agree on.
struct CertificateLaw {
  Certificate kind = Certificate::braking_trajectories;
  StepLaw step;
};

/// What neighbors and walls demand of a robot. Scratch memory; allocates only while it grows.
struct CertificateConstraints {
  Invariant invariant;
  TrajectoryConstraints
      trajectories;  ///< braking_trajectories; of movers also for stopping_capsules
  std::vector<CapsuleConstraint> capsules;  ///< stopping_capsules; of all that loiter
  WallConstraints walls;                    ///< by begin_walls()
  CandidatePath path;                       ///< of the last candidate asked about
  NearPairs near;                           ///< of all robots of find_near()
  // of a robot that is looked at by itself
  RobotColumns alone;
  NeighborColumns seen;

  bool demand_nothing() const {
    return trajectories.columns.count == 0 && trajectories.waiting.empty() && capsules.empty() &&
           walls.near.empty() && !invariant.unknown && !invariant.touched;
  }
};

/// Room for the constraints of so many neighbors, each of which brakes for so many steps.
void reserve_constraints(std::size_t neighbors, std::size_t braking_steps,
                         std::size_t most_constraints, CertificateConstraints& constraints);

/// Of robots in lanes what begin_constraints() asks, before it is asked of each of them.
void find_near(const RobotColumns& robots, const CertificateLaw& law,
               CertificateConstraints& constraints);

/// Those of the neighbors of robot i of the robots that find_near() was given last; admits()
/// collects what a candidate may be refused by. Its walls are what begin_walls() made of them.
void begin_constraints(const Robot& robot, const Neighbors& neighbors, std::size_t i,
                       const CertificateLaw& law, CertificateConstraints& constraints);
/// All of those of one robot, looked at by itself.
void collect_constraints(const Robot& robot, std::span<const Neighbor> neighbors,
                         const CertificateLaw& law, CertificateConstraints& constraints,
                         std::span<const Wall> walls = {});

/// Whether the robot may have the velocity v_1 after this step. True of backup_velocity() wherever
/// the invariant holds, up to rounding. Cuts need all constraints asked.
bool admits(const Robot& robot, Vec2 next_velocity, const CertificateLaw& law,
            CertificateConstraints& constraints, Asked asked_for = Asked::until_refused);

/// [v_1] of what is always allowed: full braking.
Vec2 backup_velocity(const Robot& robot, const CertificateLaw& law);

/// All constraints, for those who want to look at them (see CertificateConstraint in
/// avo/planner.h).
void list_constraints(const CertificateConstraints& constraints, Vec2 position,
                      std::vector<CertificateConstraint>& list);

}  // namespace avo::inline certificate
