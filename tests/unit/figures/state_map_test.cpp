// SPDX-License-Identifier: Apache-2.0
// The colors of a map of states against the planner's answers.
#include "figures/state_map.h"

#include <array>
#include <cmath>

#include "avo/error.h"
#include "picture.h"

namespace avo::figures {
namespace {

class StateMapFile : public FigureFile {};

constexpr double kPage = 200.0;  // pt

// At 2 m/s to the right, beside a wall and one that comes.
Simulation::Perception some_perception() {
  Simulation::Perception seen;
  seen.robot.position = {-3.4, -3.4};
  seen.robot.velocity = {2.0, 0.0};
  seen.neighbors = {{.position = {1.5, 1.8}, .velocity = {-1.0, 0.0}}};
  seen.source = {1};
  seen.walls = {{{1.0, -3.0}, {1.0, -0.5}, 0.0}};
  return seen;
}

// How many places have which state, drawn as the planner answers it.
std::array<int, 3> drawn_states(const Simulation::Perception& seen, const std::string& file) {
  const Planner planner({});
  constexpr int kCells = 80;
  const Box view{{-4.0, -4.0}, {4.0, 4.0}};
  Canvas canvas(file, kPage, kPage);
  draw_state_map(canvas, {{0.0, 0.0}, {kPage, kPage}}, seen, planner, view, kCells,
                 {.axes = false});
  std::array<int, 3> counts{};
  std::vector<Vec2> places;
  for (int k = 0; k < kCells * kCells; ++k) {  // away from what is drawn on top
    const Vec2 place{-3.95 + 0.1 * (k % kCells), -3.95 + 0.1 * (k / kCells)};
    const bool covered = norm(place - seen.robot.position) < 2.7 || std::abs(place.x - 1.0) < 0.2 ||
                         norm(place - seen.neighbors[0].position) < 1.2;
    if (!covered) places.push_back(place);
  }
  std::vector<Vec2> page;
  for (const Vec2 place : places) page.push_back(canvas.to_page(place));
  write_bytes(file, canvas.finish());
  const Picture picture = read_png(file);
  PlanWorkspace workspace;
  for (std::size_t k = 0; k < places.size(); ++k) {
    Robot robot = seen.robot;
    robot.position = places[k], robot.loiter.reset();
    const SafetyState state = planner.state(robot, seen.neighbors, workspace, seen.walls).state;
    const png_byte* pixel = picture.at(page[k].x, page[k].y);
    const SafetyState drawn = pixel[1] < 100   ? SafetyState::doomed
                              : pixel[2] < 220 ? SafetyState::unknown
                                               : SafetyState::safe;
    EXPECT_EQ(drawn, state) << places[k].x << ", " << places[k].y;
    ++counts[static_cast<std::size_t>(state)];
  }
  return counts;
}

TEST_F(StateMapFile, colors_are_the_states_of_the_robot_at_each_place) {
  for (const int count : drawn_states(some_perception(), path("a.png"))) EXPECT_GT(count, 100);
}

// Its circle goes with it.
TEST_F(StateMapFile, an_airplane_is_safe_where_its_circle_would_be_clear) {
  Simulation::Perception seen = some_perception();
  const Airplane airplane;
  seen.robot.model = airplane;
  seen.robot.velocity = {1.0, 0.0};
  seen.robot.loiter = loiter_circle(airplane, seen.robot.position, seen.robot.velocity);
  const auto [unknown, safe, doomed] = drawn_states(seen, path("a.png"));
  EXPECT_GT(unknown, 100);
  EXPECT_GT(safe, 100);
  EXPECT_EQ(doomed, 0);
}

TEST_F(StateMapFile, a_figure_of_its_own_shows_the_robot_and_what_it_may_touch) {
  const Simulation::Perception seen = some_perception();
  const Box view = view_of_states(seen);
  EXPECT_LT(view.lower.x, seen.robot.position.x - 2.0);
  EXPECT_GT(view.upper.x, seen.robot.position.x + 2.0);
  for (const char* name : {"a.svg", "a.png", "a.pdf"})
    EXPECT_GT(draw_state_map(seen, Planner({}), path(name)).size(), 1000U);
  EXPECT_THROW((void)draw_state_map(seen, Planner({}), path("a.txt")), Error);
}

}  // namespace
}  // namespace avo::figures
