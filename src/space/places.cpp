// SPDX-License-Identifier: Apache-2.0
#include "space/places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

#include "guidance/crowd.h"
#include "space/bodies.h"
#include "space/boxes.h"

namespace avo::space {
namespace {

double place_reach(const SpaceResting& other) {
  return (1.0 + kPlaceGap) * other.reach;
}

double distance_to_segment(Vec3 point, Vec3 a, Vec3 b) {
  const Vec3 along = b - a, to = point - a;
  const double squared = norm_squared(along);
  const double part = squared > 0.0 ? std::clamp(dot(to, along) / squared, 0.0, 1.0) : 0.0;
  return norm(to - part * along);
}

// The free place in sight of least cost, see the plane's. Each robot at rest has a ball around it.
// Candidates are the points nearest to the goal of a ball, of the circle in which two balls meet,
// and of the circle that is last seen. The others are points in which three balls meet.
class SpacePlaceSearch {
 public:
  SpacePlaceSearch(const SpaceSeeker& seeker, SpaceOccupied& occupied, std::span<const Box> boxes)
      : seeker_(seeker),
        resting_(occupied.resting),
        worth_(occupied.worth),
        boxes_(boxes),
        best_(seeker.position) {
    const double gain = (seeker.has_stood ? kGainAtRest : kGain) * seeker.radius;
    cost_ = norm(seeker.goal - seeker.position) - gain;
  }

  Vec3 best() && {
    worth_.clear();
    for (std::uint32_t i = 0; i < resting_.size(); ++i) {
      if (!may_be_worth(resting_[i])) continue;
      try_ball(resting_[i]);
      worth_.push_back(i);
    }
    return best_;
  }

 private:
  void try_ball(const SpaceResting& other) {
    const Vec3 to_goal = seeker_.goal - other.position;
    const double left = norm(to_goal);
    if (left > 0.0) try_place(other.position + (place_reach(other) / left) * to_goal);
    try_tangents(other);
    std::size_t kept = 0;
    for (const std::uint32_t k : worth_) {
      if (!may_be_worth(resting_[k])) continue;
      worth_[kept++] = k;
      try_crossing(other, resting_[k]);
    }
    worth_.resize(kept);
  }

  // Returns whether a place on its ball may be better, for any rounding.
  [[nodiscard]] bool may_be_worth(const SpaceResting& other) const {
    const double most = (1.0 + kRoundedOff) * (cost_ + place_reach(other));
    return norm_squared(other.position - seeker_.goal) <= most * most;
  }

  // The point of a circle that is nearest to the aim; none where all are as near.
  static std::optional<Vec3> nearest_on_circle(Vec3 aim, Vec3 middle, Vec3 axis, double radius) {
    const Vec3 to_aim = aim - middle;
    const Vec3 across = to_aim - dot(to_aim, axis) * axis;
    const double length = norm(across);
    if (!(length > kRoundedOff * radius)) return std::nullopt;
    return middle + (radius / length) * across;
  }

  // The point of a circle that is nearest to the goal; where all are as near, to the seeker.
  [[nodiscard]] std::optional<Vec3> nearest_on_circle(Vec3 middle, Vec3 axis, double radius) const {
    const auto place = nearest_on_circle(seeker_.goal, middle, axis, radius);
    return place ? place : nearest_on_circle(seeker_.position, middle, axis, radius);
  }

  void try_tangents(const SpaceResting& other) {
    const Vec3 line = other.position - seeker_.position;
    const double d2 = norm_squared(line), reach = place_reach(other);
    const double square = d2 - reach * reach;
    if (!(square > 0.0)) return;
    const auto place = nearest_on_circle(seeker_.position + (square / d2) * line,
                                         line / std::sqrt(d2), reach * std::sqrt(square / d2));
    if (place) try_place(*place);
  }

  void try_crossing(const SpaceResting& first, const SpaceResting& second) {
    const Vec3 between = second.position - first.position;
    const double d = norm(between), a = place_reach(first), b = place_reach(second);
    if (!(d > 0.0) || d >= a + b || d <= std::abs(a - b)) return;
    const Vec3 axis = between / d;
    const double along = (d * d + a * a - b * b) / (2.0 * d);
    const double across = std::sqrt(std::max(a * a - along * along, 0.0));
    const Vec3 middle = first.position + along * axis;
    const auto place = nearest_on_circle(middle, axis, across);
    if (!place) return;
    const SpaceResting* third = try_place(*place);
    if (third == nullptr) return;
    // the ball that covers this place, or hides it, leaves other places of the circle
    try_corners(first, axis, along, across, *third);
    if (const auto seen = nearest_on_circle(seeker_.position, middle, axis, across))
      try_place(*seen);
  }

  // Where a third ball meets the circle of two, which has that axis.
  void try_corners(const SpaceResting& first, Vec3 axis, double along, double across,
                   const SpaceResting& third) {
    const Vec3 middle = first.position + along * axis, to = third.position - middle;
    const double off = dot(to, axis), reach = place_reach(third);
    const Vec3 beside = to - off * axis;
    const double aside = norm(beside);
    if (!(aside > 0.0) || !(across > 0.0)) return;
    // a point of the circle at the angle φ from `beside` is this far from the third:
    // off² + aside² + across² - 2 aside across cos φ = reach²
    const double cosine =
        (off * off + aside * aside + across * across - reach * reach) / (2.0 * aside * across);
    if (!(std::abs(cosine) < 1.0)) return;
    const Vec3 e = beside / aside, f = cross(axis, e);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    try_place(middle + (across * cosine) * e + (across * sine) * f);
    try_place(middle + (across * cosine) * e - (across * sine) * f);
  }

