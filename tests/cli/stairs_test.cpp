// SPDX-License-Identifier: Apache-2.0
// The maps have stairs of cells. The tests check which stairs become straight, how far, and which
// walls a judge uses for which robots.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo_io/judgement.h"
#include "avo_io/scene.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using avo::Chain;
using avo::Vec2;

/// The obstacle of a MovingAI map, all around it blocked, with one robot far away.
avo::StaticObstacle map_of(const std::vector<std::string>& rows, double radius, double cell = 1) {
  std::string text = "type octile\nheight " + std::to_string(rows.size()) + "\nwidth " +
                     std::to_string(rows[0].size()) + "\nmap\n";
  for (const std::string& row : rows) text += row + "\n";
  write_file(path_of("a.map"), text);
  return avo_io::parse_scenario(
             "version: 1\nobstacles: [{map: a.map, cell: " + std::to_string(cell) +
                 "}]\nrobots: [{position: [900, 900], goal: [900, 900], radius: " +
                 std::to_string(radius) + "}]\n",
             path_of("s.yaml"))
      .obstacles.at(0);
}

double distance_to(Vec2 point, const std::vector<Chain>& chains) {
  double least = 1e9;
  for (const avo::Wall& wall : avo::walls_of(std::vector<avo::StaticObstacle>{{chains}})) {
    const Vec2 along = wall.b - wall.a;
    const double part = std::clamp(dot(point - wall.a, along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, norm(point - (wall.a + part * along)));
  }
  return least;
}

/// By the even-odd rule.
bool is_inside(Vec2 point, const std::vector<Chain>& chains) {
  bool inside = false;
  for (const avo::Wall& wall : avo::walls_of(std::vector<avo::StaticObstacle>{{chains}})) {
    if ((wall.a.y > point.y) == (wall.b.y > point.y)) continue;
    const double x =
        wall.a.x + (point.y - wall.a.y) / (wall.b.y - wall.a.y) * (wall.b.x - wall.a.x);
    inside = inside != (point.x < x);
  }
  return inside;
}

const std::vector<std::string> kSlope{"......", "@.....", "@@....", "@@@...", "@@@@.."};

TEST(Stairs, become_one_wall_where_robots_are_large) {
  const avo::StaticObstacle slope = map_of(kSlope, 4.1);
  ASSERT_EQ(slope.chains.size(), 1U);
  EXPECT_EQ(slope.chains[0].points,
            (std::vector<Vec2>{{4, 0}, {6, 0}, {6, 5}, {0, 5}, {0, 4}, {1, 4}, {4, 1}}));
  EXPECT_EQ(slope.measured.at(0).points.size(), 12U) << "as the map has them";
}

// Steps of one cell and of two cells alternate. The last cell of a step of two goes with the step
// of one cell behind it.
TEST(Stairs, longer_steps_go_on_with_shorter_ones) {
  const avo::StaticObstacle slope =
      map_of({"........", "@@......", "@@@.....", "@@@@@...", "@@@@@@.."}, 100);
  ASSERT_EQ(slope.chains.size(), 1U);
  EXPECT_EQ(
      slope.chains[0].points,
      (std::vector<Vec2>{{6, 0}, {8, 0}, {8, 5}, {0, 5}, {0, 4}, {2, 4}, {4, 2}, {5, 2}, {6, 1}}));
  EXPECT_EQ(slope.measured.at(0).points.size(), 12U);
}

TEST(Stairs, stay_where_a_robot_is_smaller_than_four_cells) {
  const avo::StaticObstacle slope = map_of(kSlope, 4.0);
  EXPECT_EQ(slope.chains.at(0).points.size(), 12U);
  EXPECT_TRUE(slope.measured.empty());
}

TEST(Stairs, the_smallest_robot_decides) {
  map_of(kSlope, 4.1);
  for (const char* more : {"", "{position: [800, 800], goal: [0, 0], radius: 3}"}) {
    const auto scenario = avo_io::parse_scenario(
        std::string("version: 1\nobstacles: [{map: a.map}]\nrobots: [{position: [900, 900], goal: "
                    "[900, 900], radius: 5}, ") +
            more + "]\n",
        path_of("s.yaml"));
    EXPECT_EQ(scenario.obstacles[0].measured.empty(), *more != '\0');
  }
}

TEST(Stairs, other_corners_stay) {
  for (const std::vector<std::string>& rows :
       {std::vector<std::string>{"....", ".@@.", ".@@.", "...."},  // a block
        {"@@@", "@.@", "@@@"},                                     // a cell
        {"......", "@@....", "@@@@.."}}) {                         // steps of two
    const avo::StaticObstacle obstacle = map_of(rows, 100);
    EXPECT_TRUE(obstacle.measured.empty()) << rows[1];
  }
}

// A grid of cells is laid over free space, in it and beyond: what is lost is near the map's own
// walls, and nothing is won.
TEST(Stairs, free_space_shrinks_by_half_a_cell_at_most) {
  std::uint32_t seed = 1;
  const auto draw = [&seed] { return (seed = seed * 1664525 + 1013904223) >> 8U; };
  int lost = 0;
  for (int round = 0; round < 20; ++round) {
    const int side = 14;
    std::vector<std::string> rows(side, std::string(side, '.'));
    for (int y = 0; y < side; ++y)  // a slanting wall, and a few cells by chance
      for (int x = 0; x < side; ++x)
        if (x + y < 6 + round % 8 || (x - y) * (round % 3) > 9 || draw() % 12 == 0)
          rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] = '@';
    const avo::StaticObstacle map = map_of(rows, 100);
    if (map.measured.empty()) continue;
    for (int k = 0; k < 4000; ++k) {
      const Vec2 point{draw() % 15000 / 1000.0 + 1e-5, draw() % 15000 / 1000.0 + 1e-5};
      const bool before = is_inside(point, map.measured), after = is_inside(point, map.chains);
      EXPECT_TRUE(before || !after) << "won";
      if (before == after) continue;
      EXPECT_LE(distance_to(point, map.measured), 0.5 + 1e-9);
      ++lost;
    }
    for (const avo::Wall& wall : avo::walls_of(std::vector<avo::StaticObstacle>{{map.chains}}))
      for (int part = 0; part <= 20; ++part)
        EXPECT_LE(distance_to(wall.a + part / 20.0 * (wall.b - wall.a), map.measured), 0.5 + 1e-9);
  }
  EXPECT_GT(lost, 100);
}

