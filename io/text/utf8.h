// SPDX-License-Identifier: Apache-2.0
// The characters of UTF-8.
#pragma once
#include <cstddef>
#include <string_view>

namespace avo_io {

/// Bytes of the character at the start of `text`, which is not empty; 0 where there is none.
std::size_t character_length(std::string_view text);

}  // namespace avo_io