  // Returns the robot at rest that occupies a place that would be worth it.
  const SpaceResting* try_place(Vec3 place) {
    const double left = norm(place - seeker_.goal);
    if (!(left < cost_)) return nullptr;
    const double cost = left + kWorth * norm(place - seeker_.position);
    if (!(cost < cost_)) return nullptr;
    for (const SpaceResting& other : resting_)
      if (!is_free_of(other, place)) return &other;
    const bool is_clear_of_boxes = std::all_of(boxes_.begin(), boxes_.end(), [&](const Box& box) {
      return nearest(seeker_.position, place, box).distance >= seeker_.radius + box.radius;
    });
    if (is_clear_of_boxes) cost_ = cost, best_ = place;
    return nullptr;
  }

  // A robot in contact with a robot at rest may leave it.
  [[nodiscard]] bool is_free_of(const SpaceResting& other, Vec3 place) const {
    const double before = norm(seeker_.position - other.position);
    const double needed = std::min((1.0 + kLineGap) * other.reach, (1.0 - kRoundedOff) * before);
    return norm(place - other.position) >= (1.0 - kRoundedOff) * place_reach(other) &&
           distance_to_segment(other.position, seeker_.position, place) >= needed;
  }

  const SpaceSeeker& seeker_;
  std::span<const SpaceResting> resting_;
  std::vector<std::uint32_t>& worth_;  // the elements of resting_ so far that were worth a test
  std::span<const Box> boxes_;
  Vec3 best_;
  double cost_ = 0.0;  // m
};

void note(const SpaceSeeker& seeker, const Neighbor& other, SpaceOccupied& seen) {
  const double reach = seeker.radius + other.radius;
  const double distance =
      norm(away_from(seeker.position, seeker.downwash, other.position, other.downwash));
  if (!(distance <= std::max(seeker.range, kBesideReach * reach))) return;
  if (norm(other.velocity) <= kStill * seeker.max_speed) {
    const Vec3 from_goal = away_from(seeker.goal, seeker.downwash, other.position, other.downwash);
    seen.resting.push_back({other.position, reach, norm_squared(from_goal), other.downwash});
    seen.is_on_goal = seen.is_on_goal || stands_on_goal(seen.resting.back());
    seen.is_near = seen.is_near || distance - reach <= kNearResting * seeker.radius;
  }
  if (distance >= kBesideReach * reach) return;
  const Vec3 out = other.position - seeker.goal;
  const double from_goal = norm(out);
  seen.comes_out =
      seen.comes_out || (from_goal < norm(seeker.position - seeker.goal) &&
                         dot(other.velocity, out) > kComesOut * seeker.max_speed * from_goal);
}

bool is_at_crowd(const SpaceSeeker& seeker, SpaceOccupied& occupied, std::span<const Box> boxes) {
  if (!occupied.is_on_goal) return false;
  const auto leads_on = [&](Vec3 from, double downwash, double reach) {
    return [&boxes, from, downwash, reach](const SpaceResting& next) {
      const Vec3 away = away_from(from, downwash, next.position, next.downwash);
      return norm(away) < reach + next.reach &&
             std::none_of(boxes.begin(), boxes.end(), [&](const Box& box) {
               return nearest(from, next.position, box).distance <= box.radius;
             });
    };
  };
  // reach is the sum of two radii: so two robots leave room for one seeker between their surfaces
  return leads_to_goal(
      occupied.resting.begin(), occupied.resting.end(),
      leads_on(seeker.position, seeker.downwash, 2.0 * seeker.radius),
      [&](const SpaceResting& one) { return leads_on(one.position, one.downwash, one.reach); });
}

}  // namespace

void look_at_goal(const SpaceSeeker& seeker, std::span<const Neighbor> neighbors,
                  SpaceOccupied& seen) {
  seen.resting.clear();
  seen.is_near = seen.is_on_goal = seen.comes_out = false;
  for (const Neighbor& other : neighbors) note(seeker, other, seen);
  const auto place = [](const SpaceResting& a) {
    return std::tuple(a.position.x, a.position.y, a.position.z);
  };
  std::sort(seen.resting.begin(), seen.resting.end(),
            [&](const SpaceResting& a, const SpaceResting& b) { return place(a) < place(b); });
}

Vec3 place_near(const SpaceSeeker& seeker, SpaceOccupied& occupied, std::span<const Box> boxes) {
  if (!occupied.is_taken()) return seeker.goal;
  return SpacePlaceSearch(seeker, occupied, boxes).best();
}

SpaceAtSharedGoal at_shared_goal(const SpaceSeeker& seeker, std::span<const Box> boxes,
                                 SpaceOccupied& occupied) {
  const bool taken = occupied.is_taken();
  if (!seeker.is_near && !taken) return {};
  const bool stays = seeker.is_near || (seeker.is_content && is_at_crowd(seeker, occupied, boxes));
  SpaceAtSharedGoal at{.has_place = true, .place = seeker.position};
  if (!stays) at.place = place_near(seeker, occupied, boxes);
  const bool is_there = at.place == seeker.position;
  const bool may_stand =
      is_there && (stays || (seeker.is_at_rest && is_at_crowd(seeker, occupied, boxes)));
  at.has_stood = (is_there && seeker.has_stood) || (may_stand && seeker.is_at_rest);
  // until it has stood, it brakes whatever pushes it
  at.is_taken = (taken && !occupied.comes_out) || (seeker.is_near && !at.has_stood);
  return at;
}

}  // namespace avo::space
