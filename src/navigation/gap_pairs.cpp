// SPDX-License-Identifier: Apache-2.0
#include "navigation/gap_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

constexpr double kSampling = 0.5;  // radii
constexpr double kJoint = 1e-3;    // radii: lines of sight do not pass where pieces of walls touch

// Radii, between neighboring gaps of a passage: the largest range with no more gaps than kMostNear,
// or otherwise the first one.
constexpr std::array kRanges{16.0, 32.0, 64.0, 128.0, 256.0};
constexpr std::size_t kMostNear = 500;

double largest_of(std::span<const Gap> gaps) {
  double largest = 0.0;
  for (const Gap& gap : gaps) largest = std::max(largest, gap.radius);
  return largest;
}

class GapPairing {
 public:
  GapPairing(const ClearanceGrid& grid, std::vector<Gap> gaps) : grid_(grid) {
    found_.gaps = std::move(gaps);
    if (found_.gaps.empty()) return;
    std::vector<Wall> lines, middles;
    for (const Gap& gap : found_.gaps)
      lines.push_back({gap.a, gap.b, 0.0}), middles.push_back({gap.middle(), gap.middle(), 0.0});
    const double largest = largest_of(found_.gaps);
    joint_ = kJoint * largest;
    sight_.emplace(grid.walls(), kSampling * largest);
    lines_.emplace(lines, largest);
    for (const double range : kRanges) ranges_.emplace_back(middles, range * largest);
    for (std::uint32_t i = 0; i < found_.gaps.size(); ++i) found_.range.push_back(range_of(i));
    is_new_.assign(found_.gaps.size(), 1);
  }

  // Keeps pairs of old gaps that are searched for in the same range as before. Far from new or
  // removed walls and gaps the free space between them has not changed.
  void keep(const GapPairs& before, const WallChanges& changes,
            const std::vector<std::uint32_t>& number) {
    const double largest = largest_of(found_.gaps);
    if (found_.gaps.empty() || largest != largest_of(before.gaps)) return;
    double clearance = 0.0;
    for (const Gap& gap : found_.gaps) clearance = std::max(clearance, most_clearance(gap));
    changed_ = changes.around(2.0 * clearance + largest);
    std::vector<char> is_there(found_.gaps.size(), 0);
    for (std::uint32_t old = 0; old < number.size(); ++old) {
      const std::uint32_t now = number[old];
      if (now == kNoGap)
        add_change(before.gaps[old]);
      else
        is_there[now] = 1, is_new_[now] = before.range[old] != found_.range[now];
    }
    for (std::uint32_t k = 0; k < is_there.size(); ++k) {
      if (is_there[k] == 0) add_change(found_.gaps[k]);
      if (is_new_[k] != 0) new_.push_back(k);
    }
    if (new_.size() > kMostNew) {
      is_new_.assign(found_.gaps.size(), 1);
      return;
    }
    keeps_ = true;
    for (const auto& [i, k] : before.joined) {
      if (number[i] != kNoGap && number[k] != kNoGap && stays(number[i], number[k]))
        found_.joined.push_back({number[i], number[k]});
    }
  }

  GapPairs find() {
    for (std::uint32_t i = 0; i < found_.gaps.size(); ++i) {
      if (keeps_ && is_new_[i] == 0 && !is_near_change(i))
        look_at(i, new_);
      else
        look_around(i);
    }
    return std::move(found_);
  }

 private:
  static constexpr std::size_t kMostNew = 256;

  void add_change(const Gap& gap) {
    changed_.push_back({gap.middle(), 0.5 * gap.width() + joint_});
  }
  // Tests the range in which others are searched for.
  bool is_near_change(std::uint32_t i) const {
    const double reach = (1.0 + kLengthRounding) * ranges_[found_.range[i]].reach();
    return is_in_one(changed_, found_.gaps[i].middle(), reach);
  }
  bool stays(std::uint32_t i, std::uint32_t k) const {
    if (is_new_[i] != 0 || is_new_[k] != 0) return false;
    const Segment line{found_.gaps[i].middle(), found_.gaps[k].middle()};
    return std::none_of(changed_.begin(), changed_.end(), [&](const Zone& zone) {
      return distance(zone.center, line) <= zone.reach;
    });
  }

