// SPDX-License-Identifier: Apache-2.0
#include "navigation/join_gaps.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

namespace avo::inline navigation {
namespace {

constexpr double kMouth = 1.3;  // radii: from the outermost gap to the mouth

// The next gaps on each side of a gap: 0 is ahead, 1 behind.
struct Links {
  std::array<std::uint32_t, 2> gap{kNoGap, kNoGap};
  std::array<int, 2> count{0, 0};
};

// Joins gaps to passages. A passage ends where it widens, and where it branches.
class Joiner {
 public:
  explicit Joiner(const GapPairs& pairs) : gaps_(pairs.gaps), links_(gaps_.size()) {
    for (const auto& [i, k] : pairs.joined) link(i, k);
  }

  // Also gives the gaps, each with the direction of the axis of its passage to its left.
  std::vector<Passage> join(std::vector<Wall>& gaps, std::vector<std::uint32_t>& passage_of_gap) {
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

  void link(std::uint32_t i, std::uint32_t k) {
    const std::size_t ahead = side_towards(i, k), back = side_towards(k, i);
    links_[i].gap[ahead] = k, ++links_[i].count[ahead];
    links_[k].gap[back] = i, ++links_[k].count[back];
  }

  // The next gap of the passage; none where it ends or branches.
  std::uint32_t next(std::uint32_t i, std::size_t side) const {
    const std::uint32_t k = links_[i].gap[side];
    if (links_[i].count[side] != 1) return kNoGap;
    return links_[k].count[side_towards(k, i)] == 1 ? k : kNoGap;
  }

  // The first gap of the passage of gap i, and the side of that gap on which the passage goes on;
  // for a ring, i.
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

  std::span<const Gap> gaps_;
  std::vector<Links> links_;
};

}  // namespace

std::vector<Passage> join_gaps(const GapPairs& pairs, std::vector<Wall>& lines,
                               std::vector<std::uint32_t>& passage_of) {
  return Joiner(pairs).join(lines, passage_of);
}

}  // namespace avo::inline navigation
