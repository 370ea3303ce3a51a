// SPDX-License-Identifier: Apache-2.0
#include "figures/trajectories.h"

#include <cmath>

#include "avo/error.h"
#include "figures/axes.h"
#include "figures/time_lapse.h"
#include "picture.h"

namespace avo::figures {
namespace {

class TrajectoriesFile : public FigureFile {};

// Without axes the view begins 8 pt from the edges of the page.
const FigureOptions kBare{.width = 216.0, .axes = false};

// One robot that goes 4 m to the right and back 2 m, and a mover far above.
struct Drive {
  Scenario scenario;
  std::vector<TrajectoryFrame> frames;
};

Drive there_and_back() {
  Drive run;
  run.scenario.name = "there and back";
  run.scenario.robots.resize(1);
  run.scenario.robots[0].goal = {2.0, 0.0};
  run.scenario.moving_obstacles.resize(1);
  for (int k = 0; k <= 60; ++k) {
    const double t = 0.1 * k;
    const double x = t <= 4.0 ? t : 8.0 - t;
    run.frames.push_back({.time = t, .position = {{x, 0.0}}, .mover_position = {{t, 4.0}}});
  }
  return run;
}

// World to page of a figure without axes: the same margins as the drawing has.
struct Map {
  double scale, left, top;
  Vec2 upper_left;
  Map(const Box& covered, double width, const Picture& picture) {
    const Vec2 size = covered.upper - covered.lower;
    const Box world = grown(covered, 0.03 * std::fmax(size.x, size.y));
    scale = (width - 16.0) / (world.upper.x - world.lower.x);
    left = 8.0;
    top = 0.5 * static_cast<double>(picture.height) * 0.5 -
          0.5 * scale * (world.upper.y - world.lower.y);
    upper_left = {world.lower.x, world.upper.y};
  }
  [[nodiscard]] Vec2 operator()(Vec2 at) const {
    return {left + scale * (at.x - upper_left.x), top + scale * (upper_left.y - at.y)};
  }
};

TEST_F(TrajectoriesFile, newer_discs_are_darker_and_on_top) {
  const Drive run = there_and_back();
  write_bytes(path("a.png"), draw_trajectories(run.scenario, run.frames, path("a.png"), kBare));
  const Picture picture = read_png(path("a.png"));
  const Map map({{-0.5, -0.5}, {6.5, 4.5}}, 216.0, picture);
  const auto brightness = [&](Vec2 world) {
    const Vec2 page = map(world);
    return picture.brightness(page.x, page.y);
  };
  const Vec2 off_center{0.0, 0.25};  // beside the path and the cross of the goal
  const int oldest = brightness(off_center);
  const int turn = brightness(Vec2{4.0, 0.0} + off_center);
  const int newest = brightness(Vec2{2.0, 0.0} + off_center);
  EXPECT_GT(oldest, turn + 20);
  EXPECT_GT(turn, newest + 20);  // the path to the turn passes below it, halfway through the run
  EXPECT_EQ(brightness({5.5, 2.0}), 255);
}

TEST_F(TrajectoriesFile, robots_can_be_left_out_and_the_others_keep_their_colors) {
  Drive run = there_and_back();
  run.scenario.robots.resize(2);
  run.scenario.robots[1].goal = {2.0, -3.0};
  for (TrajectoryFrame& frame : run.frames)
    frame.position.push_back(frame.position[0] + Vec2{0.0, -3.0});
  const auto drawn = [&](std::vector<std::size_t> robots) {
    FigureOptions options{.width = 216.0, .height = 120.0, .axes = false};
    options.robots = std::move(robots);
    const std::string bytes = draw_trajectories(run.scenario, run.frames, path("r.png"), options);
    write_bytes(path("r.png"), bytes);
    return read_png(path("r.png"));
  };
  const auto pixels_like = [](const Picture& picture, Color color) {
    std::size_t found = 0;
    for (std::size_t k = 0; k < picture.rgb.size(); k += 3)
      if (std::abs(picture.rgb[k] - 255.0 * color.red) < 3.0 &&
          std::abs(picture.rgb[k + 1] - 255.0 * color.green) < 3.0 &&
          std::abs(picture.rgb[k + 2] - 255.0 * color.blue) < 3.0)
        ++found;
    return found;
  };
  const std::vector<Color> colors = robot_colors(run.scenario);
  const Picture both = drawn({}), second = drawn({1});
  EXPECT_EQ(second.height, 240U);
  EXPECT_GT(pixels_like(both, colors[0]), 50U);
  EXPECT_GT(pixels_like(both, colors[1]), 50U);
  EXPECT_EQ(pixels_like(second, colors[0]), 0U);
  EXPECT_GT(pixels_like(second, colors[1]), 50U);
}

TEST_F(TrajectoriesFile, movers_are_gray) {
  const Drive run = there_and_back();
  write_bytes(path("a.png"), draw_trajectories(run.scenario, run.frames, path("a.png"), kBare));
  const Picture picture = read_png(path("a.png"));
  const Map map({{-0.5, -0.5}, {6.5, 4.5}}, 216.0, picture);
  const Vec2 mover = map({6.0, 4.1});
  const png_byte* pixel = picture.at(mover.x, mover.y);
  EXPECT_NEAR(pixel[0], pixel[1], 2);
  EXPECT_NEAR(pixel[1], pixel[2], 2);
  EXPECT_LT(pixel[0], 120);
}

TEST_F(TrajectoriesFile, a_car_shows_its_heading) {
  Drive run = there_and_back();
  run.scenario.moving_obstacles.clear();
  run.scenario.robots[0].model = Car{};
  run.scenario.robots[0].goal = {1.0, 0.9};
  run.frames.resize(1);
  run.frames[0].mover_position.clear();
  for (const double heading : {0.0, 1.5707963267948966}) {
    run.frames[0].heading = {heading};
    write_bytes(path("a.png"), draw_trajectories(run.scenario, run.frames, path("a.png"), kBare));
    const Picture picture = read_png(path("a.png"));
    const Map map({{-0.5, -0.5}, {1.0, 0.9}}, 216.0, picture);
    const Vec2 ahead{0.4 * std::cos(heading), 0.4 * std::sin(heading)};
    const Vec2 nose = map(ahead);
    const Vec2 flank = map(perpendicular(ahead));
    EXPECT_LT(picture.brightness(nose.x, nose.y) + 50, picture.brightness(flank.x, flank.y));
  }
}

TEST_F(TrajectoriesFile, instants_show_each_time_once) {
  const Drive run = there_and_back();
  const double times[] = {0.0, 3.0, 6.0};
  write_bytes(path("a.svg"), draw_instants(run.scenario, run.frames, times, 1.0, path("a.svg")));
  const std::string one = read_bytes(path("a.svg"));
  write_bytes(path("b.svg"), draw_instants(run.scenario, run.frames, std::span(times).first(1), 1.0,
                                           path("b.svg")));
  EXPECT_GT(one.size(), read_bytes(path("b.svg")).size());
}

TEST_F(TrajectoriesFile, a_run_of_a_single_frame_and_of_nobody_can_be_drawn) {
  Drive run = there_and_back();
  run.frames.resize(1);
  EXPECT_TRUE(draw_trajectories(run.scenario, run.frames, "one.svg").ends_with("</svg>\n"));
  run.scenario.robots.clear();
  run.scenario.moving_obstacles.clear();
  run.frames = {{.time = 0.0}, {.time = 1.0}};
  EXPECT_TRUE(draw_trajectories(run.scenario, run.frames, "nobody.svg").ends_with("</svg>\n"));
}

TEST_F(TrajectoriesFile, what_cannot_be_drawn_is_refused_before_anything_is_written) {
  const Drive run = there_and_back();
  EXPECT_THROW((void)draw_trajectories(run.scenario, run.frames, path("a.gif")), Error);
  EXPECT_THROW((void)draw_trajectories(run.scenario, {}, path("a.png")), Error);
}

}  // namespace
}  // namespace avo::figures
