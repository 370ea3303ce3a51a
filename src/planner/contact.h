// SPDX-License-Identifier: Apache-2.0
// With whom a robot is in contact, and what only looks like it: docs/on_board.md, "Contact".
#pragma once
#include <span>

#include "avo/planner.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"
#include "core/neighbor_columns.h"

namespace avo::inline planner {

/// One that a robot touches, or comes to touch while all fall back.
struct Contact {
  int neighbor = -1, wall = -1;  // one of them, or none
  double depth = 0.0;            // m, more than the declared errors may hide
  bool is_certain = false;       // it is deeper than rounding may feign
};

/// The deepest of those that the robot touches now, of the neighbor and the wall that its fallback
/// comes to touch, and of all of them what rounding feigns least. Looks at everybody: for the rare
/// robot of which a contact is suspected.
Contact deepest_contact(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                        const StepLaw& law, const Deepest& neighbor = {}, const Deepest& wall = {});
Contact deepest_contact(const Robot& robot, std::span<const Neighbor> neighbors,
                        std::span<const Wall> walls, const StepLaw& law,
                        const Deepest& neighbor = {}, const Deepest& wall = {});

/// m: no deeper a contact with the wall may be that is none but for rounding.
double feigned(const Robot& robot, const Wall& wall, const StepLaw& law);

/// The plan says so if the contact is certain.
void tell(const Contact& contact, Plan& plan);

/// Index of the neighbor in the list that it is from.
int index_in(std::span<const Neighbor> given, const Neighbor& neighbor);

}  // namespace avo::inline planner
