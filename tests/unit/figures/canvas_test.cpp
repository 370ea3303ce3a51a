// SPDX-License-Identifier: Apache-2.0
#include "figures/canvas.h"

#include "avo/error.h"
#include "picture.h"

namespace avo::figures {
namespace {

constexpr Color kRed{1.0, 0.0, 0.0, 1.0};

class CanvasFile : public FigureFile {};

std::string drawing(const std::string& path) {
  Canvas canvas(path, 120.0, 80.0);
  canvas.set_view({{10.0, 10.0}, {110.0, 70.0}}, {{-1.0, -1.0}, {1.0, 1.0}});
  canvas.add_disc({{0.2, 0.1}, 0.5});
  canvas.fill_and_stroke(kRed, {kBlack, 1.0, 2.0});
  {
    const Canvas::ClipScope scope(canvas);
    canvas.add_disc({{0.2, 0.1}, 0.3});
    canvas.clip();
    canvas.add_box({{0.0, 0.0}, {1.0, 1.0}});
    canvas.fill({0.0, 0.0, 1.0, 0.5});
  }
  canvas.text({-0.5, -0.5}, "*v*_{AB}^{pref} π", {.size = 10.0});
  return canvas.finish();
}

std::string message_of(const std::string& path) {
  try {
    (void)drawing(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(CanvasFile, one_drawing_code_makes_three_formats) {
  EXPECT_TRUE(drawing("a.svg").starts_with("<?xml"));
  EXPECT_TRUE(drawing("a.pdf").starts_with("%PDF-"));
  EXPECT_TRUE(drawing("a.png").starts_with("\x89PNG"));
  EXPECT_EQ(drawing("B.PNG"), drawing("a.png"));
  write_bytes(path("a.png"), drawing("a.png"));
  EXPECT_EQ(read_png(path("a.png")).width, 240U);
}

TEST_F(CanvasFile, same_drawing_same_bytes_without_a_date) {
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    const std::string first = drawing(name);
    EXPECT_TRUE(drawing(name) == first) << name;
    EXPECT_EQ(first.find("CreationDate"), std::string::npos) << name;
  }
}

TEST_F(CanvasFile, unknown_extensions_are_refused) {
  for (const char* name : {"a.jpg", "a", "png", "a.png.txt", ".d/svg"}) {
    const std::string message = message_of(name);
    EXPECT_TRUE(message.starts_with(name)) << message;
    EXPECT_NE(message.find("allowed: .svg, .png, .pdf"), std::string::npos) << message;
  }
}

TEST_F(CanvasFile, an_extension_without_a_name_is_refused) {
  for (const char* name : {".svg", "folder/.png"})
    EXPECT_NE(message_of(name).find("found an extension without a name"), std::string::npos);
}

TEST_F(CanvasFile, a_broken_page_is_an_error) {
  EXPECT_THROW(Canvas(path("a.png"), -5.0, 10.0), Error);
  EXPECT_THROW(Canvas(path("a.png"), 1e9, 10.0), Error);
}

TEST_F(CanvasFile, equal_axes_keep_the_shape_and_fill_the_page_box) {
  Canvas canvas(path("a.svg"), 300.0, 120.0);
  canvas.set_view({{0.0, 10.0}, {300.0, 110.0}}, {{-1.0, -2.0}, {3.0, 2.0}});
  EXPECT_DOUBLE_EQ(canvas.scale(), 25.0);
  EXPECT_EQ(canvas.view_world().lower, (Vec2{-5.0, -2.0}));
  EXPECT_EQ(canvas.view_world().upper, (Vec2{7.0, 2.0}));
  EXPECT_EQ(canvas.to_page({1.0, 0.0}), (Vec2{150.0, 60.0}));
  EXPECT_EQ(canvas.to_page({1.0, 2.0}), (Vec2{150.0, 10.0}));  // y up
  canvas.set_view({{0.0, 10.0}, {300.0, 110.0}}, {{0.0, 0.0}, {1000.0, 5.0}}, Aspect::stretch);
  EXPECT_EQ(canvas.to_page({1000.0, 5.0}), (Vec2{300.0, 10.0}));
}

TEST_F(CanvasFile, discs_fills_and_clips_end_up_where_they_belong) {
  Canvas canvas(path("a.png"), 100.0, 100.0);
  canvas.set_view({{0.0, 0.0}, {100.0, 100.0}}, {{-5.0, -5.0}, {5.0, 5.0}});
  canvas.add_disc({{2.0, 3.0}, 1.0});
  canvas.fill(kRed);
  canvas.add_disc({{-3.0, -3.0}, 1.5}).add_disc({{-3.0, -3.0}, 0.7});
  canvas.fill(kBlack, FillRule::even_odd);
  {
    const Canvas::ClipScope scope(canvas);
    canvas.add_disc({{3.0, -3.0}, 1.0});
    canvas.clip();
    canvas.add_box({{2.0, -5.0}, {3.0, 0.0}});
    canvas.fill(kBlack);
  }
  canvas.add_box({{-5.0, 4.5}, {-4.5, 5.0}});  // the clip is over
  canvas.fill(kRed);
  write_bytes(path("a.png"), canvas.finish());

  const Picture picture = read_png(path("a.png"));
  const auto is = [&](Vec2 world, int red, int green) {
    const png_byte* pixel = picture.at(50.0 + 10.0 * world.x, 50.0 - 10.0 * world.y);
    return pixel[0] == red && pixel[1] == green && pixel[2] == green;
  };
  EXPECT_TRUE(is({2.0, 3.0}, 255, 0));
  EXPECT_TRUE(is({2.9, 3.0}, 255, 0));
  EXPECT_TRUE(is({3.1, 3.0}, 255, 255));
  EXPECT_TRUE(is({2.0, -3.0 + 6.5}, 255, 0));
  EXPECT_TRUE(is({-3.0, -3.0}, 255, 255));  // the hole
  EXPECT_TRUE(is({-3.0, -4.1}, 0, 0));
  EXPECT_TRUE(is({2.5, -3.0}, 0, 0));
  EXPECT_TRUE(is({3.5, -3.0}, 255, 255));  // in the clip, not in the box
  EXPECT_TRUE(is({2.5, -1.0}, 255, 255));  // in the box, not in the clip
  EXPECT_TRUE(is({-4.8, 4.8}, 255, 0));
}

TEST_F(CanvasFile, an_svg_has_its_texts_as_text) {
  Canvas canvas(path("t.svg"), 100.0, 100.0);
  canvas.plain_page_text({10.0, 20.0}, "a < b & \u03b4", {.size = 8.0, .halo = true});
  canvas.page_text({10.0, 40.0}, "v_{max}", {.size = 10.0, .align_x = 0.5, .angle = 0.5});
  const std::string svg = canvas.finish();
  EXPECT_NE(svg.find(">a &lt; b &amp; \u03b4</tspan></text>"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">v</tspan><tspan"), std::string::npos);
  EXPECT_NE(svg.find("rotate(-28.65)"), std::string::npos);
  EXPECT_EQ(svg.find("glyph"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</text>\n</svg>\n")) << "above everything else";
}

TEST_F(CanvasFile, markup_takes_less_room_than_its_characters) {
  const Canvas canvas(path("a.svg"), 100.0, 100.0);
  const TextStyle style{.size = 10.0};
  const double plain = canvas.text_width("vAB", style);
  const double subscript = canvas.text_width("v_{AB}", style);
  EXPECT_LT(subscript, plain);
  EXPECT_GT(subscript, canvas.text_width("v", style));
  EXPECT_DOUBLE_EQ(canvas.text_width("v_A", style), canvas.text_width("v_{A}", style));
  // a superscript stands above its subscript, not after it
  EXPECT_DOUBLE_EQ(canvas.text_width("v_A^{pref}", style), canvas.text_width("v^{pref}", style));
  EXPECT_GT(canvas.text_width("*v*", style), canvas.text_width("v", style));
  for (const char* odd : {"_", "^", "v_", "v_{", "*", "", "_π"}) {
    EXPECT_GE(canvas.text_width(odd, style), 0.0) << odd;
  }
}

}  // namespace
}  // namespace avo::figures
