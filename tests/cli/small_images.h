// SPDX-License-Identifier: Apache-2.0
// PNG and BMP files made byte by byte, in forms that few programs write.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace avo_test {

/// So many bytes of a number, the highest first.
inline std::string big_endian(std::uint32_t value, int bytes) {
  std::string text;
  for (int k = bytes; k-- > 0;) text += static_cast<char>(value >> (8 * k) & 0xFFU);
  return text;
}
inline std::string little_endian(std::uint32_t value, int bytes) {
  const std::string text = big_endian(value, bytes);
  return {text.rbegin(), text.rend()};
}

inline std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ (crc & 1U ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

inline std::string png_chunk(const std::string& name, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size()), 4) + name + data +
         big_endian(crc32(name + data), 4);
}

struct SmallPng {
  std::uint32_t width = 3, height = 2;
  int depth = 8, type = 0;  ///< 0 gray, 2 colors, 3 palette, 4 gray and opacity, 6 all
  std::vector<std::string> lines =
      {};                    ///< as they are stored; of an interlaced one those of each pass
  std::string palette = {};  ///< three bytes a color
  bool interlaced = false;
};

/// Stored without compression, and without filters.
inline std::string bytes_of(const SmallPng& png) {
  std::string raw;
  for (const std::string& line : png.lines) raw += '\0' + line;
  std::uint32_t a = 1, b = 0;
  for (const char byte : raw) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto length = static_cast<std::uint32_t>(raw.size());
  const std::string stream = std::string("\x78\x01\x01") + little_endian(length, 2) +
                             little_endian(~length & 0xFFFFU, 2) + raw +
                             big_endian(b << 16U | a, 4);
  const std::string header = big_endian(png.width, 4) + big_endian(png.height, 4) +
                             static_cast<char>(png.depth) + static_cast<char>(png.type) +
                             std::string(2, '\0') + static_cast<char>(png.interlaced);
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) +
         (png.palette.empty() ? "" : png_chunk("PLTE", png.palette)) + png_chunk("IDAT", stream) +
         png_chunk("IEND", "");
}

struct SmallBmp {
  std::int32_t width = 3, height = 2;  ///< less than 0: the first line is the top
  std::uint32_t bits = 8;
  std::vector<std::string> lines = {};  ///< as they are stored, without what fills them up
  std::string palette = {};             ///< four bytes a color
  std::string masks = {};
  std::uint32_t compression = 0;
};

inline std::string bytes_of(const SmallBmp& bmp) {
  std::string pixels;
  for (std::string line : bmp.lines) {
    line.resize((line.size() + 3) / 4 * 4);
    pixels += line;
  }
  const std::string tables = bmp.masks + bmp.palette;
  const auto begin = static_cast<std::uint32_t>(54 + tables.size());
  const auto size = static_cast<std::uint32_t>(begin + pixels.size());
  return "BM" + little_endian(size, 4) + little_endian(0, 4) + little_endian(begin, 4) +
         little_endian(40, 4) + little_endian(static_cast<std::uint32_t>(bmp.width), 4) +
         little_endian(static_cast<std::uint32_t>(bmp.height), 4) + little_endian(1, 2) +
         little_endian(bmp.bits, 2) + little_endian(bmp.compression, 4) + std::string(12, '\0') +
         little_endian(static_cast<std::uint32_t>(bmp.palette.size() / 4), 4) +
         little_endian(0, 4) + tables + pixels;
}

}  // namespace avo_test