TEST(Stairs, a_judge_looks_at_the_walls_of_the_map_too) {
  avo::Scenario scenario = avo_io::load_scenario("circle-2");
  scenario.obstacles = {{{Chain{{{500, 0}, {500, 1}}}}}};
  write_file(path_of("r.csv"),
             "time,robot,x,y,vx,vy\n0,0,20,0,0,0\n0,1,0,0,0,0\n0.1,0,20,0,0,0\n0.1,1,0,0,0,0\n");
  EXPECT_EQ(avo_io::judge(path_of("r.csv"), {.scenario = scenario}).report.static_contacts.count,
            0);
  scenario.obstacles[0].measured = {Chain{{{0.4, 0}, {0.4, 1}}}};
  const avo_io::Judgement found = avo_io::judge(path_of("r.csv"), {.scenario = scenario});
  EXPECT_EQ(found.report.static_contacts.count, 1);
  EXPECT_EQ(found.obstacle_of_wall, (std::vector<std::int64_t>{0, 0}));
}

TEST(Stairs, a_run_beside_them_is_safe_by_both_walls) {
  std::vector<std::string> rows(80, std::string(80, '.'));
  for (std::size_t y = 0; y < 80; ++y)
    for (std::size_t x = 0; x < 80; ++x)
      if (x + y < 70) rows[y][x] = '@';
  map_of(rows, 0.5, 0.1);
  const std::string scene = path_of("s.yaml"), recording = path_of("r.h5");
  write_file(scene,
             "version: 1\nobstacles: [{map: a.map, cell: 0.1}]\nduration: 20\n"
             "robots: [{position: [2.2, 2.4], goal: [6.5, 6.7], radius: 0.45}]\n");
  EXPECT_NE(run_avo({"validate", scene}).out.find(" 5 walls"), std::string::npos);
  EXPECT_EQ(run_avo({"run", scene, "--record", recording, "-q"}).exit_code, 0);
  EXPECT_EQ(run_avo({"check", recording, "--require-arrival"}).exit_code, 0);
}

}  // namespace
}  // namespace avo_test
