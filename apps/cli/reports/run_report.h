// SPDX-License-Identifier: Apache-2.0
// The results of avo run, as text.
#pragma once
#include <string>

#include "avo/metrics.h"
#include "avo/scenario.h"

namespace avo_cli {

/// Prints one line about robots that walls keep from their goals; nothing if there are none.
void tell_unreachable(const avo::RunSummary& results);

/// Returns a short table.
std::string readable(const avo::Scenario& scenario, const avo::RunSummary& results);

}  // namespace avo_cli
