// SPDX-License-Identifier: Apache-2.0
#include "navigation/passages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "navigation/gaps.h"
#include "navigation/join_gaps.h"
#include "walls/segment.h"

namespace avo {
namespace {

constexpr double kBeside = 0.5;       // radii: nearer to the walls nobody is in the way in
constexpr double kBayRoom = 0.999;    // of the radius, on the straight way to a bay
constexpr double kPocket = 1.1;       // radii behind a gap: where a robot stands in a pocket
constexpr double kOutOfPocket = 2.0;  // radii from there: who gets so far is in none
constexpr double kAtBends = 1.4;  // of half the width: nobody behind a wall is as near to the axis

// Around the whole axis.
Wall capsule_of(const Passage& passage) {
  Wall capsule{passage.axis.front(), passage.axis.back(), 0.0};
  for (const Vec2 p : passage.axis)
    capsule.radius = std::max(capsule.radius, distance(p, {capsule.a, capsule.b}));
  return capsule;
}

// Whether a robot gets straight from before the mouth to the bay on that side.
bool is_bay_free(const ClearanceGrid& grid, const Passage& passage, bool forward, double side) {
  const AxisPoint mouth = axis_point(passage, forward, 0.0);
  const double unit = passage.radius, room = kBayRoom * unit;
  const Vec2 before = mouth.point - kBayOut * unit * mouth.direction;
  const Vec2 bay = before - side * kBayAside * unit * perpendicular(mouth.direction);
  return grid.is_clear(mouth.point, before, room) && grid.is_clear(before, bay, room);
}

// Whether there is room for a robot on one side of the gap, and it gets nowhere from there: nobody
// wants through who has not its goal there.
bool leads_into_pocket(const ClearanceGrid& grid, const Gap& gap) {
  if (gap.two_lanes) return false;
  const double room = kBayRoom * gap.radius, farther = kOutOfPocket * gap.radius;
  const Vec2 middle = gap.middle();
  for (const Vec2 ahead : {gap.ahead(), -1.0 * gap.ahead()}) {
    const Vec2 inside = middle + kPocket * gap.radius * ahead, left = perpendicular(ahead);
    const std::array ways{ahead, left, -1.0 * left, (ahead + left) / std::numbers::sqrt2,
                          (ahead - left) / std::numbers::sqrt2};
    const bool has_room = grid.is_clear(middle, inside, room);
    if (has_room && std::none_of(ways.begin(), ways.end(), [&](Vec2 way) {
          return grid.is_clear(inside, inside + farther * way, room);
        }))
      return true;
  }
  return false;
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
  std::vector<Gap> gaps = find_gaps(grid, radii);
  std::erase_if(gaps, [&](const Gap& gap) { return leads_into_pocket(grid, gap); });
  std::vector<Wall> lines;
  std::vector<std::uint32_t> passage_of;
  all_ = join_gaps(grid, std::move(gaps), lines, passage_of);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    GapLines& kind = all_[passage_of[k]].two_lanes ? two_lanes_ : one_lane_;
    kind.walls.push_back(lines[k]), kind.passage_of.push_back(passage_of[k]);
  }
  choose_bays(grid);
  if (!all_.empty()) index(watched);
}

void Passages::choose_bays(const ClearanceGrid& grid) {
  for (Passage& passage : all_) {
    for (const bool forward : {true, false}) {
      if (!passage.two_lanes && !is_bay_free(grid, passage, forward, 1.0) &&
          is_bay_free(grid, passage, forward, -1.0))
        passage.bay_side[forward ? 0 : 1] = -1.0;
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

std::optional<Passages::Crossing> Passages::first_narrow(Vec2 p, Vec2 q) const {
  const std::optional<Crossing> one = one_lane_.first_crossed(p, q);
  const std::optional<Crossing> two = two_lanes_.first_crossed(p, q);
  if (!one || !two) return one ? one : two;
  return two->part < one->part ? two : one;
}

}  // namespace avo
