// SPDX-License-Identifier: Apache-2.0
// Contact that no motion within the limits avoids, with one other body or one wall: docs/states.md.
#pragma once
#include <optional>

#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/pair.h"

namespace avo::inline certificate {

/// s: a time at which A is in contact with the neighbor, for any motion of A within |a| <= c_A and
/// |v| <= v_A^max. A neighbor that decides may move in any manner within its own c, see
/// change_limit(); any other neighbor keeps its acceleration. The result is none where that is not
/// proved. The errors of the law are allowed for, and the neighbor's age.
std::optional<double> inevitable_contact(const Robot& robot, const Neighbor& neighbor,
                                         const StepLaw& law);

/// s: a time by which A has been in contact with the wall, for any motion of A within its limits.
std::optional<double> inevitable_contact(const Robot& robot, const Wall& wall);

}  // namespace avo::inline certificate
