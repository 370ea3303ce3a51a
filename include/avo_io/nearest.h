// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the nearest of the allowed words.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "avo/export.h"

namespace avo_io {

/// Returns the word most like `given`, if a word is so like it that it may have been meant.
AVO_API std::optional<std::string_view> nearest(std::string_view given,
                                                const std::vector<std::string_view>& words);

}  // namespace avo_io
