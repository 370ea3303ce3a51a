// SPDX-License-Identifier: Apache-2.0
#include "navigation/join_gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "walls/segment.h"

namespace avo {
namespace {

constexpr double kMouth = 1.3;     // radii: from the outermost gap to the mouth
constexpr double kSampling = 0.5;  // radii
constexpr double kJoint = 1e-3;    // radii: nobody sees through where pieces of walls touch

// Radii, between neighboring gaps of a passage: the farthest within which there are no more gaps
// than kMostNear, or else the first one.
constexpr std::array kRanges{16.0, 32.0, 64.0, 128.0, 256.0};
constexpr std::size_t kMostNear = 500;

constexpr std::uint32_t kNoGap = 0xffffffff;

// What a gap has on each of its sides: 0 is ahead, 1 behind.
struct Links {
  std::array<std::uint32_t, 2> gap{kNoGap, kNoGap};
  std::array<int, 2> count{0, 0};
};

// Joins gaps to passages. A passage ends where it widens, and where it branches.
class Joiner {
 public:
  Joiner(const ClearanceGrid& grid, std::vector<Gap> gaps)
      : grid_(grid), gaps_(std::move(gaps)), links_(gaps_.size()) {
    std::vector<Wall> lines, middles;
    double largest = 0.0;
    for (const Gap& gap : gaps_) {
      lines.push_back({gap.a, gap.b, 0.0}), middles.push_back({gap.middle(), gap.middle(), 0.0});
      largest = std::max(largest, gap.radius);
    }
    if (gaps_.empty()) return;
    joint_ = kJoint * largest;
    sight_.emplace(grid.walls(), kSampling * largest);
    lines_.emplace(lines, largest);
    for (const double range : kRanges) ranges_.emplace_back(middles, range * largest);
    for (std::uint32_t i = 0; i < gaps_.size(); ++i) range_.push_back(range_of(i));
  }

  // Also the gaps, each with the way along the axis of its passage to its left.
  std::vector<Passage> join(std::vector<Wall>& gaps, std::vector<std::uint32_t>& passage_of_gap) {
    for (std::uint32_t i = 0; i < gaps_.size(); ++i) link(i);
    std::vector<Passage> all;
    std::vector<bool> taken(gaps_.size(), false);
    for (std::uint32_t i = 0; i < gaps_.size(); ++i) {
      if (taken[i]) continue;
      auto [gap, side] = first_of(i);
      const auto number = static_cast<std::uint32_t>(all.size());
      Passage& passage = all.emplace_back();
      passage.two_lanes = gaps_[gap].two_lanes;
      passage.half_width = std::numeric_limits<double>::infinity();
      const Vec2 before = outward(gap, 1 - side);
      while (true) {
        taken[gap] = true;
        const Gap& here = gaps_[gap];
        passage.axis.push_back(here.middle());
        passage.half_width = std::min(passage.half_width, 0.5 * here.width());
        passage.radius = std::max(passage.radius, here.radius);
        gaps.push_back(side == 0 ? Wall{here.a, here.b} : Wall{here.b, here.a});
        passage_of_gap.push_back(number);
        const std::uint32_t then = next(gap, side);
        if (then == kNoGap || taken[then]) break;
        side = 1 - side_towards(then, gap);
        gap = then;
      }
      finish(passage, before, outward(gap, side));
    }
    return all;
  }

 private:
  Vec2 outward(std::uint32_t gap, std::size_t side) const {
    return side == 0 ? gaps_[gap].ahead() : -1.0 * gaps_[gap].ahead();
  }
  std::size_t side_of(std::uint32_t gap, Vec2 p) const {
    return dot(p - gaps_[gap].middle(), gaps_[gap].ahead()) > 0.0 ? 0 : 1;
  }
  std::size_t side_towards(std::uint32_t gap, std::uint32_t other) const {
    return side_of(gap, gaps_[other].middle());
  }

  // Whether some wall is nearer than that; most often the one that was before.
  bool is_nearer_wall(Vec2 p, double limit) {
    const std::span<const Wall> walls = grid_.walls();
    const auto is_nearer = [&](std::size_t k) {
      return distance(p, {walls[k].a, walls[k].b}) - walls[k].radius < limit;
    };
    return is_nearer(nearer_wall_) || !grid_.all_near(p, p, [&](std::size_t k) {
      if (!is_nearer(k)) return true;
      nearer_wall_ = k;
      return false;
    });
  }

