// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet is from the nearest other one.
#include "avo/clearance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace avo::inline metrics {

/// The constant data of a robot.
struct ClearanceDisc {
  double radius = 0.0;  // m
  std::uint32_t layers = 0, avoids = 0;
  bool parked = false;
};

/// A square grid over all present robots, with about one cell for each.
struct FleetGrid {
  Vec2 corner;        // m, lower left
  double cell = 1.0;  // m
  std::int64_t columns = 1, rows = 1;

  [[nodiscard]] std::int64_t column(double x) const {
    return std::clamp(static_cast<std::int64_t>((x - corner.x) / cell), std::int64_t{0},
                      columns - 1);
  }
  [[nodiscard]] std::int64_t row(double y) const {
    return std::clamp(static_cast<std::int64_t>((y - corner.y) / cell), std::int64_t{0}, rows - 1);
  }
};

}  // namespace avo::inline metrics

namespace avo {
namespace {

constexpr double kNobody = std::numeric_limits<double>::infinity();

bool avoid_each_other(const ClearanceDisc& a, const ClearanceDisc& b) {
  return (a.avoids & b.layers) != 0 && (b.avoids & a.layers) != 0 && !(a.parked && b.parked);
}

FleetGrid grid_over(std::span<const Vec2> centers, std::size_t count) {
  Vec2 low{kNobody, kNobody}, high{-kNobody, -kNobody};
  for (const Vec2 center : centers) {
    if (std::isnan(center.x)) continue;
    low = {std::min(low.x, center.x), std::min(low.y, center.y)};
    high = {std::max(high.x, center.x), std::max(high.y, center.y)};
  }
  FleetGrid grid{.corner = low};
  const double size = std::max(high.x - low.x, high.y - low.y);
  const double side = std::ceil(std::sqrt(static_cast<double>(count)));
  if (!(size > 0.0)) return grid;
  grid.cell = size / side;
  grid.columns = static_cast<std::int64_t>((high.x - low.x) / grid.cell) + 1;
  grid.rows = static_cast<std::int64_t>((high.y - low.y) / grid.cell) + 1;
  return grid;
}

}  // namespace

struct ClearanceFinder::State {
  std::vector<MotionModel> models;
  std::vector<ClearanceDisc> discs;
  double largest_radius = 0.0;  // m
  std::vector<Vec2> centers;    // of the discs
  FleetGrid grid;
  std::vector<std::uint32_t> cell_of, first, by_cell;  // robots, sorted by cell

  std::size_t place(const FleetColumns& fleet);
  void sort_by_cell(std::size_t count);
  [[nodiscard]] double clearance_of(std::size_t robot) const;
  void search_ring(std::size_t robot, std::int64_t ring, double& least) const;
  void search_cell(std::size_t robot, std::int64_t column, std::int64_t row, double& least) const;
};

// Returns the number of present robots.
std::size_t ClearanceFinder::State::place(const FleetColumns& fleet) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const Vec2 position{fleet.x[i], fleet.y[i]};
    const double heading = fleet.heading.empty() ? 0.0 : fleet.heading[i];
    const bool here = !std::isnan(position.x);
    centers[i] =
        here && !is_holonomic(models[i]) ? disc_center(models[i], position, heading) : position;
    count += here ? 1 : 0;
  }
  return count;
}

void ClearanceFinder::State::sort_by_cell(std::size_t count) {
  grid = grid_over(centers, count);
  first.assign(static_cast<std::size_t>(grid.columns * grid.rows) + 1, 0);
  for (std::size_t i = 0; i < centers.size(); ++i) {
    if (std::isnan(centers[i].x)) continue;
    cell_of[i] = static_cast<std::uint32_t>(grid.row(centers[i].y) * grid.columns +
                                            grid.column(centers[i].x));
    ++first[cell_of[i] + 1];
  }
  for (std::size_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
  for (std::size_t i = centers.size(); i-- > 0;)
    if (!std::isnan(centers[i].x)) by_cell[--first[cell_of[i] + 1]] = static_cast<std::uint32_t>(i);
  // each entry is now the start of the cell before it
  std::rotate(first.begin(), first.begin() + 1, first.end());
  first.back() = static_cast<std::uint32_t>(count);
}

void ClearanceFinder::State::search_cell(std::size_t robot, std::int64_t column, std::int64_t row,
                                         double& least) const {
  if (column < 0 || column >= grid.columns || row < 0 || row >= grid.rows) return;
  const auto cell = static_cast<std::size_t>(row * grid.columns + column);
  const ClearanceDisc& own = discs[robot];
  for (std::uint32_t k = first[cell]; k < first[cell + 1]; ++k) {
    const std::size_t other = by_cell[k];
    const double reach = least + own.radius + discs[other].radius;
    const double distance_squared = norm_squared(centers[other] - centers[robot]);
    const bool nearer = distance_squared < reach * reach && reach > 0.0;
    if (!nearer || other == robot || !avoid_each_other(own, discs[other])) continue;
    least = std::min(least, std::sqrt(distance_squared) - own.radius - discs[other].radius);
  }
}

void ClearanceFinder::State::search_ring(std::size_t robot, std::int64_t ring,
                                         double& least) const {
  const std::int64_t column = grid.column(centers[robot].x), row = grid.row(centers[robot].y);
  if (ring == 0) return search_cell(robot, column, row, least);
  for (std::int64_t k = -ring; k <= ring; ++k) {
    search_cell(robot, column + k, row - ring, least);
    search_cell(robot, column + k, row + ring, least);
  }
  for (std::int64_t k = 1 - ring; k < ring; ++k) {
    search_cell(robot, column - ring, row + k, least);
    search_cell(robot, column + ring, row + k, least);
  }
}

double ClearanceFinder::State::clearance_of(std::size_t robot) const {
  double least = kNobody;
  const double radii = discs[robot].radius + largest_radius;
  const std::int64_t rings = std::max(grid.columns, grid.rows);
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    // no robot of this ring is nearer than that; cells are found from rounded numbers
    const double nearest = static_cast<double>(ring - 1) * grid.cell * (1.0 - 1e-9);
    if (nearest - radii >= least) break;
    search_ring(robot, ring, least);
  }
  return least;
}

ClearanceFinder::ClearanceFinder(const Scenario& scenario) : state_(std::make_unique<State>()) {
  for (const RobotSetup& robot : scenario.robots) {
    state_->models.push_back(robot.model);
    state_->discs.push_back(
        {disc_radius(robot), robot.layers.bits, robot.avoids.bits, robot.parked});
    state_->largest_radius = std::max(state_->largest_radius, disc_radius(robot));
  }
  state_->centers.resize(scenario.robots.size());
  state_->cell_of.resize(scenario.robots.size());
  state_->by_cell.resize(scenario.robots.size());
}
ClearanceFinder::~ClearanceFinder() = default;
ClearanceFinder::ClearanceFinder(ClearanceFinder&&) noexcept = default;
ClearanceFinder& ClearanceFinder::operator=(ClearanceFinder&&) noexcept = default;

void ClearanceFinder::find(const FleetColumns& fleet, std::span<float> clearance) {
  const std::size_t count = state_->place(fleet);
  if (count > 0) state_->sort_by_cell(count);
  for (std::size_t i = 0; i < clearance.size(); ++i)
    clearance[i] = std::isnan(state_->centers[i].x) ? std::numeric_limits<float>::quiet_NaN()
                                                    : static_cast<float>(state_->clearance_of(i));
}

}  // namespace avo
