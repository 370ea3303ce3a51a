// SPDX-License-Identifier: Apache-2.0
#include "navigation/known_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/plane.h"

namespace avo {
namespace {

constexpr std::uint32_t kNoEdge = 0xffffffff;
constexpr std::size_t kMostChanged = 16;  // walls; looking for edges anew is quicker then

bool are_equal(const Wall& a, const Wall& b) {
  return a.a == b.a && a.b == b.b && a.radius == b.radius;
}

}  // namespace

KnownEdges::KnownEdges(const CornerGraph& graph, const CornerGraph* before)
    : graph_(graph), before_(before), old_of_(graph.points.size(), kNoEdge) {
  if (before_ == nullptr) return;
  // all walls but those between the common beginning and the common end
  added_ = graph_.grid.walls(), removed_ = before_->grid.walls();
  while (!added_.empty() && !removed_.empty() && are_equal(added_.front(), removed_.front()))
    added_ = added_.subspan(1), removed_ = removed_.subspan(1);
  while (!added_.empty() && !removed_.empty() && are_equal(added_.back(), removed_.back()))
    added_ = added_.first(added_.size() - 1), removed_ = removed_.first(removed_.size() - 1);
  if (added_.size() + removed_.size() > kMostChanged) return;
  match_points();
  const double widest = graph_.radius + kSpareRoom;
  for (const Wall& wall : removed_) {
    opened_.push_back(
        {0.5 * (wall.a + wall.b), 0.5 * norm(wall.b - wall.a) + wall.radius + widest});
  }
}

// Only points that are looked at in the same order: so each pair is the same straight way.
void KnownEdges::match_points() {
  std::map<std::pair<double, double>, std::uint32_t> old_at;
  for (std::uint32_t k = 0; k < before_->points.size(); ++k) {
    old_at.insert({{before_->points[k].x, before_->points[k].y}, k});
  }
  joined_to_.assign(before_->points.size(), 0);
  std::uint32_t next = 0;
  for (std::uint32_t k = 0; k < graph_.points.size(); ++k) {
    const auto place = old_at.find({graph_.points[k].x, graph_.points[k].y});
    if (place == old_at.end()) continue;
    const std::uint32_t old = place->second;
    if (old < next || graph_.room[k] != before_->room[old] ||
        !(graph_.outward[k] == before_->outward[old]) ||
        graph_.most_lean[k] != before_->most_lean[old])
      continue;
    old_of_[k] = old, next = old + 1;
  }
}

// Whether the line through both meets a disc that is neither behind p nor beyond q.
bool KnownEdges::may_have_opened(Vec2 p, Vec2 q) const {
  const Vec2 way = q - p;
  const double length_squared = norm_squared(way);
  return std::any_of(opened_.begin(), opened_.end(), [&](const Disc& disc) {
    const Vec2 to = disc.center - p;
    const double reach = disc.reach + kLengthRounding * length_1(to);
    const double margin = reach * reach * length_squared;
    const double aside = cross(way, to), along = dot(way, to);
    if (aside * aside > margin) return false;
    const double beyond = along - length_squared;
    return !(along < 0.0 && along * along > margin) && !(beyond > 0.0 && beyond * beyond > margin);
  });
}

std::span<const std::uint32_t> KnownEdges::candidates(std::uint32_t i) {
  candidates_.clear();
  const std::uint32_t old = old_of_[i];
  if (old != kNoEdge) {
    for (const CornerGraph::Edge& edge : before_->edges_of(old)) joined_to_[edge.to] = i + 1;
  }
  const Vec2 p = graph_.points[i];
  for (std::uint32_t k = i + 1; k < graph_.points.size(); ++k) {
    const bool is_new = old == kNoEdge || old_of_[k] == kNoEdge;
    if (is_new || joined_to_[old_of_[k]] == i + 1 || may_have_opened(p, graph_.points[k]))
      candidates_.push_back(k);
  }
  return candidates_;
}

std::optional<bool> KnownEdges::are_joined(std::uint32_t i, std::uint32_t k) const {
  if (old_of_[i] == kNoEdge || old_of_[k] == kNoEdge) return std::nullopt;
  const double room = std::min(graph_.room[i], graph_.room[k]);
  const auto is_blocking = [&](const Wall& wall) {
    return is_in_the_way(wall, graph_.points[i], graph_.points[k], room);
  };
  if (joined_to_[old_of_[k]] == i + 1)
    return std::none_of(added_.begin(), added_.end(), is_blocking);
  if (std::none_of(removed_.begin(), removed_.end(), is_blocking)) return false;
  return std::nullopt;
}

}  // namespace avo
