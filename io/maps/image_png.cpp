// SPDX-License-Identifier: Apache-2.0
// PNG by libpng, row by row. Its errors use longjmp; no object with a destructor is in the frames
// that they jump over.
#include <algorithm>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <fmt/format.h>
#include <png.h>
#include <string>

#include "io/maps/image.h"

namespace avo_io {
namespace {

/// A decoder on the bytes of a file.
class PngDecoder {
 public:
  explicit PngDecoder(std::string_view bytes) : rest_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, note_error, ignore_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ != nullptr) png_set_read_fn(png_, this, take_bytes);
  }
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png_, &info_, nullptr); }

  [[nodiscard]] png_structp png() const { return png_; }
  [[nodiscard]] png_infop info() const { return info_; }
  [[nodiscard]] const char* error() const { return error_; }
  [[nodiscard]] int passes() const { return passes_; }

  // Each function returns false after an error.
  bool read_header();
  bool read_row(png_bytep row);
  bool read_end();

 private:
  static void note_error(png_structp png, png_const_charp message) {
    auto* self = static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::strncpy(self->error_, message, sizeof self->error_ - 1);
    png_longjmp(png, 1);
  }
  static void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}
  static void take_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* self = static_cast<PngDecoder*>(png_get_io_ptr(png));
    if (count > self->rest_.size()) png_error(png, "it ends too early");
    std::memcpy(to, self->rest_.data(), count);
    self->rest_.remove_prefix(count);
  }

  std::string_view rest_;  // of the bytes
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  char error_[128] = "no memory";
};

// Palettes become colors, and a palette with a transparent color gets an opacity. 16 bits stay.
bool PngDecoder::read_header() {
  if (info_ == nullptr || setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_info(png_, info_);
  png_set_expand(png_);
  passes_ = png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  return true;
}

bool PngDecoder::read_row(png_bytep row) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_row(png_, row, nullptr);
  return true;
}

bool PngDecoder::read_end() {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_end(png_, nullptr);
  return true;
}

struct PngLayout {
  std::size_t channels = 1, bytes = 1;  // of a pixel; of a channel
};

// Appends gray, gray and opacity, colors, or colors and opacity.
void append_png_row(const std::vector<png_byte>& row, const PngLayout& layout, Image& image) {
  const auto [channels, bytes] = layout;
  const std::size_t colors = channels > 2 ? 3 : 1;
  const png_byte* at = row.data();
  const auto next = [&at, two = bytes == 2] {
    std::uint32_t value = *at++;
    if (two) value = 256 * value + *at++;
    return value;
  };
  for (std::int64_t x = 0; x < image.width; ++x) {
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < colors; ++k) sum += next();
    image.color.push_back(colors == 1 ? 3 * sum : sum);
    if (channels > colors) image.opacity.push_back(static_cast<std::uint16_t>(next()));
  }
}

constexpr std::size_t kMostInflation = 1032;  // of deflate: the most bytes from one byte

/// Reads row by row; an interlaced image comes in several passes, each with more detail.
bool read_png_rows(PngDecoder& decoder, const PngLayout& layout, Image& image) {
  const std::size_t length = png_get_rowbytes(decoder.png(), decoder.info());
  const auto height = static_cast<std::size_t>(image.height);
  const bool at_once = decoder.passes() == 1;
  std::vector<std::vector<png_byte>> rows(at_once ? 1 : height, std::vector<png_byte>(length));
  for (int pass = 1; pass <= decoder.passes(); ++pass) {
    for (std::size_t y = 0; y < height; ++y) {
      std::vector<png_byte>& row = rows[at_once ? 0 : y];
      if (!decoder.read_row(row.data())) return false;
      if (pass == decoder.passes()) append_png_row(row, layout, image);
    }
  }
  return decoder.read_end();
}

}  // namespace

Image read_png(const SourceText& source) {
  PngDecoder decoder(source.text());
  const auto fail = [&] {
    source.fail(0, fmt::format("found a damaged PNG ({}), must be whole", decoder.error()));
  };
  if (!decoder.read_header()) fail();
  Image image;
  image.width = png_get_image_width(decoder.png(), decoder.info());
  image.height = png_get_image_height(decoder.png(), decoder.info());
  require_pixels(source, image);
  const PngLayout layout{png_get_channels(decoder.png(), decoder.info()),
                         png_get_bit_depth(decoder.png(), decoder.info()) == 16 ? 2U : 1U};
  if (layout.bytes == 2) image.white = 65535;
  const auto pixels = static_cast<std::size_t>(image.width * image.height);
  if (pixels / 8 > kMostInflation * source.text().size())  // a pixel may have only one bit
    source.fail(0, fmt::format("found {} bytes, must be more for {} x {} pixels",
                               source.text().size(), image.width, image.height));
  image.color.reserve(pixels);
  if (layout.channels % 2 == 0) image.opacity.reserve(pixels);
  if (!read_png_rows(decoder, layout, image)) fail();
  return image;
}

}  // namespace avo_io
