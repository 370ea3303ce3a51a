// SPDX-License-Identifier: Apache-2.0
// The body with which a robot is in contact, and apparent contact by rounding: docs/on_board.md,
// "Contact".
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// A body that a robot touches, or comes to touch while all fall back.
struct Contact {
  int neighbor = -1, wall = -1;  // index of one of them, or none
  double depth = 0.0;            // m, with the possible errors subtracted
  bool is_certain = false;       // it is deeper than rounding may cause
};

/// The deepest contact of the bodies that the robot touches now, and of the neighbor and the wall
/// that its fallback comes to touch. Among them it selects the constraint that exceeds rounding
/// most. It tests all neighbors: only for the rare robot with a suspected contact.
Contact deepest_contact(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                        const StepLaw& law, const Deepest& neighbor = {}, const Deepest& wall = {});
Contact deepest_contact(const Robot& robot, std::span<const Neighbor> neighbors,
                        std::span<const Wall> walls, const StepLaw& law,
                        const Deepest& neighbor = {}, const Deepest& wall = {});

/// m: the largest depth of a contact with the wall that rounding may cause.
double feigned(const Robot& robot, const Wall& wall, const StepLaw& law);

/// Writes the contact into the plan if it is certain.
void tell(const Contact& contact, Plan& plan);

/// Index of the neighbor in the given list, of those after that index; -1 if it is not there.
int index_in(std::span<const Neighbor> given, const Neighbor& neighbor, int after = -1);

}  // namespace avo::inline planner
