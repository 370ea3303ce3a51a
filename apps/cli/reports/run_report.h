// SPDX-License-Identifier: Apache-2.0
// What avo run says of a run.
#pragma once
#include <string>

#include "avo/metrics.h"
#include "avo/scenario.h"

namespace avo_cli {

/// One line on robots that walls keep from their goals; nothing where there are none.
void tell_unreachable(const avo::RunSummary& results);

/// A short table.
std::string readable(const avo::Scenario& scenario, const avo::RunSummary& results);

}  // namespace avo_cli
