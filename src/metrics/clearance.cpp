// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet is from the nearest other one.
#include "avo/clearance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/elementary.h"

namespace avo::inline metrics {

/// The constant data of a robot's disc, or of one disc of its footprint.
struct ClearanceDisc {
  double radius = 0.0;  // m
  std::uint32_t layers = 0, avoids = 0;
  bool parked = false;
  double ahead = 0.0;     // m, from the center of the disc that others sense
  std::size_t robot = 0;  // that it belongs to
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

// As avoids() of the robots, both ways.
bool avoid_each_other(const ClearanceDisc& a, const ClearanceDisc& b) {
  if (a.parked || b.parked) return a.parked != b.parked;
  return (a.avoids & b.layers) != 0 && (b.avoids & a.layers) != 0;
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
  double largest_radius = 0.0;          // m
  std::vector<Vec2> centers;            // of the discs
  std::vector<std::size_t> first_disc;  // of each robot, and behind the last one
  FleetGrid grid;
  std::vector<std::uint32_t> cell_of, first, by_cell;  // robots, sorted by cell

  std::size_t place(const FleetColumns& fleet);
  void sort_by_cell(std::size_t count);
  [[nodiscard]] double clearance_of(std::size_t disc) const;
  void search_ring(std::size_t disc, std::int64_t ring, double& least) const;
  void search_cell(std::size_t disc, std::int64_t column, std::int64_t row, double& least) const;
};

// Returns the number of discs of the robots that are present.
std::size_t ClearanceFinder::State::place(const FleetColumns& fleet) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Vec2 position{fleet.x[i], fleet.y[i]};
    const double heading = fleet.heading.empty() ? 0.0 : fleet.heading[i];
    const bool here = !std::isnan(position.x), turns = here && !is_holonomic(models[i]);
    const Vec2 center = turns ? disc_center(models[i], position, heading) : position;
    const Vec2 ahead = turns ? elementary::direction(heading) : Vec2{};
    for (std::size_t k = first_disc[i]; k < first_disc[i + 1]; ++k)
      centers[k] = discs[k].ahead == 0.0 ? center : center + discs[k].ahead * ahead;
    count += here ? first_disc[i + 1] - first_disc[i] : 0;
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

void ClearanceFinder::State::search_cell(std::size_t disc, std::int64_t column, std::int64_t row,
                                         double& least) const {
  if (column < 0 || column >= grid.columns || row < 0 || row >= grid.rows) return;
  const auto cell = static_cast<std::size_t>(row * grid.columns + column);
  const ClearanceDisc& own = discs[disc];
  for (std::uint32_t k = first[cell]; k < first[cell + 1]; ++k) {
    const std::size_t other = by_cell[k];
    const double reach = least + own.radius + discs[other].radius;
    const double distance_squared = norm_squared(centers[other] - centers[disc]);
    const bool nearer = distance_squared < reach * reach && reach > 0.0;
    if (!nearer || discs[other].robot == own.robot || !avoid_each_other(own, discs[other]))
      continue;
    least = std::min(least, std::sqrt(distance_squared) - own.radius - discs[other].radius);
  }
}

void ClearanceFinder::State::search_ring(std::size_t disc, std::int64_t ring, double& least) const {
  const std::int64_t column = grid.column(centers[disc].x), row = grid.row(centers[disc].y);
  if (ring == 0) return search_cell(disc, column, row, least);
  for (std::int64_t k = -ring; k <= ring; ++k) {
    search_cell(disc, column + k, row - ring, least);
    search_cell(disc, column + k, row + ring, least);
  }
  for (std::int64_t k = 1 - ring; k < ring; ++k) {
    search_cell(disc, column - ring, row + k, least);
    search_cell(disc, column + ring, row + k, least);
  }
}

double ClearanceFinder::State::clearance_of(std::size_t disc) const {
  double least = kNobody;
  const double radii = discs[disc].radius + largest_radius;
  const std::int64_t rings = std::max(grid.columns, grid.rows);
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    // no robot of this ring is nearer than that; cells are found from rounded numbers
    const double nearest = static_cast<double>(ring - 1) * grid.cell * (1.0 - 1e-9);
    if (nearest - radii >= least) break;
    search_ring(disc, ring, least);
  }
  return least;
}

ClearanceFinder::ClearanceFinder(const Scenario& scenario) : state_(std::make_unique<State>()) {
  for (const RobotSetup& robot : scenario.robots) {
    const Footprint footprint = footprint_of(robot.model);
    const double radius = footprint ? footprint.radius : disc_radius(robot);
    state_->first_disc.push_back(state_->discs.size());
    for (int k = 0; k < std::max(footprint.discs, 1); ++k)
      state_->discs.push_back({radius, robot.layers.bits, robot.avoids.bits, robot.parked,
                               footprint ? footprint.ahead(k) : 0.0, state_->models.size()});
    state_->models.push_back(robot.model);
    state_->largest_radius = std::max(state_->largest_radius, radius);
  }
  state_->first_disc.push_back(state_->discs.size());
  state_->centers.resize(state_->discs.size());
  state_->cell_of.resize(state_->discs.size());
  state_->by_cell.resize(state_->discs.size());
}
ClearanceFinder::~ClearanceFinder() = default;
ClearanceFinder::ClearanceFinder(ClearanceFinder&&) noexcept = default;
ClearanceFinder& ClearanceFinder::operator=(ClearanceFinder&&) noexcept = default;

void ClearanceFinder::find(const FleetColumns& fleet, std::span<float> clearance) {
  const std::size_t count = state_->place(fleet);
  if (count > 0) state_->sort_by_cell(count);
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    const std::size_t first = state_->first_disc[i], behind = state_->first_disc[i + 1];
    clearance[i] = std::numeric_limits<float>::quiet_NaN();
    if (std::isnan(state_->centers[first].x)) continue;
    double least = kNobody;
    for (std::size_t k = first; k < behind; ++k) least = std::min(least, state_->clearance_of(k));
    clearance[i] = static_cast<float>(least);
  }
}

}  // namespace avo
