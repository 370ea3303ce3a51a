// SPDX-License-Identifier: Apache-2.0
// Contact that nothing within the limits avoids, with one other or one wall: docs/states.md.
#pragma once
#include <optional>

#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/pair.h"

namespace avo::inline certificate {

/// s: a time at which A is in contact with the neighbor whatever it does within |a| <= c_A and
/// |v| <= v_A^max, and whatever the neighbor does within its own c, see change_limit(), if it
/// decides; if it does not,
/// it keeps its acceleration. Nothing where that is not proved. The errors of the law are allowed
/// for, and the neighbor's age.
std::optional<double> inevitable_contact(const Robot& robot, const Neighbor& neighbor,
                                         const StepLaw& law);

/// s: a time by which A has been in contact with the wall, likewise.
std::optional<double> inevitable_contact(const Robot& robot, const Wall& wall);

}  // namespace avo::inline certificate
