// SPDX-License-Identifier: Apache-2.0
#include "navigator/rounded_route.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/plane.h"

namespace avo::inline navigator {
namespace {

constexpr double kTurnsBack = -0.9;  // cosine: a sharper corner is no arc, it is passed slowly
constexpr double kStraight = 1e-9;   // of a sine: no corner
constexpr double kUsed = 0.8;        // of a_max, on arcs
constexpr double kOff = 0.5;         // tolerances: the radius of a corner that turns back

// rad: by so much a robot turns within its lag, at most; with more it would leave the arc.
constexpr double kFollowed = 0.7;

double radius_of(double curvature) {
  return curvature == 0.0 ? kInfinity : 1.0 / std::abs(curvature);
}

struct Cut {
  double radius = 0.0;   // m
  double tangent = 0.0;  // m, of each piece
};

// The arc at a corner with the cosine of its turn.
Cut cut_of(double cosine, double room, const Rounding& rounding) {
  const double half = std::sqrt((1.0 - cosine) / (1.0 + cosine));  // tan φ/2
  const double beyond = std::sqrt(2.0 / (1.0 + cosine)) - 1.0;     // sec φ/2 - 1
  const double wished = std::max(rounding.tolerance / beyond, rounding.least_radius);
  const double radius = std::min(wished, room / half);
  return {radius, radius * half};
}

}  // namespace

RoundedRoute::RoundedRoute(std::span<const RoutePoint> points, const Rounding& rounding)
    : start_(points[0].place) {
  points_.push_back(0.0);
  Vec2 from = start_;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vec2 corner = points[k].place, incoming = corner - points[k - 1].place;
    if (k + 1 == points.size() || points[k].stops) {
      add_line(from, corner);
      points_.push_back(length_);
      from = corner;
      continue;
    }
    const Vec2 on = points[k + 1].place - corner;
    const double piece = norm(incoming), next = norm(on);
    from = add_corner(from, corner, incoming / piece, on / next, 0.5 * std::min(piece, next),
                      rounding);
  }
}

RoundedRoute::RoundedRoute(const Pose& from, std::span<const PathPiece> pieces)
    : start_(from.place) {
  points_.push_back(0.0);
  Pose at = from;
  for (const PathPiece& piece : pieces) {
    elements_.push_back({at.place, elementary::direction(at.heading), piece.curvature, length_,
                         piece.length, radius_of(piece.curvature)});
    at.place = point_on(elements_.back(), piece.length);
    at.heading += piece.curvature * piece.length;
    length_ += piece.length;
    points_.push_back(length_);
  }
}

void RoundedRoute::add_line(Vec2 from, Vec2 to) {
  const double length = norm(to - from);
  if (!(length > 0.0)) return;
  elements_.push_back({from, (to - from) / length, 0.0, length_, length, kInfinity});
  length_ += length;
}

Vec2 RoundedRoute::add_corner(Vec2 from, Vec2 corner, Vec2 before, Vec2 after, double room,
                              const Rounding& rounding) {
  const double cosine = dot(before, after), sine = cross(before, after);
  const bool turns_back = cosine < kTurnsBack, is_straight = std::abs(sine) < kStraight;
  if (turns_back || is_straight) {
    add_line(from, corner);
    const double radius = turns_back ? kOff * rounding.tolerance : kInfinity;
    elements_.push_back({corner, after, 0.0, length_, 0.0, radius});
    points_.push_back(length_);
    return corner;
  }
  const Cut cut = cut_of(cosine, room, rounding);
  const Vec2 start = corner - cut.tangent * before;
  add_line(from, start);
  const double length = cut.radius * std::abs(elementary::atan2(sine, cosine));
  elements_.push_back(
      {start, before, std::copysign(1.0 / cut.radius, sine), length_, length, cut.radius});
  points_.push_back(length_ + 0.5 * length);
  length_ += length;
  return corner + cut.tangent * after;
}

Vec2 RoundedRoute::point_on(const Element& element, double local) {
  if (element.curvature == 0.0) return element.from + local * element.direction;
  const Vec2 left = perpendicular(element.direction) / element.curvature;
  const Vec2 turned = elementary::direction(local * element.curvature);  // cosine, sine
  const Vec2 out = -left;
  return element.from + left +
         Vec2{turned.x * out.x - turned.y * out.y, turned.y * out.x + turned.x * out.y};
}

double RoundedRoute::nearest_on(const Element& element, Vec2 p) {
  const Vec2 off = p - element.from;
  if (element.curvature == 0.0) return std::clamp(dot(off, element.direction), 0.0, element.length);
  const Vec2 left = perpendicular(element.direction) / element.curvature;
  const Vec2 out = -left, to = off - left;
  const double side = element.curvature > 0.0 ? 1.0 : -1.0;
  const double angle = elementary::atan2(side * cross(out, to), dot(out, to));
  return std::clamp(angle * side / element.curvature, 0.0, element.length);
}

std::size_t RoundedRoute::element_at(double along) const {
  const auto after =
      std::upper_bound(elements_.begin(), elements_.end(), along,
                       [](double value, const Element& element) { return value < element.begin; });
  return after == elements_.begin() ? 0 : static_cast<std::size_t>(after - elements_.begin()) - 1;
}

Vec2 RoundedRoute::at(double along) const {
  if (elements_.empty()) return start_;
  const Element& element = elements_[element_at(along)];
  return point_on(element, std::clamp(along - element.begin, 0.0, element.length));
}

double RoundedRoute::nearest(Vec2 p, double from, double to) const {
  if (elements_.empty()) return 0.0;
  double best = from, least = kInfinity;
  for (std::size_t k = element_at(from); k < elements_.size() && elements_[k].begin <= to; ++k) {
    const double along = std::clamp(elements_[k].begin + nearest_on(elements_[k], p), from, to);
    const double distance = norm_squared(at(along) - p);
    if (distance < least) least = distance, best = along;
  }
  return best;
}

double RoundedRoute::first_near(Vec2 p, double farther, double to) const {
  const auto distance_at = [&](double along) { return norm(at(along) - p); };
  const double reach = distance_at(nearest(p, 0.0, to)) + farther;
  double best = 0.0, least = kInfinity;
  for (std::size_t k = 0; k < elements_.size() && elements_[k].begin <= to; ++k) {
    const Element& element = elements_[k];
    const double along = std::min(element.begin + nearest_on(element, p), to);
    const double distance = distance_at(along);
    if (distance < least) least = distance, best = along;
    const bool leads_away = distance_at(std::min(element.begin + element.length, to)) > reach;
    if (least <= reach && leads_away) break;
  }
  return best;
}

double RoundedRoute::top_speed(double along, double most, const Cornering& cornering) const {
  const double range = most * most / (2.0 * kUsed * cornering.braking);
  double square = most * most;
  for (std::size_t k = element_at(along); k < elements_.size(); ++k) {
    const double ahead = std::max(elements_[k].begin - along, 0.0), radius = elements_[k].radius;
    if (ahead > range) break;
    const double followed = kFollowed * radius / cornering.lag;
    const double there = std::min(kUsed * cornering.acceleration * radius, followed * followed);
    square = std::min(square, there + 2.0 * kUsed * cornering.braking * ahead);
  }
  return std::sqrt(square);
}

}  // namespace avo::inline navigator
