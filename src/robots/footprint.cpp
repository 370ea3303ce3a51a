// SPDX-License-Identifier: Apache-2.0
// Covers of bodies by discs in a row.
#include "avo/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "avo/discs.h"
#include "avo/error.h"
#include "avo/model.h"
#include "core/elementary.h"
#include "core/ranges.h"
#include "robots/footprint.h"

namespace avo {
namespace {

// A body from the rearmost to the foremost x, and the largest |y| of it, m.
struct BodyExtent {
  double rear, front, side;
};

// m: the radius that covers the part of the body within `half` of the center along x.
// radius_of(from, to, center) covers the part between two values of x.
template <typename RadiusOf>
std::optional<Footprint> cover_by(int discs, const BodyExtent& body, double excess,
                                  const RadiusOf& radius_of) {
  const double spacing = (body.front - body.rear) / discs, first = body.rear + 0.5 * spacing;
  double radius = body.side;
  for (int k = 0; k < discs; ++k) {
    const double center = first + k * spacing;
    radius = std::max(radius, radius_of(center - 0.5 * spacing, center + 0.5 * spacing, center));
  }
  if (radius > body.side + excess) return std::nullopt;
  return Footprint{discs, radius, first, discs > 1 ? spacing : 0.0};
}

template <typename RadiusOf>
Footprint fewest(const BodyExtent& body, double excess, const RadiusOf& radius_of) {
  for (int discs = 1; discs <= Footprint::kMostDiscs; ++discs)
    if (const auto cover = cover_by(discs, body, excess, radius_of)) return *cover;
  const double infinity = std::numeric_limits<double>::infinity();
  const Footprint closest = *cover_by(Footprint::kMostDiscs, body, infinity, radius_of);
  refuse("excess", text(excess) + " m",
         ">= " + text(closest.radius - body.side) + " m: so far do " +
             std::to_string(Footprint::kMostDiscs) + " discs exceed the sides");
}

// The corners of a polygon within a range of x, and where its edges enter and leave that range.
double radius_within(std::span<const Vec2> corners, double from, double to, double center) {
  double most = 0.0;
  const auto take = [&](Vec2 p) { most = std::max(most, norm(p - Vec2{center, 0.0})); };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 a = corners[k], b = corners[(k + 1) % corners.size()];
    if (a.x >= from && a.x <= to) take(a);
    for (const double x : {from, to})
      if ((a.x < x) != (b.x < x)) take({x, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)});
  }
  return most;
}

}  // namespace

Footprint cover_rectangle(double length, double width, double offset, double excess) {
  require("length", length, kPositive, "m");
  require("width", width, kPositive, "m");
  require("offset", offset, kAnyValue, "m");
  require("excess", excess, kNotNegative, "m");
  const double half = 0.5 * width;
  return fewest({offset - 0.5 * length, offset + 0.5 * length, half}, excess,
                [half](double from, double to, double) {
                  return norm(Vec2{0.5 * (to - from), half});
                });
}

Footprint cover_polygon(std::span<const Vec2> corners, double excess) {
  if (corners.size() < 3)
    refuse("corners", std::to_string(corners.size()) + " corners", "3 or more");
  require("excess", excess, kNotNegative, "m");
  BodyExtent body{kLargest, -kLargest, 0.0};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    require("corners." + std::to_string(k), corners[k], "m");
    body.rear = std::min(body.rear, corners[k].x), body.front = std::max(body.front, corners[k].x);
    body.side = std::max(body.side, std::abs(corners[k].y));
  }
  if (!(body.front > body.rear && body.side > 0.0))
    refuse("corners", "a line", "the corners of a polygon");
  return fewest(body, excess, [corners](double from, double to, double center) {
    return radius_within(corners, from, to, center);
  });
}

std::vector<Disc> discs_at(const RobotSetup& robot, Vec2 position, double heading) {
  const Vec2 center = disc_center(robot.model, position, heading);
  const Footprint footprint = footprint_of(robot.model);
  if (!footprint) return {{center, disc_radius(robot)}};
  const Vec2 ahead = elementary::direction(heading);
  std::vector<Disc> discs;
  discs.reserve(static_cast<std::size_t>(footprint.discs));
  for (int k = 0; k < footprint.discs; ++k)
    discs.push_back({center + footprint.ahead(k) * ahead, footprint.radius});
  return discs;
}

Footprint footprint_of(const MotionModel& model) {
  if (const Car* car = std::get_if<Car>(&model)) return car->footprint;
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  if (drive == nullptr || !drive->footprint) return {};
  Footprint about_disc = drive->footprint;
  about_disc.first -= drive->offset;
  return about_disc;
}

}  // namespace avo

namespace avo::inline robots {

bool is_valid(const Footprint& footprint) {
  return footprint.discs >= 0 && footprint.discs <= Footprint::kMostDiscs &&
         kPositive.contains(footprint.radius) && kAnyValue.contains(footprint.first) &&
         kNotNegative.contains(footprint.spacing);
}

}  // namespace avo::inline robots
