// SPDX-License-Identifier: Apache-2.0
#include "navigation/passages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "navigation/gaps.h"
#include "walls/segment.h"

namespace avo {
namespace {

constexpr double kMouth = 1.3;     // radii: from the outermost gap to the mouth
constexpr double kBeside = 0.5;    // radii: nearer to the walls nobody is in the way in
constexpr double kAtBends = 1.4;   // of half the width: nobody behind a wall is as near to the axis
constexpr double kSampling = 0.5;  // radii
constexpr double kJoint = 1e-3;    // radii: nobody sees through where pieces of walls touch
constexpr double kFarthest = 256.0;  // radii, between neighboring gaps of a passage

constexpr std::uint32_t kNone = 0xffffffff;

// What a gap has on each of its sides: 0 is ahead, 1 behind.
struct Links {
  std::array<std::uint32_t, 2> gap{kNone, kNone};
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
    middles_.emplace(middles, kFarthest * largest);
  }

  // Also the gaps of one lane, each with the way along the axis of its passage to its left.
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
        if (!here.two_lanes) {
          gaps.push_back(side == 0 ? Wall{here.a, here.b} : Wall{here.b, here.a});
          passage_of_gap.push_back(number);
        }
        const std::uint32_t then = next(gap, side);
        if (then == kNone || taken[then]) break;
        side = 1 - side_towards(then, gap);
        gap = then;
      }
      finish(passage, before, outward(gap, side));
    }
    return all;
  }

 private:
  Vec2 outward(std::uint32_t gap, int side) const {
    return side == 0 ? gaps_[gap].ahead() : -1.0 * gaps_[gap].ahead();
  }
  int side_of(std::uint32_t gap, Vec2 p) const {
    return dot(p - gaps_[gap].middle(), gaps_[gap].ahead()) > 0.0 ? 0 : 1;
  }
  int side_towards(std::uint32_t gap, std::uint32_t other) const {
    return side_of(gap, gaps_[other].middle());
  }

  // Whether the way from one gap's middle to that of another one of its kind is as narrow all
  // along, and leads through no third one.
  bool is_narrow_between(std::uint32_t i, std::uint32_t k) const {
    const Gap &one = gaps_[i], &other = gaps_[k];
    const Vec2 from = one.middle(), to = other.middle();
    if (one.two_lanes != other.two_lanes || norm(to - from) > middles_->reach()) return false;
    if (!sight_->is_clear(from, to, joint_)) return false;  // nearly all pairs end here
    const double limit = std::min(most_clearance(one), most_clearance(other));
    const double samples =
        std::ceil(norm(to - from) / (kSampling * std::min(one.radius, other.radius)));
    for (double n = 1.0; n < samples; n += 1.0) {
      if (grid_.clearance(from + (n / samples) * (to - from)) >= limit) return false;
    }
    return lines_->all_near(from, to, [&](std::size_t third) {
      if (third == i || third == k || gaps_[third].two_lanes != one.two_lanes) return true;
      return nearest_points({from, to}, {gaps_[third].a, gaps_[third].b}).distance > 0.0;
    });
  }

  void link(std::uint32_t i) {
    const Vec2 middle = gaps_[i].middle();
    std::vector<std::uint32_t> others;
    middles_->all_near(middle, middle, [&](std::size_t k) {
      if (k > i) others.push_back(static_cast<std::uint32_t>(k));
      return true;
    });
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    for (const std::uint32_t k : others) {
      if (!is_narrow_between(i, k)) continue;
      const int ahead = side_towards(i, k), back = side_towards(k, i);
      links_[i].gap[ahead] = k, ++links_[i].count[ahead];
      links_[k].gap[back] = i, ++links_[k].count[back];
    }
  }

  // The next gap of the passage; none where it ends or branches.
  std::uint32_t next(std::uint32_t i, int side) const {
    const std::uint32_t k = links_[i].gap[side];
    if (links_[i].count[side] != 1) return kNone;
    return links_[k].count[side_towards(k, i)] == 1 ? k : kNone;
  }

  // Where the passage of gap i begins, and on which side of that gap it goes on; of a ring, i.
  std::pair<std::uint32_t, int> first_of(std::uint32_t i) const {
    std::uint32_t gap = i;
    int back = 1;
    for (std::uint32_t k = next(gap, back); k != kNone && k != i; k = next(gap, back)) {
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
  double joint_ = 0.0;                            // m
  std::optional<ClearanceGrid> sight_;            // of the walls, for straight ways
  std::optional<ClearanceGrid> lines_, middles_;  // of the gaps
};

double widest_of(std::span<const Wall> walls) {
  double widest = 0.0;
  for (const Wall& wall : walls) widest = std::max(widest, wall.radius);
  return widest;
}

// Around the whole axis.
Wall capsule_of(const Passage& passage) {
  Wall capsule{passage.axis.front(), passage.axis.back(), 0.0};
  for (const Vec2 p : passage.axis)
    capsule.radius = std::max(capsule.radius, distance(p, {capsule.a, capsule.b}));
  return capsule;
}

}  // namespace

