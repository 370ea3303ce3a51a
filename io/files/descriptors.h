// SPDX-License-Identifier: Apache-2.0
// All bytes of an open file, whatever interrupts a call.
#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace avo_io {

/// Writes all bytes. Returns false if that fails; errno says why.
[[nodiscard]] bool write_all(int descriptor, std::string_view bytes);

/// Reads to the end, or until there are more than `most` bytes. Returns none if that fails; errno
/// says why.
[[nodiscard]] std::optional<std::string> read_all(
    int descriptor, std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace avo_io
