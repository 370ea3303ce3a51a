// SPDX-License-Identifier: Apache-2.0
// What moving obstacles demand of a robot of space: at rest, or never begun to move, when one of
// them touches it (docs/certificate/movers.md, word for word with balls for discs).
#pragma once
#include <span>

#include "avo/space/mover.h"
#include "avo/space/robot.h"
#include "certificate/pair.h"
#include "space/kernels.h"

namespace avo::space {

/// The constraints of all moving obstacles. Scratch memory; allocates only while it grows.
struct MoverConstraints {
  ConstraintColumns columns;  ///< the constraints of one moving obstacle are consecutive
  OwnColumns own_columns;
  Invariant invariant;
  bool stays_at_rest = false;  ///< so near a moving obstacle that it may not begin to move
  bool has_cones = false;
  bool counts = false;  ///< whether candidates are tested beside moving obstacles

  void clear();

  /// Returns whether a path that moves in so many intervals is refused whatever it is.
  [[nodiscard]] bool must_rest(int moving) const {
    return moving > 0 && (stays_at_rest || invariant.touched || invariant.unknown);
  }
};

/// The error of the given state of a moving obstacle, see avo::error_against().
SensingError error_against(const Mover& mover, const StepLaw& law);

/// m: how far a parabola is from a path of the law's kind with the same ends, within a step.
double parabola_error(const Mover& mover, const StepLaw& law);

/// own, deviation: of the robot, see space::Constraints.
void begin_movers(const Robot& robot, std::span<const Mover> movers, const Braking& own,
                  Vec3 own_direction, const Deviation& deviation, const StepLaw& law,
                  MoverConstraints& constraints);

}  // namespace avo::space
