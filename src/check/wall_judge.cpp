// SPDX-License-Identifier: Apache-2.0
// Robots against walls: contacts, and the least clearance.
#include "check/wall_judge.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "check/counts.h"
#include "check/wall_path.h"
#include "core/plane.h"

namespace avo::judge {
namespace {

BoundingBox box_of(const CheckedWall& wall, std::size_t owner) {
  return box_around(std::array{wall.a, wall.b}, wall.radius, owner);
}

// Returns whether a robot in those layers must keep clear of the wall.
bool concerns(const CheckedWall& wall, std::uint32_t layers) {
  constexpr std::uint32_t kEveryRobot = ~std::uint32_t{0};
  return wall.layers == kEveryRobot || (wall.layers & layers) != 0;
}

}  // namespace

void WallJudge::set_walls(std::vector<CheckedWall> walls) {
  std::vector<BoundingBox> boxes;
  for (std::size_t k = 0; k < walls.size(); ++k) boxes.push_back(box_of(walls[k], k));
  tree_ = BoxTree(std::move(boxes));
  walls_ = std::move(walls);
}

void WallJudge::judge(const MovingDisc& robot, const JudgedStep& step) {
  if (walls_.empty()) return;
  const std::uint32_t layers = step.robots[static_cast<std::size_t>(robot.index)].layers;
  // no wall farther away than the least clearance changes the result
  tree_.visit(
      box_of(robot, 0, step.duration),
      [this] { return std::max(least_clearance_.value_or(kInfinity), 0.0); },
      [&](std::size_t wall) {
        if (concerns(walls_[wall], layers)) meet(robot, wall, step);
      });
}

void WallJudge::meet(const MovingDisc& robot, std::size_t wall, const JudgedStep& step) {
  const Vec2 a = walls_[wall].a, along = walls_[wall].b - a;
  const std::size_t parts = robot.parts();
  const auto piece = [&](std::size_t k) {
    return WallPath{path_of(robot, step.duration, a, k, parts), along};
  };
  const Pieces<decltype(piece)> path{parts, piece};
  const double contact = robot.radius + walls_[wall].radius;
  // the rows themselves are not interpolated
  const double row_limit = contact * (1.0 - step.relative_tolerance);
  const double limit = row_limit - robot.error;
  const double best = least_clearance_.value_or(kInfinity);
  if (lower_bound(path) > std::max(contact + best, row_limit) * (1.0 + 1e-12)) return;
  const Instant nearest = nearest_instant(path);
  least_clearance_ = std::min(best, nearest.distance - contact);
  const double at_start = distance_at(piece(0), 0.0), at_end = distance_at(piece(parts - 1), 1.0);
  const double at_rows = std::min(at_start, at_end);
  const double depth = std::max(limit - nearest.distance, row_limit - at_rows);
  if (!(depth > 0.0)) return;
  const auto index = static_cast<std::size_t>(robot.index);
  if (touched_.size() <= index) touched_.resize(index + 1);
  if (!touched_[index]) ++contacts_.count;
  touched_[index] = true;
  contacts_.worst = std::max(contacts_.worst, depth);
  if (contacts_.first && contacts_.first->time < step.from) return;
  const double first_row = at_start < row_limit ? 0.0 : 1.0;
  const double seen = at_rows < row_limit ? first_row : nearest.fraction;
  const double fraction =
      robot.newcomer ? 1.0 : std::min(first_below(path, limit).value_or(seen), seen);
  note(contacts_,
       {step.from + fraction * step.duration, robot.index, static_cast<std::int64_t>(wall), depth});
}

bool WallJudge::hides(Vec2 from, Vec2 to, std::uint32_t layers) const {
  constexpr double kRounding = 1e-12;  // ten times the error of nearest_instant()
  const auto [left, right] = std::minmax(from.x, to.x);
  const auto [bottom, top] = std::minmax(from.y, to.y);
  const Vec2 third = (to - from) / 3.0;
  bool is_hidden = false;
  tree_.visit(
      {{left, bottom}, {right, top}}, [] { return std::numeric_limits<double>::min(); },
      [&](std::size_t k) {
        if (!concerns(walls_[k], layers)) return;
        const Vec2 a = walls_[k].a, b = walls_[k].b;
        const Vec2 start = from - a, end = to - a;
        const WallPath sight{{{start, start + third, end - third, end}}, b - a};
        const double rounding = kRounding * (norm(start) + norm(end) + norm(b - a));
        is_hidden = is_hidden || nearest_instant(sight).distance <= walls_[k].radius + rounding;
      });
  return is_hidden;
}

void WallJudge::write(CheckReport& report) const {
  report.static_contacts = contacts_;
  report.least_static_clearance = least_clearance_;
}

}  // namespace avo::judge
