// SPDX-License-Identifier: Apache-2.0
// Images of ROS maps in every form, one map in all of them, and what is said of damaged ones.
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

#include "avo_io/errors.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "small_images.h"

namespace avo_test {
namespace {

using avo::Vec2;

const std::string kSceneOfMap =
    "version: 1\nrobots: [{position: [0.25, 0.75], goal: [0.25, 0.75], radius: 0.2}]\n"
    "obstacles: [{ros_map: m.yaml}]\n";

void write_map(const std::string& image, const std::string& more = "") {
  write_file(path_of("m.yaml"),
             "image: image\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
             "occupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                 more);
  write_file(path_of("image"), image);
}

/// The corners of the free cells' borders.
std::vector<Vec2> corners_of(const std::string& image, const std::string& more = "") {
  write_map(image, more);
  const avo::Scenario scenario = avo_io::parse_scenario(kSceneOfMap, path_of("s.yaml"));
  std::vector<Vec2> corners;
  for (const avo::Chain& chain : scenario.obstacles.at(0).chains)
    corners.insert(corners.end(), chain.points.begin(), chain.points.end());
  return corners;
}

const std::vector<Vec2> kUpperLeft{{0, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}};

std::string line(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

// 254 is free, 205 unknown, 0 occupied: 254 205 0 above 205 0 205.
TEST(MapImages, png_of_every_kind) {
  const std::vector<SmallPng> all{
      {.lines = {line({254, 205, 0}), line({205, 0, 205})}},
      {.depth = 16, .lines = {line({254, 254, 205, 205, 0, 0}), line({205, 205, 0, 0, 205, 205})}},
      {.depth = 2,
       .type = 3,
       .lines = {line({0b00011000}), line({0b01100100})},
       .palette = line({254, 254, 254, 205, 205, 205, 0, 0, 0})},
      {.depth = 1, .lines = {line({0b10000000}), line({0})}},
      {.type = 2,
       .lines = {line({254, 255, 253, 205, 205, 205, 0, 0, 0}),
                 line({255, 0, 255, 0, 0, 0, 0, 255, 0})}},
      // the first pass has the first pixel, the sixth the column beside it, the seventh the rest
      {.lines = {line({254}), line({0}), line({205}), line({205, 0, 205})}, .interlaced = true},
  };
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(corners_of(bytes_of(all[k])), kUpperLeft) << k;
}

// In mode trinary ROS takes opacity for a channel; in mode scale what is not opaque is unknown.
TEST(MapImages, opacity_counts_as_in_ros) {
  const SmallPng gray{.type = 4,
                      .lines = {line({254, 255, 254, 0, 0, 255}), line({0, 0, 0, 0, 0, 0})}};
  const SmallPng dimmed{.type = 4,
                        .lines = {line({254, 255, 254, 200, 0, 255}), line({0, 0, 0, 0, 0, 0})}};
  EXPECT_EQ(corners_of(bytes_of(gray)), kUpperLeft);
  EXPECT_EQ(corners_of(bytes_of(dimmed)).at(1), (Vec2{1, 0.5})) << "(3 254 + 200) / 4 is bright";
  EXPECT_EQ(corners_of(bytes_of(dimmed), "mode: scale\n"), kUpperLeft);
  const SmallPng colors{.type = 6,
                        .lines = {line({254, 254, 254, 255, 0, 0, 0, 255, 0, 0, 0, 0}),
                                  line({255, 255, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0})}};
  EXPECT_EQ(corners_of(bytes_of(colors)), kUpperLeft);
}

TEST(MapImages, bmp_of_every_kind) {
  const std::string up = line({205, 0, 205}), top = line({254, 205, 0});
  std::string palette;
  for (int k = 0; k < 256; ++k) palette += line({k, k, k, 0});
  const std::string three = line({0, 0, 0, 0, 205, 205, 205, 0, 254, 254, 254, 0});
  const std::vector<SmallBmp> all{
      {.lines = {up, top}, .palette = palette},
      {.height = -2, .lines = {top, up}, .palette = palette},
      {.bits = 1,
       .lines = {line({0}), line({0x80})},
       .palette = line({0, 0, 0, 0, 255, 255, 255, 0})},
      {.bits = 4, .lines = {line({0x10, 0x10}), line({0x21, 0x00})}, .palette = three},
      {.bits = 24,
       .lines = {line({205, 205, 205, 0, 0, 0, 205, 205, 205}),
                 line({254, 254, 254, 205, 205, 205, 0, 0, 0})}},
      {.bits = 32,
       .lines = {line({205, 205, 205, 0, 0, 0, 0, 0, 205, 205, 205, 0}),
                 line({254, 254, 254, 0, 205, 205, 205, 0, 0, 0, 0, 0})}},
      {.bits = 16, .lines = {line({0, 0, 0, 0, 0, 0}), line({0xFF, 0x7F, 0, 0, 0, 0})}},
      {.bits = 16,  // 5-6-5
       .lines = {line({0, 0, 0, 0, 0, 0}), line({0xFF, 0xFF, 0, 0, 0, 0})},
       .masks = line({0, 0xF8, 0, 0, 0xE0, 0x07, 0, 0, 0x1F, 0, 0, 0}),
       .compression = 3},
  };
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ(corners_of(bytes_of(all[k])), kUpperLeft) << k;
}

// In the mode raw, the values are hundredths. A value above 100 is unknown, and negate says
// nothing.
TEST(MapImages, raw_values_are_hundredths) {
  EXPECT_EQ(corners_of("P2 3 2 255 19 20 100 101 255 60\n", "mode: raw\n"), kUpperLeft);
}

TEST(MapImages, negate_may_be_a_word) {
  write_map("P2 3 2 255 0 50 255 50 255 50\n");
  std::string yaml = read_file(path_of("m.yaml"));
  yaml.replace(yaml.find("negate: 0"), 9, "negate: true");
  write_file(path_of("m.yaml"), yaml);
  EXPECT_EQ(
      avo_io::parse_scenario(kSceneOfMap, path_of("s.yaml")).obstacles.at(0).chains.at(0).points,
      kUpperLeft);
}

TEST(MapImages, unknown_keys_are_noted_and_left_out) {
  write_map("P2 3 2 255 254 0 0 0 0 0\n", "map_type: occupancy\nmde: raw\n");
  write_file(path_of("s.yaml"), kSceneOfMap);
  const ProcessResult result = run_avo({"validate", path_of("s.yaml")});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "warning: " + path_of("m.yaml") +
                            ":7:1: the unknown key \"map_type\" is left out, as ROS does\n"
                            "warning: " +
                            path_of("m.yaml") +
                            ":8:1: the unknown key \"mde\" is left out, as ROS does; did you mean "
                            "\"mode\"?\n");
  EXPECT_EQ(run_avo({"validate", path_of("s.yaml"), "-q"}).err, "");
}

TEST(MapImages, a_recording_has_the_image_in_itself) {
  write_map(bytes_of(SmallPng{.lines = {line({254, 205, 0}), line({205, 0, 205})}}));
  write_file(path_of("s.yaml"), kSceneOfMap);
  const std::string recording = path_of("run.h5");
  EXPECT_EQ(run_avo({"run", path_of("s.yaml"), "--record", recording, "-q"}).exit_code, 0);
  write_file(path_of("image"), "gone");
  EXPECT_EQ(run_avo({"check", recording, "-q"}).exit_code, 0);
  EXPECT_EQ(run_avo({"replay", recording, "-q"}).exit_code, 0);
}

// So the lab reads them, which knows graymaps alone.
TEST(MapImages, become_graymaps_of_the_same_map) {
  const auto graymap_of = [](const std::string& bytes) {
    return avo_io::as_graymap({"image", bytes});
  };
  const SmallPng colors{.type = 2,
                        .lines = {line({254, 255, 253, 205, 205, 205, 0, 0, 0}),
                                  line({255, 0, 255, 0, 0, 0, 0, 255, 0})}};
  const SmallPng deep{.depth = 16,
                      .lines = {line({254, 1, 205, 2, 0, 3}), line({205, 4, 0, 5, 205, 6})}};
  for (const SmallPng& png : {colors, deep}) {
    const auto graymap = graymap_of(bytes_of(png));
    ASSERT_TRUE(graymap);
    EXPECT_EQ(corners_of(*graymap), kUpperLeft);
    EXPECT_FALSE(graymap_of(*graymap)) << "it is one";
  }
  EXPECT_FALSE(graymap_of(
      bytes_of(SmallPng{.type = 4, .lines = {line({1, 2, 3, 4, 5, 6}), line({1, 2, 3, 4, 5, 6})}})))
      << "opacity";
  EXPECT_FALSE(graymap_of("BM and no more"));
}

struct BadImage {
  const char* name;
  std::string bytes, message;
};

void PrintTo(const BadImage& bad, std::ostream* out) {
  *out << bad.name;
}

std::string png_cut_at(std::size_t length) {
  return bytes_of(SmallPng{.lines = {line({254, 205, 0}), line({205, 0, 205})}}).substr(0, length);
}
std::string bmp_cut_at(std::size_t length) {
  return bytes_of(SmallBmp{.bits = 24, .lines = {std::string(9, 'a'), std::string(9, 'a')}})
      .substr(0, length);
}
std::string with_byte(std::string bytes, std::size_t at, char byte) {
  bytes.at(at) = byte;
  return bytes;
}

const std::vector<BadImage> kBadImages{
    {"png_signature", png_cut_at(8), "found a damaged PNG (it ends too early), must be whole"},
    {"png_header", png_cut_at(30), "found a damaged PNG (it ends too early), must be whole"},
    {"png_pixels", png_cut_at(46), "found a damaged PNG (it ends too early), must be whole"},
    {"png_end", png_cut_at(70), "found a damaged PNG (it ends too early), must be whole"},
    {"png_bit", with_byte(png_cut_at(1000), 50, 'x'),
     "found a damaged PNG (IDAT: incorrect data check), must be whole"},
    {"png_text", png_cut_at(4) + "text and no signature",
     "found a damaged PNG (PNG file corrupted by ASCII conversion), must be whole"},
    {"png_huge", bytes_of(SmallPng{.width = 100'000, .height = 100'000}),
     "found 100000 x 100000 pixels, must be 1 to 67108864 in all"},
    {"png_promise", bytes_of(SmallPng{.width = 8000, .height = 8000}),
     "found 68 bytes, must be more for 8000 x 8000 pixels"},
    {"bmp_two_bytes", bmp_cut_at(2), "found a BMP that ends too early"},
    {"bmp_header", bmp_cut_at(30), "found a BMP that ends too early"},
    {"bmp_pixels", bmp_cut_at(70), "found 16 bytes of pixels, must be 24 for 3 x 2"},
    {"bmp_compressed", bytes_of(SmallBmp{.lines = {"aaa", "aaa"}, .compression = 1}),
     "found a BMP with compression, must be without"},
    {"bmp_bits", bytes_of(SmallBmp{.bits = 2, .lines = {"a", "a"}}),
     "found a BMP of 2 bits a pixel, must be 1, 4, 8, 16, 24 or 32"},
    {"bmp_color",
     bytes_of(SmallBmp{.lines = {line({0, 0, 9}), line({0, 0, 0})}, .palette = "abcd"}),
     "found the color 9, must be < 1, those of the palette"},
    {"bmp_flat", bytes_of(SmallBmp{.height = 0}),
     "found 3 x 0 pixels, must be 1 to 67108864 in all"},
    {"bmp_tall", bytes_of(SmallBmp{.height = std::numeric_limits<std::int32_t>::min()}),
     "found 3 x 2147483648 pixels, must be 1 to 67108864 in all"},
    {"bmp_narrow", bytes_of(SmallBmp{.width = -3}),
     "found -3 x 2 pixels, must be 1 to 67108864 in all"},
    {"bmp_masks",
     bytes_of(SmallBmp{.bits = 16,
                       .lines = {"aaaaaa", "aaaaaa"},
                       .masks = std::string(12, '\0'),
                       .compression = 3}),
     "found a BMP without masks of its colors"},
};

class BadImages : public testing::TestWithParam<BadImage> {};

TEST_P(BadImages, are_refused_in_one_line) {
  write_map(GetParam().bytes);
  write_file(path_of("s.yaml"), kSceneOfMap);
  const ProcessResult result = run_avo({"validate", path_of("s.yaml")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path_of("image") + ":1:1: " + GetParam().message + "\n");
}

const auto kImageName = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(All, BadImages, testing::ValuesIn(kBadImages), kImageName);

}  // namespace
}  // namespace avo_test
