// SPDX-License-Identifier: Apache-2.0
// The characters of UTF-8.
#pragma once
#include <cstddef>
#include <string_view>

namespace avo_io {

/// Returns the number of bytes of the character at the start of `text`, which must not be empty; 0
/// if there is none.
std::size_t character_length(std::string_view text);

}  // namespace avo_io
