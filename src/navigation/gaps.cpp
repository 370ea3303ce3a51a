// SPDX-License-Identifier: Apache-2.0
#include "navigation/gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "core/hash.h"
#include "navigation/pockets.h"
#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

constexpr double kOneLane = 4.4;        // radii: two robots with a tenth of their size on each side
constexpr double kTwoLanes = 8.0;       // radii: wider gaps need no lanes
constexpr double kTouchingEnds = 1e-3;  // of the least radius: ends this near are joined
constexpr double kStraight = 1e-6;      // rad: a smaller angle is no bend
constexpr double kLeadsInto = 1e-3;     // cosine: a joined wall then certainly leads into the gap
constexpr double kMostUnlike = 100.0;   // times the least radius: rounding is less than that margin

// m: with a zone of that reach around each change, no wall within the grid's reach of a place
// outside has changed. No gap that is found at such a place leads farther out than twice that.
double range_of(const ClearanceGrid& grid) {
  return (1.0 + kLengthRounding) * grid.reach() + kTouchingEnds * grid.reach();
}

bool meets(std::span<const Zone> zones, const Gap& gap, double margin) {
  return std::any_of(zones.begin(), zones.end(), [&](const Zone& zone) {
    return distance(zone.center, {gap.a, gap.b}) <= zone.reach + margin;
  });
}

class GapFinder {
 public:
  GapFinder(const ClearanceGrid& grid, std::span<const double> radii)
      : grid_(grid),
        radii_(radii),
        touching_(kTouchingEnds * radii.front()),
        joints_(grid.walls(), touching_) {}

  // Keeps the gaps of ends that are far from all changes.
  void keep(const ToldGaps& before, const WallChanges& changes,
            std::vector<std::uint32_t>& number) {
    before_ = &before, changes_ = &changes, number_ = &number;
    zones_ = changes.around(range_of(grid_));
    number.assign(before.all.size(), kNoGap);
  }

  ToldGaps find() {
    const std::span<const Wall> walls = grid_.walls();
    for (std::size_t k = 0; k < walls.size(); ++k) {
      for (const bool is_second : {false, true}) {
        told_.first.push_back(static_cast<std::uint32_t>(told_.all.size()));
        if (!keeps(k, is_second)) look_at(walls[k], is_second);
      }
    }
    told_.first.push_back(static_cast<std::uint32_t>(told_.all.size()));
    find_kinds();
    return std::move(told_);
  }

 private:
  bool is_joined(Vec2 p, Vec2 q) const { return norm(p - q) <= touching_; }

  // Returns whether the same walls are around the end as before, in the same order.
  bool keeps(std::size_t wall, bool is_second) {
    if (before_ == nullptr) return false;
    const auto old = changes_->number_before(wall);
    const Wall& here = grid_.walls()[wall];
    if (!old || is_in_one(zones_, is_second ? here.b : here.a, 0.0)) return false;
    const std::size_t end = 2 * *old + (is_second ? 1 : 0);
    for (std::uint32_t k = before_->first[end]; k < before_->first[end + 1]; ++k) {
      (*number_)[k] = static_cast<std::uint32_t>(told_.all.size());
      told_.all.push_back(before_->all[k]), told_.kind.push_back(before_->kind[k]);
    }
    return true;
  }

  void look_at(const Wall& wall, bool is_second) {
    if (is_second && wall.a == wall.b) return;
    const Vec2 end = is_second ? wall.b : wall.a, from = is_second ? wall.a : wall.b;
    if (!goes_on(wall, from, end)) add_at(end, wall.radius);
    told_.kind.resize(told_.all.size(), ToldGaps::Kind::open);
  }

  // Returns whether other walls, at least as thick, lead straight on from the wall's end. Then
  // nothing is narrowest there, and the number of pieces of a wall makes no difference.
  bool goes_on(const Wall& wall, Vec2 from, Vec2 end) const {
    const Vec2 line = end - from;
    return !joints_.all_near(end, end, [&](std::size_t k) {
      const Wall& other = grid_.walls()[k];
      if (other.radius < wall.radius || distance(end, {other.a, other.b}) > touching_) return true;
      const auto leads_on = [&](Vec2 to) {
        const Vec2 on = to - end;
        return !is_joined(to, end) && dot(on, line) > 0.0 &&
               std::abs(cross(on, line)) <= kStraight * norm(on) * norm(line);
      };
      return !leads_on(other.a) && !leads_on(other.b);
    });
  }

