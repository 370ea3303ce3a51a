// SPDX-License-Identifier: Apache-2.0
// Images of maps: portable graymaps (plain P2 and raw P5), PNG and BMP.
#pragma once
#include <cstdint>
#include <vector>

#include "io/text/source_text.h"

namespace avo_io {

/// Pixels row by row, from the top.
struct Image {
  std::int64_t width = 0, height = 0;
  std::int64_t white = 255;            ///< the largest value of a channel
  std::vector<std::uint32_t> color;    ///< red + green + blue, each up to `white`
  std::vector<std::uint16_t> opacity;  ///< up to `white`, which is opaque; empty: all are opaque
};

/// Reads the image in the format that its first bytes tell. Throws SceneError, and allocates no
/// memory that the bytes cannot fill.
Image read_image(const SourceText& source);

// These functions read one format each.
Image read_pgm(const SourceText& source);
Image read_png(const SourceText& source);
Image read_bmp(const SourceText& source);

/// Refuses an image of more pixels than the limit.
void require_pixels(const SourceText& source, const Image& image);

}  // namespace avo_io
