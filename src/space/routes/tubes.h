// SPDX-License-Identifier: Apache-2.0
// Slots between two faces of boxes, and tubes between four: windows, doors and shafts
// (docs/space.md, "Routes and passages").
#pragma once
#include <span>
#include <vector>

#include "avo/vec3.h"
#include "space/routes/solids.h"

namespace avo::space {

/// The middle plane between two faces that look at each other, as far as both reach.
struct Slot {
  Vec3 middle;            ///< m, on the plane; its coordinates without bounds are 0
  Vec3 normal;            ///< unit, from face to face
  Vec3 along_1, along_2;  ///< unit, in the plane
  double low_1 = 0.0, high_1 = 0.0, low_2 = 0.0, high_2 = 0.0;  ///< m, from the middle
};

/// All slots of that width, m.
std::vector<Slot> find_slots(const Solids& solids, double narrowest, double widest);

struct Tube {
  Vec3 begin;                         ///< m, on the axis, where its faces begin
  Vec3 axis;                          ///< unit
  double length = 0.0;                ///< m; 0 between walls without thickness
  Vec3 across_1, across_2;            ///< unit, at right angles to its faces
  double half_1 = 0.0, half_2 = 0.0;  ///< m, from the axis to the faces
};

/// All tubes with sides at least `narrowest` and at most `widest` m apart, in the order of the
/// boxes.
std::vector<Tube> find_tubes(const Solids& solids, double narrowest, double widest);

}  // namespace avo::space
