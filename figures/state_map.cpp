// SPDX-License-Identifier: Apache-2.0
#include "figures/state_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "figures/axes.h"
#include "figures/colors.h"
#include "figures/walls.h"

namespace avo::figures {
namespace {

constexpr int kUsualCells = 160;
constexpr double kMapTop = 18.0, kMapRight = 8.0, kLegend = 20.0;  // pt
constexpr Color kUnknown{0.93, 0.86, 0.68, 1.0};
constexpr Color kDoomed{0.66, 0.16, 0.12, 1.0};
constexpr Color kRobot = kBlue;

Color color_of(SafetyState state) {
  if (state == SafetyState::unknown) return kUnknown;
  return state == SafetyState::safe ? kWhite : kDoomed;
}

// The states of the cells of a view, by rows from below.
struct StateGrid {
  Vec2 lower, cell;
  std::size_t columns = 0, rows = 0;
  std::vector<SafetyState> states;

  SafetyState at(std::size_t column, std::size_t row) const {
    return states[row * columns + column];
  }
};

StateGrid judged(const Simulation::Perception& perception, const Planner& planner, const Box& view,
                 int cells) {
  const Vec2 size = view.upper - view.lower;
  const double side = std::max(size.x, size.y) / cells;
  StateGrid grid;
  grid.columns = static_cast<std::size_t>(std::max(std::round(size.x / side), 1.0));
  grid.rows = static_cast<std::size_t>(std::max(std::round(size.y / side), 1.0));
  grid.lower = view.lower;
  grid.cell = {size.x / static_cast<double>(grid.columns), size.y / static_cast<double>(grid.rows)};
  PlanWorkspace workspace;
  Robot robot = perception.robot;
  robot.loiter.reset();  // an airplane's circle lies beside the hypothetical place
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns; ++column) {
      robot.position = grid.lower + Vec2{(static_cast<double>(column) + 0.5) * grid.cell.x,
                                         (static_cast<double>(row) + 0.5) * grid.cell.y};
      grid.states.push_back(
          planner.state(robot, perception.neighbors, workspace, perception.walls).state);
    }
  }
  return grid;
}

// Fills adjacent cells of one state at once; they are slightly enlarged so that no seams show.
void fill_cells(Canvas& canvas, const StateGrid& grid, SafetyState state) {
  constexpr double kOverlap = 0.06;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    for (std::size_t column = 0; column < grid.columns;) {
      std::size_t end = column;
      while (end < grid.columns && grid.at(end, row) == state) ++end;
      if (end == column) {
        ++column;
        continue;
      }
      const auto corner = [&](std::size_t x, std::size_t y, double off) {
        return grid.lower + Vec2{(static_cast<double>(x) + off) * grid.cell.x,
                                 (static_cast<double>(y) + off) * grid.cell.y};
      };
      canvas.add_box({corner(column, row, -kOverlap), corner(end, row + 1, kOverlap)});
      column = end;
    }
  }
  canvas.fill(color_of(state));
}

void draw_others(Canvas& canvas, const Simulation::Perception& perception) {
  std::vector<StaticObstacle> walls;
  for (const Wall& wall : perception.walls)
    walls.push_back({{Chain{wall.a == wall.b ? std::vector{wall.a} : std::vector{wall.a, wall.b}}},
                     wall.radius});
  draw_walls(canvas, walls);
  const Stroke arrow{gray(0.1), 1.0};
  for (const Neighbor& neighbor : perception.neighbors) {
    const double level = neighbor.behavior == Behavior::decides ? 0.75 : 0.45;
    canvas.add_disc({neighbor.position, neighbor.radius});
    canvas.fill_and_stroke(gray(level), {gray(0.1), 0.8});
    if (norm(neighbor.velocity) > 0.0)
      canvas.arrow(neighbor.position, neighbor.position + neighbor.velocity, arrow, 5.0);
  }
  const Robot& robot = perception.robot;
  canvas.add_disc({robot.position, robot.radius});
  canvas.stroke({kRobot, 1.2});
  if (norm(robot.velocity) > 0.0)
    canvas.arrow(robot.position, robot.position + robot.velocity, {kRobot, 1.2}, 5.0);
}

// Draws the legend below the axes.
void draw_legend(Canvas& canvas, const Box& page) {
  double x = page.lower.x;
  const double y = page.upper.y + kAxesBottom + 2.0;
  for (const SafetyState state : {SafetyState::safe, SafetyState::unknown, SafetyState::doomed}) {
    canvas.add_page_box({{x, y}, {x + 9.0, y + 9.0}});
    canvas.fill_and_stroke(color_of(state), {gray(0.3), 0.5});
    const TextStyle style{.size = 8.5};
    canvas.plain_page_text({x + 13.0, y + 8.0}, to_string(state), style);
    x += 28.0 + canvas.text_width(to_string(state), style);
  }
}

}  // namespace

Box view_of_states(const Simulation::Perception& perception) {
  const Robot& robot = perception.robot;
  double largest = robot.radius;
  for (const Neighbor& neighbor : perception.neighbors)
    largest = std::max(largest, neighbor.radius);
  const double speed = std::max(norm(robot.velocity), 0.5 * robot.max_speed);
  const double braking = 0.5 * speed * speed / robot.max_acceleration;
  return grown({robot.position, robot.position}, 2.0 * braking + 2.0 * (robot.radius + largest));
}

void draw_state_map(Canvas& canvas, const Box& page, const Simulation::Perception& perception,
                    const Planner& planner, const Box& view, int cells,
                    const FigureOptions& options) {
  canvas.set_view(page, view);
  {
    const Canvas::ClipScope scope(canvas);
    canvas.clip_to_view();
    const StateGrid grid = judged(perception, planner, canvas.view_world(), cells);
    canvas.add_page_box(canvas.view_page());
    canvas.fill(color_of(SafetyState::safe));
    fill_cells(canvas, grid, SafetyState::unknown);
    fill_cells(canvas, grid, SafetyState::doomed);
    draw_others(canvas, perception);
  }
  if (options.axes)
    draw_axes(canvas,
              {.x_label = "x (m)", .y_label = "y (m)", .most_ticks_x = 6, .most_ticks_y = 6});
  if (!options.title.empty())
    canvas.plain_page_text({0.5 * (page.lower.x + page.upper.x), page.lower.y - 6.0}, options.title,
                           {.size = 9.5, .color = gray(0.1), .align_x = 0.5});
}

std::string draw_state_map(const Simulation::Perception& perception, const Planner& planner,
                           const std::string& path, const FigureOptions& options) {
  const Box view = view_of_states(perception);
  const double left = axes_left(path, view, {.most_ticks_y = kMostTicks});
  const double side = options.width - left - kMapRight;
  Canvas canvas(path, options.width, kMapTop + side + kAxesBottom + kLegend);
  const Box page{{left, kMapTop}, {left + side, kMapTop + side}};
  draw_state_map(canvas, page, perception, planner, view, kUsualCells, options);
  draw_legend(canvas, page);
  return canvas.finish();
}

}  // namespace avo::figures
