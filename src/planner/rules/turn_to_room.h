// SPDX-License-Identifier: Apache-2.0
// Rule 13 of docs/arrival.md, turn to where there is room. A robot at rest that turns before it
// drives turns to a direction in which the certificate admits a velocity.
#pragma once
#include "planner/stages/certifying.h"

namespace avo::inline planner {

/// Returns whether the robot turns before it drives, and nothing that others know of moves then.
bool turns_at_rest(const Robot& robot);

/// The choice of such a robot: what would be admitted once it has turned.
template <typename Trace>
CertifiedChoice choose_as_turned(const Certifying& decision, Vec2 wanted, Trace trace);

/// The admitted velocity nearest to `wanted`, one step towards the choice of Eq. (23). A car that
/// turns in place does not move, so anything is admitted. It would turn in vain towards a direction
/// in which it may not drive then, and back again, for ever.
template <typename Trace>
CertifiedChoice choose_admitted(const Certifying& decision, Vec2 wanted, Follows follows,
                                Trace trace);

}  // namespace avo::inline planner
