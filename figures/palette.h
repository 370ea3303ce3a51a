// SPDX-License-Identifier: Apache-2.0
// Reduces a picture to at most 256 colors: a figure as PNG then takes a fifth of the bytes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace avo::figures {

struct IndexedImage {
  std::vector<std::uint32_t> palette;  ///< 0x00RRGGBB, at most 256
  std::vector<std::uint8_t> index;     ///< one entry for each pixel, into the palette
};

/// The result is exact if the picture has at most 256 colors. Otherwise it uses median cut; a color
/// that makes up most of its group (the paper's white, a filled area) is kept. It reads the lower
/// 24 bits.
IndexedImage reduce_colors(std::span<const std::uint32_t> pixels);

}  // namespace avo::figures
