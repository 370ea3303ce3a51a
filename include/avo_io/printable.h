// SPDX-License-Identifier: Apache-2.0
// Text of unknown origin, made fit for a terminal.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "avo/export.h"

namespace avo_io {

/// Returns one line of UTF-8 that only shows text. Line ends, control characters (C0, DEL, C1),
/// marks that turn the direction of writing, and bytes that are not UTF-8 become `\n` and `\xNN`.
/// If there are more than `most` characters, the middle becomes "...".
AVO_API std::string printable(std::string_view text, std::size_t most = std::string_view::npos);

}  // namespace avo_io