  // Whether the way from one gap's middle to that of another one of its kind is as narrow all
  // along, and leads through no third one.
  bool is_narrow_between(std::uint32_t i, std::uint32_t k) {
    const Gap &one = gaps_[i], &other = gaps_[k];
    const Vec2 from = one.middle(), to = other.middle();
    if (one.two_lanes != other.two_lanes ||
        norm(to - from) > ranges_[std::min(range_[i], range_[k])].reach())
      return false;
    if (!sight_->is_clear(from, to, joint_)) return false;  // nearly all pairs end here
    const double limit = std::min(most_clearance(one), most_clearance(other));
    const double samples =
        std::ceil(norm(to - from) / (kSampling * std::min(one.radius, other.radius)));
    for (double n = 1.0; n < samples; n += 1.0) {
      if (is_wide(from + (n / samples) * (to - from), to - from, limit)) return false;
    }
    return lines_->all_near(from, to, [&](std::size_t third) {
      if (third == i || third == k || gaps_[third].two_lanes != one.two_lanes) return true;
      return nearest_points({from, to}, {gaps_[third].a, gaps_[third].b}).distance > 0.0;
    });
  }

  // Whether there is so much room at p, or beside it: a way along a wall is not narrow for that.
  bool is_wide(Vec2 p, Vec2 way, double room) {
    const Vec2 left = (room / norm(way)) * perpendicular(way);
    for (const Vec2 place : {p, p + left, p - left}) {
      if (sight_->is_clear(p, place, joint_) && !is_nearer_wall(place, room)) return true;
    }
    return false;
  }

  std::size_t range_of(std::uint32_t i) const {
    const Vec2 middle = gaps_[i].middle();
    for (std::size_t range = ranges_.size() - 1; range > 0; --range) {
      std::size_t count = 0;
      const bool are_few = ranges_[range].all_near(
          middle, middle, [&](std::size_t) { return ++count <= kMostNear; });
      if (are_few) return range;
    }
    return 0;
  }

  void link(std::uint32_t i) {
    const Vec2 middle = gaps_[i].middle();
    std::vector<std::uint32_t> others;
    ranges_[range_[i]].all_near(middle, middle, [&](std::size_t k) {
      if (k > i) others.push_back(static_cast<std::uint32_t>(k));
      return true;
    });
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (const std::uint32_t k : others) {
      if (!is_narrow_between(i, k)) continue;
      const std::size_t ahead = side_towards(i, k), back = side_towards(k, i);
      links_[i].gap[ahead] = k, ++links_[i].count[ahead];
      links_[k].gap[back] = i, ++links_[k].count[back];
    }
  }

  // The next gap of the passage; none where it ends or branches.
  std::uint32_t next(std::uint32_t i, std::size_t side) const {
    const std::uint32_t k = links_[i].gap[side];
    if (links_[i].count[side] != 1) return kNoGap;
    return links_[k].count[side_towards(k, i)] == 1 ? k : kNoGap;
  }

  // Where the passage of gap i begins, and on which side of that gap it goes on; of a ring, i.
  std::pair<std::uint32_t, std::size_t> first_of(std::uint32_t i) const {
    std::uint32_t gap = i;
    std::size_t back = 1;
    for (std::uint32_t k = next(gap, back); k != kNoGap && k != i; k = next(gap, back)) {
      back = 1 - side_towards(k, gap);
      gap = k;
    }
    return {gap, 1 - back};
  }

  static void finish(Passage& passage, Vec2 before, Vec2 behind) {
    std::vector<Vec2>& axis = passage.axis;
    const double reach = kMouth * passage.radius;
    axis.insert(axis.begin(), axis.front() + reach * before);
    axis.push_back(axis.back() + reach * behind);
    passage.along.push_back(0.0);
    for (std::size_t k = 1; k < axis.size(); ++k) {
      const double length = norm(axis[k] - axis[k - 1]);
      passage.along.push_back(passage.along.back() + length);
      passage.direction.push_back((axis[k] - axis[k - 1]) / length);
    }
  }

  const ClearanceGrid& grid_;
  std::vector<Gap> gaps_;
  std::vector<Links> links_;
  double joint_ = 0.0;                  // m
  std::optional<ClearanceGrid> sight_;  // of the walls, for straight ways
  std::optional<ClearanceGrid> lines_;  // of the gaps
  std::vector<ClearanceGrid> ranges_;   // of their middles
  std::vector<std::size_t> range_;      // of each gap
  std::size_t nearer_wall_ = 0;
};

}  // namespace

std::vector<Passage> join_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps,
                               std::vector<Wall>& lines, std::vector<std::uint32_t>& passage_of) {
  return Joiner(grid, std::move(gaps)).join(lines, passage_of);
}

}  // namespace avo
