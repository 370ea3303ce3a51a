// SPDX-License-Identifier: Apache-2.0
// The walkable area of a scene. Its text has areas alone, so walls without a thickness get one.
#include "io/export/area.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/elementary.h"
#include "io/export/rings.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr double kAroundMotion = 1.0;   // m, from discs to the rectangle of an open scene
constexpr double kLeastRadius = 0.005;  // m, of a wall
constexpr double kSlender = 0.05;       // m: walls of less radius have square ends
constexpr std::size_t kCorners = 32;    // of a disc
constexpr double kHalfCircle = 3.141592653589793;

/// Returns a polygon that contains the wall: the disc of each end touches the polygon from inside.
avo::Chain outline_of(const avo::Wall& wall) {
  const double radius = std::max(wall.radius, kLeastRadius), length = norm(wall.b - wall.a);
  const bool slender = radius < kSlender;
  const std::size_t corners = slender ? 4 : kCorners;
  const double half_turn = kHalfCircle / static_cast<double>(corners);
  const Vec2 ahead = length > 0.0 ? (wall.b - wall.a) / length : Vec2{1.0, 0.0};
  const double to_corner = radius / avo::elementary::direction(half_turn).x;
  avo::Chain chain{{}, true};
  const auto add = [&chain](Vec2 point) {
    if (chain.points.empty() || !(chain.points.back() == point)) chain.points.push_back(point);
  };
  // the farther end in the direction `angle`, seen from `ahead`
  const auto end_towards = [&](double angle) {
    return avo::elementary::direction(angle).x > 1e-9 ? wall.b : wall.a;
  };
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = (2.0 * static_cast<double>(k) + 1.0) * half_turn;
    const Vec2 turned = avo::elementary::direction(angle);
    const Vec2 corner =
        (to_corner * turned.x) * ahead + (to_corner * turned.y) * perpendicular(ahead);
    add(end_towards(angle - half_turn) + corner);
    add(end_towards(angle + half_turn) + corner);
  }
  if (chain.points.front() == chain.points.back()) chain.points.pop_back();
  return chain;
}

avo::StaticObstacle closed_part(const avo::StaticObstacle& obstacle) {
  avo::StaticObstacle region{{}, 0.0, obstacle.fill};
  for (const avo::Chain& chain : obstacle.chains)
    if (chain.closed && chain.points.size() >= 3) region.chains.push_back(chain);
  return region;
}

std::string wkt_of(const Ring& ring) {
  std::string text = "(";
  for (const Vec2 p : ring) text += fmt::format("{} {}, ", p.x, p.y);
  return text + fmt::format("{} {})", ring[0].x, ring[0].y);
}

std::string wkt_of(const FreePart& part) {
  std::string text = "(" + wkt_of(part.outer);
  for (const Ring& hole : part.holes) text += ", " + wkt_of(hole);
  return text + ")";
}

bool has_any_of(const FreePart& part, const std::vector<Vec2>& points) {
  return std::any_of(points.begin(), points.end(), [&part](Vec2 point) {
    return is_inside(part.outer, point) &&
           std::none_of(part.holes.begin(), part.holes.end(),
                        [point](const Ring& hole) { return is_inside(hole, point); });
  });
}

}  // namespace

AreaFinder::AreaFinder(const avo::Scenario* scenario) : scenario_(scenario) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  min_ = {kFar, kFar};
  max_ = {-kFar, -kFar};
  margin_ = kAroundMotion;
  if (scenario == nullptr) return;
  for (const avo::RobotSetup& robot : scenario->robots)
    margin_ = std::max(
        margin_, kAroundMotion + disc_radius(robot) + norm(disc_center(robot) - robot.position));
  for (const avo::Wall& wall : avo::walls_of(scenario->obstacles))
    for (const Vec2 end : {wall.a, wall.b}) reach(end, wall.radius + kAroundMotion);
}

void AreaFinder::reach(Vec2 point, double margin) {
  min_ = {std::min(min_.x, point.x - margin), std::min(min_.y, point.y - margin)};
  max_ = {std::max(max_.x, point.x + margin), std::max(max_.y, point.y + margin)};
}

void AreaFinder::add(const RecordedTime& moment) {
  const bool first = begin_.empty();
  for (const avo::CheckedState& row : moment.rows) {
    reach(row.position, margin_);
    if (first) begin_.push_back(row.position);
  }
}

std::vector<avo::StaticObstacle> AreaFinder::regions() const {
  std::vector<avo::StaticObstacle> regions;
  bool bounds = false;
  for (const avo::StaticObstacle& obstacle :
       scenario_ != nullptr ? scenario_->obstacles : std::vector<avo::StaticObstacle>()) {
    avo::StaticObstacle closed = closed_part(obstacle);
    const bool filled = obstacle.fill != avo::Fill::none && !closed.chains.empty();
    bounds = bounds || (filled && obstacle.fill == avo::Fill::bounds);
    if (filled) regions.push_back(std::move(closed));
    if (filled && obstacle.radius == 0.0) continue;
    for (const avo::Wall& wall : avo::walls_of({&obstacle, 1}))
      regions.push_back({{outline_of(wall)}, 0.0, avo::Fill::solid});
  }
  if (!bounds)
    regions.push_back(
        {{{{min_, {max_.x, min_.y}, max_, {min_.x, max_.y}}, true}}, 0.0, avo::Fill::bounds});
  return regions;
}

WalkableArea AreaFinder::found() const {
  std::vector<FreePart> parts = free_parts(regions());
  const auto with_robots =
      std::stable_partition(parts.begin(), parts.end(),
                            [this](const FreePart& part) { return has_any_of(part, begin_); });
  if (with_robots != parts.begin()) parts.erase(with_robots, parts.end());
  if (parts.empty())
    throw avo::Error("obstacles: found no free space between them, must leave some");
  WalkableArea area;
  std::string text;
  area.min = area.max = parts[0].outer[0];
  for (const FreePart& part : parts) {
    text += (text.empty() ? "" : ", ") + wkt_of(part);
    for (const Vec2 p : part.outer) {
      area.min = {std::min(area.min.x, p.x), std::min(area.min.y, p.y)};
      area.max = {std::max(area.max.x, p.x), std::max(area.max.y, p.y)};
    }
  }
  area.wkt = parts.size() == 1 ? "POLYGON " + text : "MULTIPOLYGON (" + text + ")";
  return area;
}

}  // namespace avo_io