PassagePlace place_in(const Passage& passage, Vec2 p) {
  PassagePlace place;
  double least = std::numeric_limits<double>::infinity();  // m², from the axis
  const std::size_t pieces = passage.direction.size();
  for (std::size_t k = 0; k < pieces; ++k) {
    const Vec2 from = passage.axis[k], direction = passage.direction[k];
    const double straight_on = dot(p - from, direction);
    double t = straight_on;
    if (k > 0) t = std::max(t, 0.0);
    if (k + 1 < pieces) t = std::min(t, passage.along[k + 1] - passage.along[k]);
    const double off = norm_squared(p - (from + t * direction));
    if (off >= least) continue;
    least = off;
    const double left = cross(direction, p - from);
    place = {passage.along[k] + t, t == straight_on ? left : std::copysign(std::sqrt(off), left)};
  }
  return place;
}

bool is_inside(const Passage& passage, const PassagePlace& place) {
  if (!(place.along > 0.0) || !(place.along < passage.length())) return false;
  const double aside = std::abs(place.aside);
  const std::size_t last = passage.along.size() - 1;
  const bool is_between = place.along > passage.along[1] && place.along < passage.along[last - 1];
  if (is_between) return aside < kAtBends * passage.half_width;
  return aside < passage.half_width - (passage.two_lanes ? 0.0 : kBeside * passage.radius);
}

AxisPoint axis_point(const Passage& passage, bool forward, double along) {
  if (!forward) along = passage.length() - along;
  std::size_t k = 0;
  while (k + 2 < passage.axis.size() && along > passage.along[k + 1]) ++k;
  const Vec2 direction = passage.direction[k];
  const Vec2 point = passage.axis[k] + (along - passage.along[k]) * direction;
  return {point, forward ? direction : -1.0 * direction};
}

Passages::Passages(std::span<const Wall> walls, std::span<const double> radii, double watched) {
  if (walls.empty() || radii.empty()) return;
  const ClearanceGrid grid(walls, gap_reach(radii, widest_of(walls)));
  std::vector<Wall> gaps;
  all_ = Joiner(grid, find_gaps(grid, radii)).join(gaps, gap_of_);
  if (!all_.empty()) index(gaps, watched);
}

void Passages::index(const std::vector<Wall>& gaps, double watched) {
  std::vector<Wall> axes, capsules;
  double widest = 0.0, radius = 0.0;
  for (std::uint32_t number = 0; number < all_.size(); ++number) {
    const Passage& passage = all_[number];
    widest = std::max(widest, passage.half_width), radius = std::max(radius, passage.radius);
    for (std::size_t k = 1; k < passage.axis.size(); ++k) {
      axes.push_back({passage.axis[k - 1], passage.axis[k], 0.0});
      axis_of_.push_back(number);
    }
    if (passage.two_lanes) continue;
    capsules.push_back(capsule_of(passage));
    watched_of_.push_back(number);
  }
  axes_.emplace(axes, kAtBends * widest);
  if (gaps.empty()) return;
  gaps_.emplace(gaps, radius);
  watched_.emplace(capsules, watched * radius);
}

std::optional<std::uint32_t> Passages::at(Vec2 p) const {
  std::optional<std::uint32_t> best;
  double least = std::numeric_limits<double>::infinity();
  if (!axes_) return best;
  axes_->all_near(p, p, [&](std::size_t k) {
    const std::uint32_t number = axis_of_[k];
    const Wall& piece = axes_->walls()[k];
    if (number == best || distance(p, {piece.a, piece.b}) >= kAtBends * all_[number].half_width)
      return true;
    const PassagePlace place = place_in(all_[number], p);
    if (!is_inside(all_[number], place)) return true;
    const bool two_lanes = all_[number].two_lanes;
    if (best && two_lanes != all_[*best].two_lanes ? two_lanes : std::abs(place.aside) >= least)
      return true;
    best = number, least = std::abs(place.aside);
    return true;
  });
  return best;
}

std::optional<Passages::Crossing> Passages::first_crossed(Vec2 p, Vec2 q) const {
  std::optional<Crossing> first;
  if (!gaps_) return first;
  const Vec2 way = q - p;
  gaps_->all_near(p, q, [&](std::size_t k) {
    const Wall& gap = gaps_->walls()[k];
    const Vec2 across = gap.b - gap.a;
    const double from = cross(across, p - gap.a), to = cross(across, q - gap.a);
    if ((from < 0.0) == (to < 0.0)) return true;
    if ((cross(way, gap.a - p) < 0.0) == (cross(way, gap.b - p) < 0.0)) return true;
    const double part = from / (from - to);
    if (!first || part < first->part) first = Crossing{gap_of_[k], part, to > from};
    return true;
  });
  return first;
}

}  // namespace avo
