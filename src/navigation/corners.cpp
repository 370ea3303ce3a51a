// SPDX-License-Identifier: Apache-2.0
#include "navigation/corners.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "core/elementary.h"
#include "core/hash.h"
#include "navigation/lattice.h"
#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

constexpr double kPi = 0x1.921fb54442d18p+1;
constexpr double kPointAngle = kPi / 6.0;  // between neighboring points around an end, at most
constexpr double kStretch = 1.0353;        // > 1 / cos(kPointAngle / 2)
constexpr double kTouching = 1e-3;         // of the radius: walls this near are joined
constexpr double kLeanSlack = 0.1;         // where neighbors of a point are cut off
constexpr double kWidestGap = 1.15;        // of what points around ends need to pass

struct OpenArc {
  double from = 0.0, angle = 0.0;  // rad, of the outward directions
};

class CornerFinder {
 public:
  CornerFinder(const ClearanceGrid& grid, double radius) : grid_(grid), radius_(radius) {}

  // Keeps the corners at ends far from all changes.
  void keep(const Corners& before, const WallChanges& changes, std::vector<std::uint32_t>& number) {
    before_ = &before, changes_ = &changes, number_ = &number;
    number.assign(before.all.size(), kNoCorner);
    const double range = corner_range(grid_);
    const std::vector<Zone> changed = changes.around(range);
    stays_.assign(grid_.walls().size(), 0);
    for (std::size_t k = 0; k < stays_.size(); ++k) {
      const Wall& wall = grid_.walls()[k];
      const auto old = changes.number_before(k);
      if (!old || is_in_one(changed, wall.a, 0.0) || is_in_one(changed, wall.b, 0.0)) continue;
      stays_[k] = 1;
      for (std::uint32_t c = before.in_gaps[*old]; c < before.in_gaps[*old + 1]; ++c)
        is_new(before.all[c].point);  // marks the place as taken, for walls that are examined anew
    }
  }

  Corners find() {
    const std::span<const Wall> walls = grid_.walls();
    for (std::size_t k = 0; k < walls.size(); ++k) {
      found_.around.push_back(static_cast<std::uint32_t>(found_.all.size()));
      if (before_ != nullptr && is_kept(k, before_->around)) continue;
      add_around(k, walls[k].a, false);
      if (!(walls[k].a == walls[k].b)) add_around(k, walls[k].b, true);
    }
    found_.around.push_back(static_cast<std::uint32_t>(found_.all.size()));
    for (std::size_t k = 0; k < walls.size(); ++k) {
      found_.in_gaps.push_back(static_cast<std::uint32_t>(found_.all.size()));
      if (before_ != nullptr && is_kept(k, before_->in_gaps)) continue;
      add_in_gaps(walls[k].a, walls[k].radius);
      if (!(walls[k].a == walls[k].b)) add_in_gaps(walls[k].b, walls[k].radius);
    }
    found_.in_gaps.push_back(static_cast<std::uint32_t>(found_.all.size()));
    return std::move(found_);
  }

 private:
  // Returns whether the wall stays, and so do its corners among those by these first ones.
  bool is_kept(std::size_t wall, const std::vector<std::uint32_t>& first) {
    if (stays_[wall] == 0) return false;
    const std::size_t old = *changes_->number_before(wall);
    for (std::uint32_t k = first[old]; k < first[old + 1]; ++k) {
      (*number_)[k] = static_cast<std::uint32_t>(found_.all.size());
      found_.all.push_back(before_->all[k]);
    }
    return true;
  }

  bool is_joined(Vec2 p, Vec2 q) const { return norm(p - q) <= kTouching * radius_; }

  // Returns whether the same end, up to joints, was examined before.
  bool is_repeated(std::size_t wall, Vec2 end, bool is_second) const {
    return !grid_.all_near(end, end, [&](std::size_t k) {
      const Wall& other = grid_.walls()[k];
      const bool first_came = k < wall || (k == wall && is_second);
      return !(first_came && is_joined(end, other.a)) && !(k < wall && is_joined(end, other.b));
    });
  }

