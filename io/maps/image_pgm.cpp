// SPDX-License-Identifier: Apache-2.0
// Portable graymaps: the size that the header tells is compared with the size of the file first.
#include <algorithm>
#include <fmt/format.h>

#include "io/maps/image.h"

namespace avo_io {
namespace {

constexpr std::int64_t kLongestSide = 1'000'000'000;
constexpr std::int64_t kWhitest = 65535;

/// Comments, from # to the end of the line, may stand before every number.
std::int64_t header_number(Words& words, std::string_view what, std::int64_t max) {
  const std::string_view text = words.source().text();
  while (words.peek().text.starts_with('#'))
    words.skip_to(std::min(text.find('\n', words.peek().offset), text.size()));
  return words.whole_number(what, 1, max);
}

[[noreturn]] void fail_size(const SourceText& source, const Image& image, std::size_t given) {
  source.fail(source.text().size(),
              fmt::format("found {} values, must be {} x {}", given, image.width, image.height));
}

void check_value(const SourceText& source, std::size_t offset, std::int64_t value,
                 const Image& image) {
  if (value > image.white)
    source.fail(offset, fmt::format("found the value {}, must be <= {}", value, image.white));
}

void read_raw(const SourceText& source, std::size_t offset, Image& image) {
  const std::string_view text = source.text();
  const std::size_t bytes = image.white > 255 ? 2 : 1;
  const auto count = static_cast<std::size_t>(image.width * image.height);
  const std::size_t given = offset < text.size() ? (text.size() - offset) / bytes : 0;
  if (given < count) fail_size(source, image, given);
  const std::string_view rest = text.substr(offset + count * bytes);
  if (!std::all_of(rest.begin(), rest.end(), is_space)) fail_size(source, image, given);
  image.color.reserve(count);
  for (std::size_t i = 0; i < count; ++i, offset += bytes) {
    std::int64_t value = static_cast<unsigned char>(text[offset]);
    if (bytes == 2) value = 256 * value + static_cast<unsigned char>(text[offset + 1]);
    check_value(source, offset, value, image);
    image.color.push_back(3U * static_cast<std::uint32_t>(value));
  }
}

void read_plain(Words& words, Image& image) {
  const auto count = static_cast<std::size_t>(image.width * image.height);
  while (!words.peek().text.empty()) {
    const std::size_t offset = words.peek().offset;
    const std::int64_t value = words.whole_number("the value", 0, kWhitest);
    check_value(words.source(), offset, value, image);
    if (image.color.size() == count)
      words.source().fail(
          offset, fmt::format("found more values, must be {} x {}", image.width, image.height));
    image.color.push_back(3U * static_cast<std::uint32_t>(value));
  }
  if (image.color.size() < count) fail_size(words.source(), image, image.color.size());
}

}  // namespace

Image read_pgm(const SourceText& source) {
  Words words(source);
  const Word kind = words.next();
  Image image;
  image.width = header_number(words, "the width", kLongestSide);
  image.height = header_number(words, "the height", kLongestSide);
  image.white = header_number(words, "the largest value", kWhitest);
  if (kind.text == "P5")
    read_raw(source, words.offset() + 1, image);  // one white-space character ends the header
  else
    read_plain(words, image);
  return image;
}

}  // namespace avo_io