  // Pieces that touch at an end give the same gaps.
  bool is_new(Vec2 end, double radius) {
    const std::uint64_t place = mixed(mixed(0, word_of(end.x)), word_of(end.y));
    return looked_at_.insert(mixed(place, word_of(radius))).second;
  }

  // Finds unit directions of walls, no thinner, that begin at this end: they lead into the circle
  // of any gap ahead of them.
  void find_leaving(Vec2 end, double end_radius) {
    leaving_.clear();
    if (radii_.back() > kMostUnlike * radii_.front()) return;
    joints_.all_near(end, end, [&](std::size_t k) {
      const Wall& wall = grid_.walls()[k];
      if (wall.radius < end_radius) return true;
      if (wall.a == end || wall.b == end) {
        const Vec2 line = wall.a == end ? wall.b - end : wall.a - end;
        if (norm(line) > touching_) leaving_.push_back(line / norm(line));
      }
      return true;
    });
  }
  bool is_ahead(const Wall& wall, Vec2 end, double farthest) const {
    const double least = kLeadsInto * farthest;
    return std::any_of(leaving_.begin(), leaving_.end(), [&](Vec2 line) {
      return dot(line, wall.a - end) > least && dot(line, wall.b - end) > least;
    });
  }

  // Returns whether a wall is nearer; most often it is the one of the gap before.
  bool is_blocked(Vec2 middle, double room) {
    const auto is_nearer = [&](std::size_t k) {
      const Wall& wall = grid_.walls()[k];
      return distance(middle, {wall.a, wall.b}) - wall.radius < room;
    };
    const auto known = std::find_if(blocking_.begin(), blocking_.end(), is_nearer);
    if (known != blocking_.end()) {
      std::rotate(blocking_.begin(), known, known + 1);
      return true;
    }
    return !grid_.all_near(middle, middle, [&](std::size_t k) {
      if (!is_nearer(k)) return true;
      std::rotate(blocking_.begin(), blocking_.end() - 1, blocking_.end());
      blocking_.front() = k;
      return false;
    });
  }

  // Adds the gaps between this end and the walls around it, in the order of their numbers, with
  // nothing else in between.
  void add_at(Vec2 end, double end_radius) {
    if (!is_new(end, end_radius)) return;
    find_leaving(end, end_radius);
    around_.clear();
    grid_.all_near(end, end, [&](std::size_t k) {
      around_.push_back(k);
      return true;
    });
    if (!std::is_sorted(around_.begin(), around_.end()))  // of two cells
      std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    const double farthest = end_radius + grid_.reach();
    for (const std::size_t k : around_) {
      const Wall& wall = grid_.walls()[k];
      if (!is_ahead(wall, end, farthest)) add_between(end, end_radius, wall);
    }
  }
  void add_between(Vec2 end, double end_radius, const Wall& wall) {
    const double rounding = kLengthRounding * radii_.back();
    const Vec2 nearest = nearest_on({wall.a, wall.b}, end);
    const double between = norm(end - nearest);
    const double width = between - end_radius - wall.radius;
    if (between <= touching_ || width < 2.0 * radii_.front() - rounding) return;
    const double radius =
        *(std::upper_bound(radii_.begin(), radii_.end(), 0.5 * width + rounding) - 1);
    if (width >= kTwoLanes * radius) return;
    const Vec2 across = (nearest - end) / between;
    const Gap gap{end + end_radius * across, nearest - wall.radius * across, radius,
                  width >= kOneLane * radius};
    if (!is_blocked(gap.middle(), 0.5 * width - rounding)) told_.all.push_back(gap);
  }