  // The directions that are not within 90 degrees of a wall at this end; none at a concave corner.
  OpenArc free_arc(Vec2 end, double& widest) const {
    std::vector<double> angles;
    grid_.all_near(end, end, [&](std::size_t k) {
      const Wall& wall = grid_.walls()[k];
      if (distance(end, {wall.a, wall.b}) > kTouching * radius_) return true;
      widest = std::max(widest, wall.radius);
      for (const Vec2 to : {wall.a, wall.b}) {
        if (!is_joined(end, to)) angles.push_back(elementary::atan2(to.y - end.y, to.x - end.x));
      }
      return true;
    });
    if (angles.empty()) return {0.0, 2.0 * kPi};
    std::sort(angles.begin(), angles.end());
    angles.push_back(angles.front() + 2.0 * kPi);
    OpenArc widest_arc;
    for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
      const double angle = angles[k + 1] - angles[k] - kPi;
      if (angle > widest_arc.angle) widest_arc = {angles[k] + 0.5 * kPi, angle};
    }
    return widest_arc;
  }

  void add_around(std::size_t wall, Vec2 end, bool is_second) {
    constexpr double kLeastAngle = 1e-6;  // rad
    if (is_repeated(wall, end, is_second)) return;
    double widest = 0.0;
    const OpenArc arc = free_arc(end, widest);
    if (arc.angle < kLeastAngle) return;
    const double count = std::ceil(arc.angle / kPointAngle - kLengthRounding),
                 step = arc.angle / count;
    const double cosine = elementary::direction(0.5 * step).x;
    const double lean = elementary::sin(0.5 * step) + kLeanSlack;
    for (double k = 0.5; k < count; k += 1.0) {
      const Vec2 outward = elementary::direction(arc.from + k * step);
      for (const double part : kSpareParts) {
        const double room = radius_ + part * kSpareRoom;
        const Vec2 point = end + ((room + widest) / cosine * (1.0 + kLengthRounding)) * outward;
        if (!grid_.has_room(point, room)) continue;
        found_.all.push_back({point, room * (1.0 - kLengthRounding), outward, lean});
        break;
      }
    }
  }

  // Returns whether there is no point within rounding of this one.
  bool is_new(Vec2 point) {
    const double cell = kTouching * radius_;
    const auto word = [cell](double x) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / cell + 0.5)));
    };
    return taken_.insert(mixed(mixed(0, word(point.x)), word(point.y))).second;
  }

  void add_in_gap(Vec2 point) {
    const double clearance = grid_.clearance(point) + kLengthRounding * radius_;
    if (!(clearance >= radius_) || !is_new(point)) return;
    const double room = std::min(clearance, radius_ + kSpareRoom) - 2.0 * kLengthRounding * radius_;
    found_.all.push_back({point, room, {}, 1.0});
  }

  struct EndGap {
    Vec2 middle, across;  // m; unit
  };
  // Adds the point where the middle lines of two gaps at one end meet. The route bends around that
  // end, between walls on its other side.
  void add_in_bend(const EndGap& one, const EndGap& other, double widest) {
    const double sine = cross(one.across, other.across);
    const Vec2 apart = other.middle - one.middle;
    if (!(std::abs(sine) > kTouching)) return;
    // along both lines: across_1 . (p - middle_1) = 0 and across_2 . (p - middle_2) = 0
    const Vec2 point = one.middle + (dot(other.across, apart) / sine) * perpendicular(one.across);
    if (norm(point - one.middle) <= widest) add_in_gap(point);
  }

  // Adds the middle of each gap between this end and another wall, and the places before and
  // behind.
  void add_in_gaps(Vec2 end, double own) {
    const std::uint64_t place = mixed(mixed(0, word_of(end.x)), word_of(end.y));
    if (!looked_at_.insert(mixed(place, word_of(own))).second) return;  // for pieces that touch
    const double rounding = kLengthRounding * radius_;
    const double widest = kWidestGap * (1.0 + kStretch) * (radius_ + kSpareRoom);
    std::vector<EndGap> gaps;
    grid_.all_near(end, end, [&](std::size_t k) {
      const Wall& other = grid_.walls()[k];
      const Vec2 nearest = nearest_on({other.a, other.b}, end);
      const double between = norm(end - nearest), gap = between - own - other.radius;
      if (gap < 2.0 * (radius_ - rounding) || gap > widest) return true;
      const Vec2 across = (end - nearest) / between;
      const Vec2 middle = nearest + (other.radius + 0.5 * gap) * across;
      if (!grid_.has_room(middle, 0.5 * gap - rounding)) return true;  // a wall is in the gap
      const Vec2 along = (radius_ + kSpareRoom) * perpendicular(across);
      for (const Vec2 point : {middle, middle + along, middle - along}) add_in_gap(point);
      gaps.push_back({middle, across});
      return true;
    });
    for (std::size_t k = 1; k < gaps.size(); ++k) {
      for (std::size_t i = 0; i < k; ++i) add_in_bend(gaps[i], gaps[k], widest);
    }
  }

  const ClearanceGrid& grid_;
  double radius_;
  Corners found_;
  const Corners* before_ = nullptr;
  const WallChanges* changes_ = nullptr;
  std::vector<std::uint32_t>* number_ = nullptr;
  std::vector<char> stays_;  // by wall
  std::unordered_set<std::uint64_t> taken_, looked_at_;
};

}  // namespace

double corner_reach(double radius, double widest_wall) {
  return kWidestGap * (1.0 + kStretch) * (radius + kSpareRoom) + widest_wall;
}

Corners corners(const ClearanceGrid& grid, double radius) {
  return CornerFinder(grid, radius).find();
}

Corners corners(const ClearanceGrid& grid, double radius, const Corners& before,
                const WallChanges& changes, std::vector<std::uint32_t>& number) {
  CornerFinder finder(grid, radius);
  finder.keep(before, changes, number);
  return finder.find();
}

// The points of an end, and the walls that limit them, are within twice the reach, and so are other
// ends of the same points.
double corner_range(const ClearanceGrid& grid) {
  return 4.0 * grid.reach();
}

}  // namespace avo::inline navigation
