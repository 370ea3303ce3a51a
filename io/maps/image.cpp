// SPDX-License-Identifier: Apache-2.0
// Finds the format of an image by its first bytes.
#include "io/maps/image.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>

#include "avo_io/scene.h"

namespace avo_io {

constexpr std::int64_t kMostPixels = std::int64_t{1} << 26U;

void require_pixels(const SourceText& source, const Image& image) {
  if (image.width > 0 && image.height > 0 && image.width <= kMostPixels / image.height) return;
  source.fail(0, fmt::format("found {} x {} pixels, must be 1 to {} in all", image.width,
                             image.height, kMostPixels));
}

Image read_image(const SourceText& source) {
  const std::string_view text = source.text();
  // as bytes that are no UTF-8 are read
  constexpr std::string_view kReadAsText = "\xEF\xBF\xBDPNG";
  if (text.starts_with("\x89PNG") || text.starts_with(kReadAsText)) return read_png(source);
  if (text.starts_with("BM")) return read_bmp(source);
  Words words(source);
  const Word kind = words.next();
  if (kind.text == "P2" || kind.text == "P5") return read_pgm(source);
  words.fail({text.substr(0, std::min<std::size_t>(2, text.size())), 0},
             "must be a PNG, a BMP, or a portable graymap, P2 or P5");
}

std::optional<std::string> as_graymap(const SceneFile& file) {
  if (!file.text.starts_with("\x89PNG") && !file.text.starts_with("BM")) return std::nullopt;
  Image image;
  try {
    image = read_image(SourceText(file.path, file.text));
  } catch (const SceneError&) {
    return std::nullopt;
  }
  if (!image.opacity.empty()) return std::nullopt;
  const bool narrow = image.white == 255;  // the sum of three channels has two bytes
  std::string graymap = fmt::format("P5 {} {} {}\n", image.width, image.height,
                                    narrow ? 3 * image.white : image.white);
  for (const std::uint32_t color : image.color) {
    const std::uint32_t value = narrow ? color : color / 3;
    graymap += static_cast<char>(value >> 8U & 0xFFU);
    graymap += static_cast<char>(value & 0xFFU);
  }
  return graymap;
}

}  // namespace avo_io
