// SPDX-License-Identifier: Apache-2.0
// A line that the command line names.
#pragma once
#include <optional>
#include <string>

#include "avo/metrics.h"

namespace avo_cli {

/// Of --line "X,Y,X,Y", m; empty: none. Throws UsageError.
std::optional<avo::MeasuringLine> line_of(const std::string& text);

}  // namespace avo_cli
