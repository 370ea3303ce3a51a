// SPDX-License-Identifier: Apache-2.0
#include "navigation/passages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "core/hash.h"
#include "navigation/gaps.h"
#include "navigation/join_gaps.h"
#include "walls/segment.h"

namespace avo::inline navigation {
namespace {

constexpr double kBeside = 0.5;     // radii: nearer to the walls a robot is not in the entrance
constexpr double kBayRoom = 0.999;  // of the radius, on the segment to a bay
// of half the width: no robot behind a wall is this near to the axis
constexpr double kAtBends = 1.4;

// The capsule around the whole axis.
Wall capsule_of(const Passage& passage) {
  Wall capsule{passage.axis.front(), passage.axis.back(), 0.0};
  for (const Vec2 p : passage.axis)
    capsule.radius = std::max(capsule.radius, distance(p, {capsule.a, capsule.b}));
  return capsule;
}

// Returns whether a robot can move straight from before the mouth to the bay on that side.
bool is_bay_free(const ClearanceGrid& grid, const Passage& passage, bool forward, double side) {
  const AxisPoint mouth = axis_point(passage, forward, 0.0);
  const double unit = passage.radius, room = kBayRoom * unit;
  const Vec2 before = mouth.point - kBayOut * unit * mouth.direction;
  const Vec2 bay = before - side * kBayAside * unit * perpendicular(mouth.direction);
  return grid.is_clear(mouth.point, before, room) && grid.is_clear(before, bay, room);
}

// Chooses the right side, unless there is room only on the left.
void choose_bay(const ClearanceGrid& grid, Passage& passage, bool forward) {
  if (!is_bay_free(grid, passage, forward, 1.0) && is_bay_free(grid, passage, forward, -1.0))
    passage.bay_side[forward ? 0 : 1] = -1.0;
}

std::uint64_t hash_of(const Passage& passage) {
  std::uint64_t hash = 0;
  for (const Vec2 p : {passage.axis.front(), passage.axis.back()})
    hash = mixed(mixed(hash, word_of(p.x)), word_of(p.y));
  return hash;
}

// The gaps that lead somewhere, and the number of each found gap among them.
std::vector<Gap> open_gaps(const ToldGaps& told, std::vector<std::uint32_t>& number) {
  std::vector<Gap> open;
  number.assign(told.all.size(), kNoGap);
  for (const std::uint32_t k : told.numbers_of(ToldGaps::Kind::open)) {
    number[k] = static_cast<std::uint32_t>(open.size());
    open.push_back(told.all[k]);
  }
  return open;
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

Passages::Passages(std::span<const Wall> walls, std::span<const double> radii, double watched)
    : walls_(walls.begin(), walls.end()), radii_(radii.begin(), radii.end()) {
  find(nullptr, watched);
}

Passages::Passages(std::span<const Wall> walls, std::span<const double> radii, double watched,
                   Passages before)
    : walls_(walls.begin(), walls.end()), radii_(radii.begin(), radii.end()) {
  const bool is_like = before.radii_ == radii_ && !before.walls_.empty() && !walls_.empty() &&
                       widest_of(before.walls_) == widest_of(walls_) &&
                       WallChanges(before.walls_, walls_).are_few();
  find(is_like ? &before : nullptr, watched);
}

void Passages::find(const Passages* before, double watched) {
  if (walls_.empty() || radii_.empty()) return;
  const ClearanceGrid grid(walls_, gap_reach(radii_, widest_of(walls_)));
  std::vector<Wall> lines;
  std::vector<std::uint32_t> passage_of;
  if (before != nullptr) {
    const WallChanges changes(before->walls_, walls_);
    find_pairs(grid, *before, changes);
    all_ = join_gaps(pairs_, lines, passage_of);
    keep_bays(grid, *before, changes.around(grid.reach()));
  } else {
    std::vector<std::uint32_t> open_of;
    told_ = tell_gaps(grid, radii_);
    pairs_ = pair_gaps(grid, open_gaps(told_, open_of));
    all_ = join_gaps(pairs_, lines, passage_of);
    choose_bays(grid);
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    GapLines& kind = all_[passage_of[k]].two_lanes ? two_lanes_ : one_lane_;
    kind.walls.push_back(lines[k]), kind.passage_of.push_back(passage_of[k]);
  }
  if (!all_.empty()) index(watched);
}

void Passages::find_pairs(const ClearanceGrid& grid, const Passages& before,
                          const WallChanges& changes) {
  std::vector<std::uint32_t> told_now, open_of, old_open_of;
  told_ = tell_gaps(grid, radii_, before.told_, changes, told_now);
  std::vector<Gap> open = open_gaps(told_, open_of);
  (void)open_gaps(before.told_, old_open_of);
  std::vector<std::uint32_t> open_now(before.pairs_.gaps.size(), kNoGap);
  for (std::size_t k = 0; k < told_now.size(); ++k) {
    const std::uint32_t old = old_open_of[k], now = told_now[k];
    if (old != kNoGap && now != kNoGap) open_now[old] = open_of[now];
  }
  pairs_ = pair_gaps(grid, std::move(open), before.pairs_, changes, open_now);
}

void Passages::choose_bays(const ClearanceGrid& grid) {
  for (Passage& passage : all_) {
    if (passage.two_lanes) continue;
    for (const bool forward : {true, false}) choose_bay(grid, passage, forward);
  }
}

// Keeps the bays far from all changes.
void Passages::keep_bays(const ClearanceGrid& grid, const Passages& before,
                         std::span<const Zone> changed) {
  std::unordered_map<std::uint64_t, std::uint32_t> number_before;
  for (std::uint32_t k = 0; k < before.size(); ++k) number_before[hash_of(before[k])] = k;
  for (Passage& passage : all_) {
    if (passage.two_lanes) continue;
    const auto found = number_before.find(hash_of(passage));
    const bool is_there = found != number_before.end() &&
                          before[found->second].axis == passage.axis &&
                          before[found->second].radius == passage.radius;
    for (const bool forward : {true, false}) {
      const Vec2 mouth = forward ? passage.axis.front() : passage.axis.back();
      const std::size_t side = forward ? 0 : 1;
      if (is_there && !is_in_one(changed, mouth, 0.0))
        passage.bay_side[side] = before[found->second].bay_side[side];
      else
        choose_bay(grid, passage, forward);
    }
  }
}

void Passages::index(double watched) {
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
  for (GapLines* kind : {&one_lane_, &two_lanes_})
    if (!kind->walls.empty()) kind->grid.emplace(kind->walls, radius);
  if (!capsules.empty()) watched_.emplace(capsules, watched * radius);
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

std::optional<Passages::Crossing> Passages::GapLines::first_crossed(Vec2 p, Vec2 q) const {
  std::optional<Crossing> first;
  if (!grid) return first;
  grid->all_near(p, q, [&](std::size_t k) {
    const Wall& gap = grid->walls()[k];
    if (!leads_across({gap.a, gap.b}, p, q)) return true;
    const Vec2 across = gap.b - gap.a;
    const double from = cross(across, p - gap.a), to = cross(across, q - gap.a);
    const double part = from / (from - to);
    if (!first || part < first->part)
      first = Crossing{passage_of[k], part, to > from, {gap.a, gap.b}};
    return true;
  });
  return first;
}

std::optional<Passages::Crossing> Passages::first_crossed(Vec2 p, Vec2 q) const {
  return one_lane_.first_crossed(p, q);
}

Segment Passages::narrowest_gap(std::uint32_t number) const {
  Segment narrowest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < one_lane_.walls.size(); ++k) {
    const Wall& gap = one_lane_.walls[k];
    if (one_lane_.passage_of[k] != number || !(norm(gap.b - gap.a) < least)) continue;
    narrowest = {gap.a, gap.b}, least = norm(gap.b - gap.a);
  }
  return narrowest;
}

std::optional<Passages::Crossing> Passages::first_narrow(Vec2 p, Vec2 q) const {
  const std::optional<Crossing> one = one_lane_.first_crossed(p, q);
  const std::optional<Crossing> two = two_lanes_.first_crossed(p, q);
  if (!one || !two) return one ? one : two;
  return two->part < one->part ? two : one;
}

}  // namespace avo::inline navigation
