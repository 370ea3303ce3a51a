// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the nearest of the allowed words.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/export.h"

namespace avo_io {

/// Returns the word most like `given`, if a word is so like it that it may have been meant.
AVO_API std::optional<std::string_view> nearest(std::string_view given,
                                                const std::vector<std::string_view>& words);

/// What errors say of the words that are allowed, and first of the one that may have been meant:
/// `did you mean "radius"? Must be one of position, radius`. before: what comes before the list.
AVO_API std::string allowed_words(std::string_view given,
                                  const std::vector<std::string_view>& words,
                                  std::string before = "must be one of");

}  // namespace avo_io
