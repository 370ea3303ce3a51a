// SPDX-License-Identifier: Apache-2.0
#include "space/routes/passages.h"

#include <algorithm>
#include <cmath>

#include "space/arrival.h"

namespace avo::space {
namespace {

// in radii of a passage, as in the plane
constexpr double kOneLane = 4.4, kTwoLanes = 8.0;  // the widest passages
constexpr double kMouth = 1.3;                     // from the faces to the mouth
constexpr double kOpen = 0.999;  // what is left of the radius on the evasive maneuver of a mouth
constexpr double kFits = 1.0 - 1e-9;
constexpr double kDiagonal = 0.70710678118654752;  // √½

// A passage of the plane from mouth to mouth, along the x axis, with both bays at positive y.
Passage straight_passage(double length, double radius, double half_width, bool two_lanes) {
  Passage plane;
  const double out = kMouth * radius;
  plane.axis = {{0.0, 0.0}, {out, 0.0}};
  if (length > 0.0) plane.axis.push_back({out + length, 0.0});
  plane.axis.push_back({out + length + out, 0.0});
  for (const Vec2 p : plane.axis) plane.along.push_back(p.x);
  plane.direction.assign(plane.axis.size() - 1, {1.0, 0.0});
  plane.half_width = half_width, plane.radius = radius, plane.two_lanes = two_lanes;
  plane.bay_side = {-1.0, 1.0};
  return plane;
}

// Both lanes are beside each other along the wider side. Robots that go on take the lane on the
// right as far as there is one.
SpacePassage passage_of(const Tube& tube, double radius, bool two_lanes) {
  SpacePassage passage;
  const Vec3 right = cross(tube.axis, axis_across(tube.axis));
  const double side_1 = dot(tube.across_1, right), side_2 = dot(tube.across_2, right);
  const bool is_first_wider = tube.half_1 > tube.half_2 ||
                              (tube.half_1 == tube.half_2 && std::abs(side_1) >= std::abs(side_2));
  passage.axis = tube.axis;
  passage.lanes = is_first_wider ? tube.across_1 : tube.across_2;
  passage.other = is_first_wider ? tube.across_2 : tube.across_1;
  if (dot(passage.lanes, right) < 0.0) passage.lanes = -passage.lanes;
  passage.half_lanes = std::max(tube.half_1, tube.half_2);
  passage.half_other = std::min(tube.half_1, tube.half_2);
  passage.mouth = tube.begin - (kMouth * radius) * tube.axis;
  passage.plane = straight_passage(tube.length, radius, passage.half_lanes, two_lanes);
  return passage;
}

// The direction from the axis with that number, of eight.
Vec3 side(const SpacePassage& passage, std::size_t k) {
  constexpr std::array<Vec2, 8> kAround{{{1, 0},
                                         {kDiagonal, kDiagonal},
                                         {0, 1},
                                         {-kDiagonal, kDiagonal},
                                         {-1, 0},
                                         {-kDiagonal, -kDiagonal},
                                         {0, -1},
                                         {kDiagonal, -kDiagonal}}};
  return kAround[k].x * passage.lanes + kAround[k].y * passage.other;
}

// Returns whether a robot gets straight from before the mouth to the bay on that side.
bool is_bay_free(const Solids& solids, const SpacePassage& passage, bool forward, Vec3 across) {
  const double unit = passage.plane.radius, room = kOpen * unit;
  const double out = forward ? -kBayOut * unit : passage.length() + kBayOut * unit;
  const Vec3 before = passage.point(out, across, 0.0);
  return solids.is_clear(before, passage.point(out, across, kBayAside * unit), room);
}

// Returns whether both ends lead into the open.
bool is_through(const Solids& solids, const SpacePassage& passage) {
  const double unit = passage.plane.radius;
  return solids.is_clear(passage.point(-kBayOut * unit, passage.lanes, 0.0),
                         passage.point(passage.length() + kBayOut * unit, passage.lanes, 0.0),
                         kOpen * unit);
}

}  // namespace

PlaceInTube SpacePassage::place(Vec3 a) const {
  const Vec3 off = a - mouth;
  PlaceInTube place{.along = dot(off, axis), .lanes = dot(off, lanes), .other = dot(off, other)};
  place.aside = std::sqrt(place.lanes * place.lanes + place.other * place.other);
  return place;
}

bool SpacePassage::contains(Vec3 a) const {
  const PlaceInTube in = place(a);
  if (!plane.two_lanes) return is_inside(plane, {in.along, in.aside});
  return in.along > 0.0 && in.along < length() && std::abs(in.lanes) < half_lanes &&
         std::abs(in.other) < half_other;
}

SpacePassages::SpacePassages(const Solids& solids, std::span<const double> radii) {
  if (radii.empty() || solids.size() == 0) return;
  const double narrowest = 2.0 * radii.front(), widest = kTwoLanes * radii.back();
  for (const Tube& tube : find_tubes(solids, narrowest, widest)) {
    const double narrow = std::min(tube.half_1, tube.half_2);
    const double wide = 2.0 * std::max(tube.half_1, tube.half_2);
    const auto fits = std::find_if(radii.rbegin(), radii.rend(),
                                   [&](double radius) { return kFits * radius <= narrow; });
    if (fits == radii.rend() || wide >= kTwoLanes * *fits) continue;
    const SpacePassage passage = passage_of(tube, *fits, wide >= kOneLane * *fits);
    if (!is_through(solids, passage)) continue;
    all_.push_back(passage);
    auto& sides = free_sides_.emplace_back();
    for (std::size_t k = 0; k < kSides; ++k) {
      for (const bool forward : {true, false})
        sides[forward ? 0 : 1][k] = is_bay_free(solids, passage, forward, side(passage, k));
    }
  }
}

std::optional<std::uint32_t> SpacePassages::at(Vec3 place, bool two_lanes) const {
  for (std::uint32_t k = 0; k < all_.size(); ++k) {
    if (all_[k].plane.two_lanes == two_lanes && all_[k].contains(place)) return k;
  }
  return std::nullopt;
}

std::optional<SpacePassages::Crossing> SpacePassages::first_crossed(Vec3 from, Vec3 to) const {
  std::optional<Crossing> first;
  for (std::uint32_t k = 0; k < all_.size(); ++k) {
    const SpacePassage& passage = all_[k];
    if (passage.plane.two_lanes) continue;
    const double middle = 0.5 * passage.length();
    const double a = dot(from - passage.mouth, passage.axis) - middle;
    const double b = dot(to - passage.mouth, passage.axis) - middle;
    if ((a < 0.0) == (b < 0.0)) continue;
    const double part = a / (a - b);
    const PlaceInTube at = passage.place(from + part * (to - from));
    if (std::abs(at.lanes) > passage.half_lanes || std::abs(at.other) > passage.half_other)
      continue;
    if (!first || part < first->part) first = Crossing{k, part, a < 0.0};
  }
  return first;
}

Vec3 SpacePassages::side_of(std::uint32_t passage, bool forward, Vec3 place) const {
  const SpacePassage& one = all_[passage];
  const PlaceInTube in = one.place(place);
  const Vec3 own = in.lanes * one.lanes + in.other * one.other;
  const Sides& free = free_sides_[passage][forward ? 0 : 1];
  std::size_t best = kSides;
  for (std::size_t k = 0; k < kSides; ++k) {
    if (free[k] && (best == kSides || dot(side(one, k), own) > dot(side(one, best), own))) best = k;
  }
  return side(one, best == kSides ? 0 : best);
}

}  // namespace avo::space