  // Returns whether a wall is nearer than that; most often it is the one of the test before.
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

  bool are_in_range(std::uint32_t i, std::uint32_t k) const {
    const double reach = ranges_[std::min(found_.range[i], found_.range[k])].reach();
    return norm(found_.gaps[k].middle() - found_.gaps[i].middle()) <= reach;
  }

  // Returns whether the free space between the middles of two gaps of one kind is narrow all along,
  // and has no third gap.
  bool is_narrow_between(std::uint32_t i, std::uint32_t k) {
    const Gap &one = found_.gaps[i], &other = found_.gaps[k];
    const Vec2 from = one.middle(), to = other.middle();
    if (one.two_lanes != other.two_lanes || !are_in_range(i, k)) return false;
    ++found_.tested;
    if (!sight_->is_clear(from, to, joint_)) return false;  // nearly all pairs end here
    const double limit = std::min(most_clearance(one), most_clearance(other));
    const double samples =
        std::ceil(norm(to - from) / (kSampling * std::min(one.radius, other.radius)));
    for (double n = 1.0; n < samples; n += 1.0) {
      if (is_wide(from + (n / samples) * (to - from), to - from, limit)) return false;
    }
    return lines_->all_near(from, to, [&](std::size_t third) {
      const Gap& gap = found_.gaps[third];
      if (third == i || third == k || gap.two_lanes != one.two_lanes) return true;
      return nearest_points({from, to}, {gap.a, gap.b}).distance > 0.0;
    });
  }

  // Returns whether there is so much room at p, or beside it: free space along a wall is not narrow
  // for that reason.
  bool is_wide(Vec2 p, Vec2 line, double room) {
    const Vec2 left = (room / norm(line)) * perpendicular(line);
    for (const Vec2 place : {p, p + left, p - left}) {
      if (sight_->is_clear(p, place, joint_) && !is_nearer_wall(place, room)) return true;
    }
    return false;
  }

  // The number of the range.
  std::uint8_t range_of(std::uint32_t i) const {
    const Vec2 middle = found_.gaps[i].middle();
    for (std::size_t range = ranges_.size() - 1; range > 0; --range) {
      if (ranges_[range].count_near(middle) <= kMostNear) return static_cast<std::uint8_t>(range);
    }
    return 0;
  }

  // Tests the gaps of a higher number.
  void look_around(std::uint32_t i) {
    const Vec2 middle = found_.gaps[i].middle();
    others_.clear();
    ranges_[found_.range[i]].all_near(middle, middle, [&](std::size_t k) {
      others_.push_back(static_cast<std::uint32_t>(k));
      return true;
    });
    std::sort(others_.begin(), others_.end());
    others_.erase(std::unique(others_.begin(), others_.end()), others_.end());
    look_at(i, others_);
  }
  void look_at(std::uint32_t i, const std::vector<std::uint32_t>& others) {
    for (const std::uint32_t k : others) {
      if (k > i && !(keeps_ && stays(i, k)) && is_narrow_between(i, k))
        found_.joined.push_back({i, k});
    }
  }

  const ClearanceGrid& grid_;
  GapPairs found_;
  double joint_ = 0.0;                  // m
  std::optional<ClearanceGrid> sight_;  // of the walls, for segments
  std::optional<ClearanceGrid> lines_;  // of the gaps
  std::vector<ClearanceGrid> ranges_;   // of their middles
  std::vector<std::uint32_t> others_;
  std::size_t nearer_wall_ = 0;
  bool keeps_ = false;
  std::vector<char> is_new_;        // by gap: it is new, or its range has changed
  std::vector<std::uint32_t> new_;  // the new ones
  std::vector<Zone> changed_;
};

}  // namespace

GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps) {
  return GapPairing(grid, std::move(gaps)).find();
}

GapPairs pair_gaps(const ClearanceGrid& grid, std::vector<Gap> gaps, const GapPairs& before,
                   const WallChanges& changes, const std::vector<std::uint32_t>& number) {
  GapPairing pairing(grid, std::move(gaps));
  pairing.keep(before, changes, number);
  return pairing.find();
}

}  // namespace avo::inline navigation
