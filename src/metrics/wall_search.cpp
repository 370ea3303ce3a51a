// SPDX-License-Identifier: Apache-2.0
// Finds the walls near a robot.
#include "metrics/wall_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace avo::inline metrics {
namespace {

constexpr double kMostPieces = 1e5;     // in addition to one for each wall
constexpr double kWallRounding = 1e-9;  // of a distance

}  // namespace

WallSearch::WallSearch(std::vector<Wall> walls) : walls_(std::move(walls)) {
  for (const Wall& wall : walls_) total_length_ += norm(wall.b - wall.a);
}

void WallSearch::prepare(double distance) {
  if (distance <= prepared_ && prepared_ <= 2.0 * distance) return;
  cut(distance);
  prepared_ = distance;
}

void WallSearch::cut(double distance) {
  const double longest = std::max(2.0 * distance, total_length_ / kMostPieces);  // m
  std::vector<Vec2> middles;
  wall_of_.clear();
  double widest = 0.0;  // coordinate, m
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const auto& [a, b, radius] = walls_[k];
    const double length = norm(b - a);
    const double pieces = length > longest ? std::ceil(length / longest) : 1.0;
    for (double i = 0.5; i < pieces; i += 1.0) {
      middles.push_back(a + (i / pieces) * (b - a));
      wall_of_.push_back(k);
    }
    widest = std::max({widest, norm(a), norm(b)});
  }
  grid_.build(middles, distance + 0.5 * longest + kWallRounding * (distance + longest + widest));
}

std::span<const std::size_t> WallSearch::near(Vec2 position) {
  near_.clear();
  for (const NeighborHit& hit : grid_.gather(position, -1, wall_of_.size(), scratch_))
    near_.push_back(wall_of_[static_cast<std::size_t>(hit.index)]);
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  return near_;
}

}  // namespace avo::inline metrics
