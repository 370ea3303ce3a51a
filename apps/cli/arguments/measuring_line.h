// SPDX-License-Identifier: Apache-2.0
// A measuring line that the command line names.
#pragma once
#include <optional>
#include <string>

#include "avo/metrics.h"

namespace avo_cli {

/// Returns the line of --line "X,Y,X,Y", m; none if the text is empty. Throws UsageError.
std::optional<avo::MeasuringLine> line_of(const std::string& text);

}  // namespace avo_cli
