// SPDX-License-Identifier: Apache-2.0
// Static obstacles in a time-lapse: lines, thick walls, discs, solids with holes, bounds.
#include "figures/walls.h"

#include "figures/time_lapse.h"
#include "figures/trajectories.h"
#include "picture.h"

namespace avo::figures {
namespace {

class WallsFile : public FigureFile {};

Chain square(Vec2 lower, double side) {
  return {{lower, lower + Vec2{side, 0}, lower + Vec2{side, side}, lower + Vec2{0, side}}, true};
}

// One robot at rest in the middle of a room of 20 x 20 m, and what stands in it.
Scenario room() {
  Scenario scenario;
  scenario.name = "room";
  scenario.robots.resize(1);
  scenario.robots[0].position = scenario.robots[0].goal = {10, 10};
  scenario.obstacles = {{{square({0, 0}, 20)}, 0.0, Fill::none},
                        {{square({2, 2}, 4), square({3, 3}, 2)}, 0.0, Fill::solid},
                        {{{{{15, 4}}}}, 2.0},
                        {{{{{4, 16}, {9, 16}}}}, 1.0}};
  return scenario;
}

// The drawing of 20 x 20 m in a page without axes, 8 pt from its edges.
struct Drawing {
  Picture picture;
  Box world;
  int brightness(Vec2 at) const {
    const double scale =
        (0.5 * static_cast<double>(picture.width) - 16.0) / (world.upper.x - world.lower.x);
    return picture.brightness(8.0 + scale * (at.x - world.lower.x),
                              8.0 + scale * (world.upper.y - at.y));
  }
};

Drawing draw(const Scenario& scenario, const std::string& path) {
  const std::vector<TrajectoryFrame> frames{
      {.time = 0.0, .position = {scenario.robots[0].position}}};
  write_bytes(path, draw_trajectories(scenario, frames, path, {.width = 316.0, .axes = false}));
  return {read_png(path), grown(covered(scenario, frames, 0, 0), 0.6)};
}

constexpr int kPaper = 255;

TEST_F(WallsFile, walls_are_drawn_and_solids_filled) {
  const Drawing drawing = draw(room(), path("a.png"));
  EXPECT_EQ(drawing.world.lower, (Vec2{-0.6, -0.6}));
  EXPECT_EQ(drawing.world.upper, (Vec2{20.6, 20.6}));
  EXPECT_LT(drawing.brightness({0, 12}), 140) << "a line without thickness";
  EXPECT_LT(drawing.brightness({12, 20}), 140);
  EXPECT_LT(drawing.brightness({2.5, 2.5}), 200) << "solid";
  EXPECT_EQ(drawing.brightness({4, 4}), kPaper) << "its hole";
  EXPECT_LT(drawing.brightness({15, 5.8}), 100) << "disc";
  EXPECT_EQ(drawing.brightness({15, 6.3}), kPaper);
  EXPECT_LT(drawing.brightness({6.5, 16.9}), 100) << "thick wall";
  EXPECT_LT(drawing.brightness({3.1, 16}), 100) << "and its round ends";
  EXPECT_LT(drawing.brightness({4.2, 16.6}), 100) << "filled where parts overlap";
  EXPECT_EQ(drawing.brightness({6.5, 17.2}), kPaper);
  EXPECT_EQ(drawing.brightness({12, 12}), kPaper) << "the room itself";
}

TEST_F(WallsFile, beyond_bounds_is_filled) {
  Scenario scenario = room();
  scenario.obstacles = {{{square({0, 0}, 20)}, 0.0, Fill::bounds}};
  const Drawing drawing = draw(scenario, path("a.png"));
  EXPECT_LT(drawing.brightness({-0.4, 12}), 200);
  EXPECT_EQ(drawing.brightness({3, 12}), kPaper);
}

TEST_F(WallsFile, the_svg_holds_every_wall) {
  Scenario scenario = room();
  const std::vector<TrajectoryFrame> frames{{.time = 0.0, .position = {{10, 10}}}};
  const auto lines = [&] {
    const std::string svg = draw_trajectories(scenario, frames, "a.svg");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = svg.find("<path", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  const std::size_t all = lines();
  scenario.obstacles.pop_back();
  EXPECT_LT(lines(), all) << "the thick wall";
  scenario.obstacles.pop_back();
  EXPECT_LT(lines(), all - 1) << "the disc";
  scenario.obstacles = {{{square({0, 0}, 20)}}};
  EXPECT_EQ(lines(), all - 11) << "besides, eight sides and one area";
}

TEST(Walls, are_covered_by_the_view) {
  EXPECT_FALSE(covered(std::vector<StaticObstacle>{}));
  const Box box = *covered(std::vector<StaticObstacle>{{{{{{1, 2}, {5, 2}}}}, 0.5}});
  EXPECT_EQ(box.lower, (Vec2{0.5, 1.5}));
  EXPECT_EQ(box.upper, (Vec2{5.5, 2.5}));
}

}  // namespace
}  // namespace avo::figures
