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
#include "spatial/point_grid.h"

namespace avo::inline metrics {

/// The constant data of a robot's disc, or of one disc of its footprint.
struct ClearanceDisc {
  double radius = 0.0;  // m
  std::uint32_t layers = 0, avoids = 0;
  bool parked = false;
  double ahead = 0.0;     // m, from the center of the disc that others sense
  std::size_t robot = 0;  // that it belongs to
};

}  // namespace avo::inline metrics

namespace avo {
namespace {

constexpr double kNobody = std::numeric_limits<double>::infinity();
constexpr float kAbsent = std::numeric_limits<float>::quiet_NaN();

// As avoids() of the robots, in both directions.
bool avoid_each_other(const ClearanceDisc& a, const ClearanceDisc& b) {
  if (a.parked || b.parked) return a.parked != b.parked;
  return (a.avoids & b.layers) != 0 && (b.avoids & a.layers) != 0;
}

// m, of a square cell, so that there is about one for each disc. Absent discs are at NaN.
double side_for(std::span<const Vec2> centers, std::size_t count) {
  Vec2 low{kNobody, kNobody}, high{-kNobody, -kNobody};
  for (const Vec2 center : centers) {
    if (std::isnan(center.x)) continue;
    low = {std::min(low.x, center.x), std::min(low.y, center.y)};
    high = {std::max(high.x, center.x), std::max(high.y, center.y)};
  }
  return std::max(high.x - low.x, high.y - low.y) /
         std::ceil(std::sqrt(static_cast<double>(count)));
}

}  // namespace

struct ClearanceFinder::State {
  std::vector<MotionModel> models;
  std::vector<ClearanceDisc> discs;
  double largest_radius = 0.0;               // m
  std::vector<Vec2> centers;                 // of the discs
  std::vector<std::size_t> first_disc;       // of each robot, and behind the last one
  PointGrid grid;                            // of the centers
  double side = 0.0;                         // m, of its cells
  std::vector<std::uint32_t> near;           // places in the grid
  std::vector<std::size_t> all, not_parked;  // discs

  std::size_t place(const FleetColumns& fleet);
  [[nodiscard]] double clearance_between(std::size_t disc, std::size_t other) const;
  [[nodiscard]] double clearance_of(std::size_t disc);
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

double ClearanceFinder::State::clearance_between(std::size_t disc, std::size_t other) const {
  const ClearanceDisc &a = discs[disc], &b = discs[other];
  if (a.robot == b.robot || !avoid_each_other(a, b) || std::isnan(centers[other].x)) return kNobody;
  return norm(centers[other] - centers[disc]) - a.radius - b.radius;
}

// Searches farther until no disc beyond can be nearer, and at last among all discs that count.
double ClearanceFinder::State::clearance_of(std::size_t disc) {
  constexpr double kRounding = 1e-9;  // of a distance
  const double radii = discs[disc].radius + largest_radius;
  double least = kNobody;
  for (double radius = side; radius <= kMostSides * side && radius > 0.0; radius *= 2.0) {
    grid.list_within(centers[disc], radius, near);
    for (const std::uint32_t place : near)
      least = std::min(least, clearance_between(disc, grid.order()[place]));
    if (least + radii <= radius * (1.0 - kRounding)) return least;
  }
  for (const std::size_t other : discs[disc].parked ? not_parked : all)
    least = std::min(least, clearance_between(disc, other));
  return least;
}

ClearanceFinder::ClearanceFinder(const Scenario& scenario) : state_(std::make_unique<State>()) {
  for (const RobotSetup& robot : scenario.robots) {
    const Footprint footprint = footprint_of(robot.model);
    const double radius = footprint ? footprint.radius : disc_radius(robot);
    state_->first_disc.push_back(state_->discs.size());
    for (int k = 0; k < std::max(footprint.discs, 1); ++k) {
      state_->all.push_back(state_->discs.size());
      if (!is_parked(robot)) state_->not_parked.push_back(state_->discs.size());
      state_->discs.push_back({radius, robot.layers.bits, robot.avoids.bits, is_parked(robot),
                               footprint ? footprint.ahead(k) : 0.0, state_->models.size()});
    }
    state_->models.push_back(robot.model);
    state_->largest_radius = std::max(state_->largest_radius, radius);
  }
  state_->first_disc.push_back(state_->discs.size());
  state_->centers.resize(state_->discs.size());
}
ClearanceFinder::~ClearanceFinder() = default;
ClearanceFinder::ClearanceFinder(ClearanceFinder&&) noexcept = default;
ClearanceFinder& ClearanceFinder::operator=(ClearanceFinder&&) noexcept = default;

void ClearanceFinder::find(const FleetColumns& fleet, std::span<float> clearance) {
  const std::size_t count = state_->place(fleet);
  if (count == 0) return std::fill(clearance.begin(), clearance.end(), kAbsent);
  state_->side = side_for(state_->centers, count);
  state_->grid.build(state_->centers, state_->side);
  for (std::size_t i = 0; i < clearance.size(); ++i) {
    const std::size_t first = state_->first_disc[i], behind = state_->first_disc[i + 1];
    clearance[i] = kAbsent;
    if (std::isnan(state_->centers[first].x)) continue;
    double least = kNobody;
    for (std::size_t k = first; k < behind; ++k) least = std::min(least, state_->clearance_of(k));
    clearance[i] = static_cast<float>(least);
  }
}

}  // namespace avo
