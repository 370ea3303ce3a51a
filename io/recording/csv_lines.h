// SPDX-License-Identifier: Apache-2.0
// The lines of recordings as CSV.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "avo/check.h"

namespace avo_io {

/// The columns besides those of every recording.
struct CsvForm {
  bool headings = false;               ///< heading and speed
  std::int64_t every = 1;              ///< steps from row to row
  bool thinned = every > 1;            ///< whether the column "every" is there
  std::optional<bool> estimated = {};  ///< if set, the column "estimated" is there
};

/// Returns the first line.
std::string csv_header(const CsvForm& form);
/// Returns the first column of all lines of that time, s.
std::string csv_time(double time);
/// Appends the line of one robot.
void append_csv_line(std::string_view time, const avo::CheckedState& state, const CsvForm& form,
                     std::string& lines);

}  // namespace avo_io
