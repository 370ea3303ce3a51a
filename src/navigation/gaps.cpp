// SPDX-License-Identifier: Apache-2.0
#include "navigation/gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "core/hash.h"
#include "walls/segment.h"

namespace avo {
namespace {

constexpr double kOneLane = 4.4;        // radii: two robots with a tenth of their size to each side
constexpr double kTwoLanes = 8.0;       // radii: wider ways need no lanes
constexpr double kTouchingEnds = 1e-3;  // of the least radius: ends as near as that are joined
constexpr double kStraight = 1e-6;      // rad: less is no bend
constexpr double kLeadsInto = 1e-3;     // cosine: then a joined wall certainly leads into the gap
constexpr double kMostUnlike =
    100.0;  // times the least radius: rounding is less than that certainty

class GapFinder {
 public:
  GapFinder(const ClearanceGrid& grid, std::span<const double> radii)
      : grid_(grid),
        radii_(radii),
        touching_(kTouchingEnds * radii.front()),
        joints_(grid.walls(), touching_) {}

  std::vector<Gap> find() {
    const std::span<const Wall> walls = grid_.walls();
    for (const Wall& wall : walls) {
      if (!goes_on(wall, wall.b, wall.a)) add_at(wall.a, wall.radius);
      if (!(wall.a == wall.b) && !goes_on(wall, wall.a, wall.b)) add_at(wall.b, wall.radius);
    }
    return without_repeated_and_diagonal();
  }

 private:
  bool is_joined(Vec2 p, Vec2 q) const { return norm(p - q) <= touching_; }

  // Whether other walls, as thick, lead straight on from the wall's end: then nothing is narrowest
  // there, and in how many pieces a wall is given makes no difference.
  bool goes_on(const Wall& wall, Vec2 from, Vec2 end) const {
    const Vec2 way = end - from;
    return !joints_.all_near(end, end, [&](std::size_t k) {
      const Wall& other = grid_.walls()[k];
      if (other.radius < wall.radius || distance(end, {other.a, other.b}) > touching_) return true;
      const auto leads_on = [&](Vec2 to) {
        const Vec2 on = to - end;
        return !is_joined(to, end) && dot(on, way) > 0.0 &&
               std::abs(cross(on, way)) <= kStraight * norm(on) * norm(way);
      };
      return !leads_on(other.a) && !leads_on(other.b);
    });
  }

  // Pieces that touch at an end tell of the same gaps.
  bool is_new(Vec2 end, double radius) {
    const std::uint64_t place = mixed(mixed(0, word_of(end.x)), word_of(end.y));
    return looked_at_.insert(mixed(place, word_of(radius))).second;
  }

  // Units, of walls, no thinner, that begin at this end: they lead into the circle of whatever gap
  // lies ahead of them.
  void find_leaving(Vec2 end, double end_radius) {
    leaving_.clear();
    if (radii_.back() > kMostUnlike * radii_.front()) return;
    joints_.all_near(end, end, [&](std::size_t k) {
      const Wall& wall = grid_.walls()[k];
      if (wall.radius < end_radius) return true;
      if (wall.a == end || wall.b == end) {
        const Vec2 way = wall.a == end ? wall.b - end : wall.a - end;
        if (norm(way) > touching_) leaving_.push_back(way / norm(way));
      }
      return true;
    });
  }
  bool is_ahead(const Wall& wall, Vec2 end, double farthest) const {
    const double least = kLeadsInto * farthest;
    return std::any_of(leaving_.begin(), leaving_.end(), [&](Vec2 way) {
      return dot(way, wall.a - end) > least && dot(way, wall.b - end) > least;
    });
  }

  // Whether some wall is nearer; most often the one that was for the gap before.
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

  // The gaps between this end and the walls around it, with nothing else in between.
  void add_at(Vec2 end, double end_radius) {
    if (!is_new(end, end_radius)) return;
    find_leaving(end, end_radius);
    const double rounding = kLengthRounding * radii_.back();
    const double farthest = end_radius + grid_.reach();
    grid_.all_near(end, end, [&](std::size_t k) {
      const Wall& wall = grid_.walls()[k];
      if (is_ahead(wall, end, farthest)) return true;
      const Vec2 nearest = nearest_on({wall.a, wall.b}, end);
      const double between = norm(end - nearest);
      const double width = between - end_radius - wall.radius;
      if (between <= touching_ || width < 2.0 * radii_.front() - rounding) return true;
      const double radius =
          *(std::upper_bound(radii_.begin(), radii_.end(), 0.5 * width + rounding) - 1);
      if (width >= kTwoLanes * radius) return true;
      const Vec2 across = (nearest - end) / between;
      const Gap gap{end + end_radius * across, nearest - wall.radius * across, radius,
                    width >= kOneLane * radius};
      if (!is_blocked(gap.middle(), 0.5 * width - rounding)) gaps_.push_back(gap);
      return true;
    });
  }

  bool is_same(const Gap& one, const Gap& other) const {
    return (is_joined(one.a, other.a) && is_joined(one.b, other.b)) ||
           (is_joined(one.a, other.b) && is_joined(one.b, other.a));
  }
  bool shares_end(const Gap& one, const Gap& other) const {
    return is_joined(one.a, other.a) || is_joined(one.a, other.b) || is_joined(one.b, other.a) ||
           is_joined(one.b, other.b);
  }

  // Both ends of a gap may have told of it. And where ways cross there are gaps from corner to
  // corner, which are not where any of them is narrowest: another one, no wider, crosses them.
  std::vector<Gap> without_repeated_and_diagonal() const {
    std::vector<Wall> lines;
    for (const Gap& gap : gaps_) lines.push_back({gap.a, gap.b, 0.0});
    const ClearanceGrid near(lines, radii_.front());
    std::vector<Gap> kept;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const Gap& gap = gaps_[i];
      const bool is_narrowest = near.all_near(gap.a, gap.b, [&](std::size_t k) {
        const Gap& other = gaps_[k];
        if (k == i) return true;
        if (is_same(gap, other)) return i < k;
        if (shares_end(gap, other) || other.width() > (1.0 + kLengthRounding) * gap.width())
          return true;
        return nearest_points({gap.a, gap.b}, {other.a, other.b}).distance > 0.0;
      });
      if (is_narrowest) kept.push_back(gap);
    }
    return kept;
  }

  const ClearanceGrid& grid_;
  std::span<const double> radii_;
  double touching_;
  ClearanceGrid joints_;  // tells walls that touch
  std::unordered_set<std::uint64_t> looked_at_;
  std::vector<Vec2> leaving_;
  std::array<std::size_t, 8> blocking_{};  // walls, the last one first
  std::vector<Gap> gaps_;
};

}  // namespace

std::vector<Gap> find_gaps(const ClearanceGrid& grid, std::span<const double> radii) {
  return GapFinder(grid, radii).find();
}

double gap_reach(std::span<const double> radii, double widest_wall) {
  return kTwoLanes * radii.back() + widest_wall;
}

double most_clearance(const Gap& gap) {
  return 0.5 * (gap.two_lanes ? kTwoLanes : kOneLane) * gap.radius;
}

}  // namespace avo
