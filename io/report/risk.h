// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "avo_io/decision.h"

namespace avo_io {

/// Returns the risk that some neighbor's half-plane is broken: at most the sum of the risks.
double risk_of(const Decision& decision);

}  // namespace avo_io
