// SPDX-License-Identifier: Apache-2.0
// At most 256 colors for a picture: a figure as PNG then takes a fifth of the bytes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace avo::figures {

struct IndexedImage {
  std::vector<std::uint32_t> palette;  ///< 0x00RRGGBB, at most 256
  std::vector<std::uint8_t> index;     ///< one a pixel, into the palette
};

/// Exact where the picture has at most 256 colors; else by median cut, where a color that makes up
/// most of its group (the paper's white, a filled area) stays as it is. Reads the lower 24 bits.
IndexedImage reduce_colors(std::span<const std::uint32_t> pixels);

}  // namespace avo::figures
