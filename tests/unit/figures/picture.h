// SPDX-License-Identifier: Apache-2.0
// A PNG read back, and a folder of its own for the files of a test.
#pragma once
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <png.h>
#include <string>
#include <vector>

namespace avo::figures {

struct Picture {
  std::size_t width = 0, height = 0;
  std::vector<png_byte> rgb;

  /// Channels 0 ... 255 of the pixel at a page position in pt; two pixels to the point.
  [[nodiscard]] const png_byte* at(double x, double y) const {
    const auto column = static_cast<std::size_t>(2.0 * x);
    const auto row = static_cast<std::size_t>(2.0 * y);
    EXPECT_LT(column, width);
    EXPECT_LT(row, height);
    return &rgb[3 * (row * width + column)];
  }
  [[nodiscard]] int brightness(double x, double y) const {
    const png_byte* pixel = at(x, y);
    return (pixel[0] + pixel[1] + pixel[2]) / 3;
  }
};

inline Picture read_png(const std::string& path) {
  Picture picture;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    ADD_FAILURE() << path << ": " << image.message;
    return picture;
  }
  image.format = PNG_FORMAT_RGB;
  picture.width = image.width;
  picture.height = image.height;
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr) == 0) {
    ADD_FAILURE() << path << ": " << image.message;
  }
  return picture;
}

inline std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// A test with an empty folder that goes away with it.
class FigureFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("avo_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

}  // namespace avo::figures