  bool is_same(const Gap& one, const Gap& other) const {
    return (is_joined(one.a, other.a) && is_joined(one.b, other.b)) ||
           (is_joined(one.a, other.b) && is_joined(one.b, other.a));
  }
  bool shares_end(const Gap& one, const Gap& other) const {
    return is_joined(one.a, other.a) || is_joined(one.a, other.b) || is_joined(one.b, other.a) ||
           is_joined(one.b, other.b);
  }

  // Judges the kinds. Both ends of a gap may have found it. Where routes cross there are also gaps
  // from corner to corner, which are not where any route is narrowest: another gap, no wider,
  // crosses them.
  void find_kinds() {
    const double reach = range_of(grid_);
    std::vector<std::uint32_t> numbers;  // of all gaps that may cross one that is examined
    std::vector<Wall> lines;
    for (std::uint32_t k = 0; k < told_.all.size(); ++k) {
      const Gap& gap = told_.all[k];
      if (before_ != nullptr && !meets(zones_, gap, 4.0 * reach)) continue;
      numbers.push_back(k), lines.push_back({gap.a, gap.b, 0.0});
    }
    const ClearanceGrid near(lines, radii_.front());
    for (const std::uint32_t k : numbers) {
      if (before_ == nullptr || meets(zones_, told_.all[k], 2.0 * reach))
        told_.kind[k] = kind_of(k, numbers, near), ++told_.examined;
    }
  }
  ToldGaps::Kind kind_of(std::uint32_t number, const std::vector<std::uint32_t>& numbers,
                         const ClearanceGrid& near) const {
    const Gap& gap = told_.all[number];
    const bool is_narrowest = near.all_near(gap.a, gap.b, [&](std::size_t line) {
      const std::uint32_t k = numbers[line];
      const Gap& other = told_.all[k];
      if (k == number) return true;
      if (is_same(gap, other)) return number < k;
      if (shares_end(gap, other) || other.width() > (1.0 + kLengthRounding) * gap.width())
        return true;
      return nearest_points({gap.a, gap.b}, {other.a, other.b}).distance > 0.0;
    });
    if (!is_narrowest) return ToldGaps::Kind::left_out;
    return leads_into_pocket(grid_, gap) ? ToldGaps::Kind::pocket : ToldGaps::Kind::open;
  }

  const ClearanceGrid& grid_;
  std::span<const double> radii_;
  double touching_;
  ClearanceGrid joints_;  // finds walls that touch
  std::unordered_set<std::uint64_t> looked_at_;
  std::vector<Vec2> leaving_;
  std::array<std::size_t, 8> blocking_{};  // walls, the last one first
  std::vector<std::size_t> around_;        // walls around the present end
  ToldGaps told_;
  const ToldGaps* before_ = nullptr;
  const WallChanges* changes_ = nullptr;
  std::vector<std::uint32_t>* number_ = nullptr;
  std::vector<Zone> zones_;  // outside of them the gaps of ends have not changed
};

}  // namespace

std::vector<std::uint32_t> ToldGaps::numbers_of(Kind which) const {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t k = 0; k < all.size(); ++k)
    if (kind[k] == which) numbers.push_back(k);
  return numbers;
}

ToldGaps tell_gaps(const ClearanceGrid& grid, std::span<const double> radii) {
  return GapFinder(grid, radii).find();
}

ToldGaps tell_gaps(const ClearanceGrid& grid, std::span<const double> radii, const ToldGaps& before,
                   const WallChanges& changes, std::vector<std::uint32_t>& number) {
  GapFinder finder(grid, radii);
  finder.keep(before, changes, number);
  return finder.find();
}

std::vector<Gap> find_gaps(const ClearanceGrid& grid, std::span<const double> radii) {
  const ToldGaps told = tell_gaps(grid, radii);
  std::vector<Gap> gaps;
  for (std::size_t k = 0; k < told.all.size(); ++k)
    if (told.kind[k] != ToldGaps::Kind::left_out) gaps.push_back(told.all[k]);
  return gaps;
}

double gap_reach(std::span<const double> radii, double widest_wall) {
  return kTwoLanes * radii.back() + widest_wall;
}

double most_clearance(const Gap& gap) {
  return 0.5 * (gap.two_lanes ? kTwoLanes : kOneLane) * gap.radius;
}

}  // namespace avo::inline navigation
