// SPDX-License-Identifier: Apache-2.0
// Rule 3 of docs/arrival.md, back out of a jam: where the route is blocked, the wish turns to the
// right by a growing angle.
#pragma once
#include "planner/stages/certifying.h"

namespace avo::inline planner {

/// The choice for the wish, or on a detour. Updates the angle of the detour.
template <typename Trace>
CertifiedChoice choose_and_arrive(const Certifying& decision, Detour& detour, Trace trace);

}  // namespace avo::inline planner
