// SPDX-License-Identifier: Apache-2.0
// avo report for a sweep.
#pragma once
#include <string>

#include "verbs/verbs.h"

namespace avo_cli {

/// Returns whether avo report takes the file for the table of a sweep rather than for a recording.
bool is_sweep_table(const std::string& path);

/// Returns the page of such a table. Throws as exit_codes.h and avo_io/errors.h say.
std::string sweep_page(const ReportArguments& arguments);

}  // namespace avo_cli
