// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the nearest of the words that are allowed.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "avo/export.h"

namespace avo_io {

/// The word most like `given`, if any is so like it that it may have been meant.
AVO_API std::optional<std::string_view> nearest(std::string_view given,
                                                const std::vector<std::string_view>& words);

}  // namespace avo_io
