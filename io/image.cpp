// SPDX-License-Identifier: Apache-2.0
// What an image is, by its first bytes.
#include "image.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

namespace avo_io {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26U;

void require_pixels(const SourceText& source, const Image& image) {
  if (image.width > 0 && image.height > 0 && image.width <= kMostPixels / image.height) return;
  source.fail(0, fmt::format("found {} x {} pixels, must be 1 to {} in all", image.width,
                             image.height, kMostPixels));
}

Image read_image(const SourceText& source) {
  const std::string_view text = source.text();
  if (text.starts_with("\x89PNG")) return read_png(source);
  if (text.starts_with("BM")) return read_bmp(source);
  Words words(source);
  const Word kind = words.next();
  if (kind.text == "P2" || kind.text == "P5") return read_pgm(source);
  words.fail({text.substr(0, std::min<std::size_t>(2, text.size())), 0},
             "must be a PNG, a BMP, or a portable graymap, P2 or P5");
}

}  // namespace avo_io
