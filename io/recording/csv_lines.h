// SPDX-License-Identifier: Apache-2.0
// The lines of recordings as CSV.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "avo/check.h"

namespace avo_io {

/// The columns besides those of every recording.
struct CsvForm {
  bool headings = false;   ///< heading and speed
  std::int64_t every = 1;  ///< the column "every" is there if this is more than 1
};

/// Returns the first line.
std::string csv_header(const CsvForm& form);
/// Returns the first column of all lines of that time, s.
std::string csv_time(double time);
/// Appends the line of one robot.
void append_csv_line(std::string_view time, const avo::CheckedState& state, const CsvForm& form,
                     std::string& lines);

}  // namespace avo_io
