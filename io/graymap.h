// SPDX-License-Identifier: Apache-2.0
// Portable graymaps (PGM), plain (P2) and raw (P5).
#pragma once
#include <cstdint>
#include <vector>

#include "source_text.h"

namespace avo_io {

struct Graymap {
  std::int64_t width = 0, height = 0;
  std::int64_t white = 255;           ///< the largest value there may be
  std::vector<std::uint16_t> values;  ///< row by row, the first is the top
};
/// Throws SceneError. Allocates no more than the text has values.
Graymap read_graymap(const SourceText& source);

}  // namespace avo_io
