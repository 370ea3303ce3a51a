// SPDX-License-Identifier: Apache-2.0
// BMP without compression: 1, 4 and 8 bits by a palette, 16, 24 and 32 bits by masks.
#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>
#include <string_view>

#include "io/maps/image.h"

namespace avo_io {
namespace {

/// The bytes of a file, with the low byte of a number first.
class BmpBytes {
 public:
  explicit BmpBytes(const SourceText& source) : source_(source) {}

  [[nodiscard]] std::uint32_t byte(std::size_t at) const {
    if (at >= source_.text().size()) source_.fail(0, "found a BMP that ends too early");
    return static_cast<unsigned char>(source_.text()[at]);
  }
  /// Returns a number of so many bytes.
  [[nodiscard]] std::uint32_t number(std::size_t at, std::size_t bytes) const {
    std::uint32_t value = 0;
    for (std::size_t k = bytes; k-- > 0;) value = value << 8U | byte(at + k);
    return value;
  }
  [[nodiscard]] std::int32_t integer(std::size_t at) const {
    return static_cast<std::int32_t>(number(at, 4));
  }
  [[nodiscard]] const SourceText& source() const { return source_; }
  [[nodiscard]] std::size_t size() const { return source_.text().size(); }

 private:
  const SourceText& source_;
};

struct BmpHeader {
  std::size_t pixels = 0;   // offset at which they begin
  std::size_t palette = 0;  // offset at which it begins
  std::size_t colors = 0;   // number of its colors
  std::size_t color_bytes = 4;
  std::uint32_t bits = 0;  // of a pixel
  bool bottom_up = true;
  std::array<std::uint32_t, 4> masks{};  // red, green, blue, opacity; 0: there is none
};

// Numbers that the format defines.
constexpr std::uint32_t kCoreHeader = 12, kInfoHeader = 40, kWithMasks = 52, kWithOpacity = 56;
constexpr std::uint32_t kPlain = 0, kMasks = 3, kMasksAndOpacity = 6;
constexpr std::size_t kFileHeader = 14;

void read_masks(const BmpBytes& bytes, std::uint32_t length, std::uint32_t compression,
                BmpHeader& header) {
  if (compression == kPlain) {
    header.masks = header.bits == 16
                       ? std::array<std::uint32_t, 4>{0x7C00, 0x03E0, 0x001F, 0}
                       : std::array<std::uint32_t, 4>{0xFF0000, 0x00FF00, 0x0000FF, 0};
    return;
  }
  const bool opacity = compression == kMasksAndOpacity || length >= kWithOpacity;
  for (std::size_t k = 0; k < (opacity ? 4U : 3U); ++k)
    header.masks[k] = bytes.number(kFileHeader + kInfoHeader + 4 * k, 4);
  for (std::size_t k = 0; k < 3; ++k)
    if (header.masks[k] == 0) bytes.source().fail(0, "found a BMP without masks of its colors");
}

void read_palette(const BmpBytes& bytes, std::uint32_t length, BmpHeader& header) {
  header.palette = kFileHeader + length;
  header.color_bytes = length == kCoreHeader ? 3 : 4;
  const std::size_t most = std::size_t{1} << header.bits;
  const std::size_t given = length == kCoreHeader ? 0 : bytes.number(kFileHeader + 32, 4);
  header.colors = given == 0 ? most : std::min(given, most);
}

BmpHeader read_bmp_header(const BmpBytes& bytes, Image& image) {
  BmpHeader header;
  header.pixels = bytes.number(10, 4);
  const std::uint32_t length = bytes.number(kFileHeader, 4);
  if (length != kCoreHeader && (length < kInfoHeader || length > 1024))
    bytes.source().fail(0, fmt::format("found a BMP with a header of {} bytes, must be 12, or 40 "
                                       "to 1024",
                                       length));
  const bool core = length == kCoreHeader;
  image.width = core ? static_cast<std::int32_t>(bytes.number(18, 2)) : bytes.integer(18);
  image.height = core ? static_cast<std::int32_t>(bytes.number(20, 2)) : bytes.integer(22);
  header.bottom_up = image.height > 0;
  if (!header.bottom_up) image.height = -image.height;
  require_pixels(bytes.source(), image);
  header.bits = bytes.number(core ? 24 : 28, 2);
  const std::uint32_t compression = core ? kPlain : bytes.number(30, 4);
  const bool masks = compression == kMasks || compression == kMasksAndOpacity;
  const bool by_masks = header.bits == 16 || header.bits == 24 || header.bits == 32;
  if (!by_masks && header.bits != 1 && header.bits != 4 && header.bits != 8)
    bytes.source().fail(0, fmt::format("found a BMP of {} bits a pixel, must be 1, 4, 8, 16, 24 or "
                                       "32",
                                       header.bits));
  if (compression != kPlain && !(masks && by_masks && header.bits != 24))
    bytes.source().fail(0, "found a BMP with compression, must be without");
  if (by_masks)
    read_masks(bytes, length, compression, header);
  else
    read_palette(bytes, length, header);
  return header;
}

constexpr std::uint32_t kBmpWhite = 255;

/// Returns the channel that a mask selects, as 8 bits.
std::uint32_t channel(std::uint32_t pixel, std::uint32_t mask) {
  const int shift = std::countr_zero(mask);
  const std::uint64_t most = mask >> shift, value = (pixel & mask) >> shift;
  return static_cast<std::uint32_t>((value * kBmpWhite + most / 2) / most);
}

std::uint32_t palette_sum(const BmpBytes& bytes, const BmpHeader& header, std::uint32_t color) {
  if (color >= header.colors)
    bytes.source().fail(0, fmt::format("found the color {}, must be < {}, those of the palette",
                                       color, header.colors));
  const std::size_t at = header.palette + color * header.color_bytes;
  return bytes.byte(at) + bytes.byte(at + 1) + bytes.byte(at + 2);
}

void append_bmp_row(const BmpBytes& bytes, const BmpHeader& header, std::size_t row, Image& image) {
  const auto& [red, green, blue, opacity] = header.masks;
  for (std::int64_t column = 0; column < image.width; ++column) {
    const auto x = static_cast<std::size_t>(column);
    if (header.bits <= 8) {
      const std::size_t bit = x * header.bits;
      const std::uint32_t shift = 8 - header.bits - static_cast<std::uint32_t>(bit % 8);
      const std::uint32_t color = bytes.byte(row + bit / 8) >> shift & ((1U << header.bits) - 1U);
      image.color.push_back(palette_sum(bytes, header, color));
      continue;
    }
    const std::uint32_t pixel = bytes.number(row + x * header.bits / 8, header.bits / 8);
    image.color.push_back(channel(pixel, red) + channel(pixel, green) + channel(pixel, blue));
    if (opacity != 0) image.opacity.push_back(static_cast<std::uint16_t>(channel(pixel, opacity)));
  }
}

}  // namespace

Image read_bmp(const SourceText& source) {
  const BmpBytes bytes(source);
  Image image;
  const BmpHeader header = read_bmp_header(bytes, image);
  const auto width = static_cast<std::size_t>(image.width);
  const auto height = static_cast<std::size_t>(image.height);
  // rows are padded to words of 32 bits
  const std::size_t stride = (width * header.bits + 31) / 32 * 4;
  const std::size_t given = header.pixels < bytes.size() ? bytes.size() - header.pixels : 0;
  if (given < stride * (height - 1) + (width * header.bits + 7) / 8)
    source.fail(0, fmt::format("found {} bytes of pixels, must be {} for {} x {}", given,
                               stride * height, width, height));
  image.color.reserve(width * height);
  for (std::size_t y = 0; y < height; ++y)
    append_bmp_row(bytes, header, header.pixels + stride * (header.bottom_up ? height - 1 - y : y),
                   image);
  return image;
}

}  // namespace avo_io
