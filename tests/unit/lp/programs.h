// SPDX-License-Identifier: Apache-2.0
// Random programs: as a planner meets them, in general position, degenerate, nearly degenerate.
#pragma once
#include <iterator>
#include <ostream>

#include "unit/lp/brute_force.h"

namespace avo::test {

/// Usual most of the time; else one of those that squares and quotients cannot hold.
inline double any_number(Random& random) {
  constexpr double kNumbers[] = {0,       1,        -1,     2,      1e-6,   1e7,
                                 -1e7,    1e100,    -1e150, 1e155,  -1e200, 1e300,
                                 1.7e308, -1.7e308, 5e-324, 1e-310, -1e-200};
  return random.chance(0.7) ? random.uniform(-2.0, 2.0)
                            : kNumbers[random.below(std::size(kNumbers))];
}

/// What a robot of the paper solves: speed at most 2, reach 4, half-planes near the velocity.
inline Program planner_program(Random& random) {
  Program p;
  const Vec2 v = random.vector(0.0, 2.0);
  p.acceleration = {v, random.chance(0.5) ? 4.0 : random.uniform(0.1, 3.0)};
  p.speed = {{0, 0}, 2.0};
  p.preferred = random.vector(0.0, 2.0);
  const double crowd = random.uniform(-2.0, 0.5);  // how far the half-planes leave v alone
  for (int n = random.below(13); n > 0; --n) {
    const Vec2 normal = random.unit();
    p.soft.push_back({normal, dot(normal, v) + random.uniform(crowd - 0.5, crowd + 0.5)});
  }
  for (int n = random.below(3); n > 0; --n) {
    const Vec2 normal = random.unit();
    p.hard.push_back({normal, dot(normal, v) - random.uniform(-0.2, 2.0)});
  }
  return p;
}

/// Any two discs that meet or nearly do, any size from 1e-6 to 1e7, away from the origin.
inline Program general_program(Random& random) {
  Program p;
  const double scale = std::pow(10.0, random.uniform(-6.0, 7.0));
  p.speed = {scale * random.in_square(3.0), scale * random.uniform(0.2, 2.0)};
  const double radius = scale * random.uniform(0.2, 2.0);
  const double gap = random.uniform(0.0, 1.05) * (p.speed.radius + radius);
  p.acceleration = {p.speed.center + gap * random.unit(), radius};
  p.preferred = p.speed.center + scale * random.in_square(4.0);
  for (int n = random.below(10); n > 0; --n) {
    const Vec2 normal = random.unit();
    const Vec2 on = 0.5 * (p.speed.center + p.acceleration.center) + scale * random.in_square(1.2);
    (random.chance(0.2) ? p.hard : p.soft).push_back({normal, dot(normal, on)});
  }
  return p;
}

/// Numbers from a coarse grid: parallel, opposite, equal and concurrent half-planes, discs that
/// touch, are equal, nested, or points.
inline Program degenerate_program(Random& random) {
  Program p;
  constexpr double kHalf = 0.70710678118654752;
  constexpr Vec2 kNormals[] = {{1, 0},         {0, 1},          {-1, 0},          {0, -1},
                               {kHalf, kHalf}, {-kHalf, kHalf}, {-kHalf, -kHalf}, {kHalf, -kHalf},
                               {0.6, 0.8},     {-0.8, 0.6},     {-0.6, -0.8},     {0.8, -0.6}};
  const auto grid = [&](int n) { return 0.25 * (random.below(2 * n + 1) - n); };
  p.speed = {{grid(4), grid(4)}, 0.25 * random.below(9)};
  p.acceleration = {{grid(4), grid(4)}, 0.25 * random.below(9)};
  if (random.chance(0.1)) p.acceleration.radius = std::numeric_limits<double>::infinity();
  if (random.chance(0.2)) p.acceleration.center = p.speed.center;
  if (random.chance(0.2)) p.acceleration.radius = p.speed.radius;
  p.preferred = {grid(12), grid(12)};
  const Vec2 hub{grid(4), grid(4)};
  const bool concurrent = random.chance(0.4);
  for (int n = random.below(9); n > 0; --n) {
    const Vec2 normal = kNormals[random.below(12)];
    const double offset = concurrent && random.chance(0.8) ? dot(normal, hub) : grid(6);
    (random.chance(0.3) ? p.hard : p.soft).push_back({normal, offset});
  }
  return p;
}

/// The degenerate ones, every number off by a relative 1e-16 to 1e-1.
inline Program nearly_degenerate_program(Random& random) {
  Program p = degenerate_program(random);
  const double size = std::pow(10.0, random.uniform(-16.0, -1.0));
  const auto nudge = [&](double& x) {
    if (random.chance(0.7)) x += size * random.uniform(-1.0, 1.0);
  };
  for (Disc* disc : {&p.acceleration, &p.speed}) {
    nudge(disc->center.x), nudge(disc->center.y), nudge(disc->radius);
    disc->radius = std::max(disc->radius, 0.0);
  }
  nudge(p.preferred.x), nudge(p.preferred.y);
  for (std::vector<HalfPlane>* planes : {&p.hard, &p.soft}) {
    for (HalfPlane& plane : *planes) {
      nudge(plane.normal.x), nudge(plane.normal.y), nudge(plane.offset);
      plane.normal = plane.normal / norm(plane.normal);
    }
  }
  return p;
}

/// The discs differ by up to nine decades in size. Their circles cross, touch or nearly touch.
inline Program lopsided_program(Random& random) {
  Program p;
  const double scale = std::pow(10.0, random.uniform(-6.0, 7.0));
  const double ratio = std::pow(10.0, random.uniform(0.0, 9.0));
  const double near = random.chance(0.5) ? random.uniform(-1.0, 1.0)
                                         : 1.0 - std::pow(10.0, random.uniform(-17.0, 0.0));
  Disc small{scale * random.in_square(1.0), scale};
  const double apart = ratio + (random.chance(0.5) ? near : -near);
  Disc large{small.center + scale * apart * random.unit(), scale * ratio};
  if (random.chance(0.3)) small.center = {0, 0}, large.center = {large.radius + scale * near, 0};
  p.acceleration = random.chance(0.5) ? small : large;
  p.speed = p.acceleration.radius == small.radius ? large : small;
  p.preferred = small.center + scale * random.in_square(3.0);
  for (int n = random.below(8); n > 0; --n) {
    const Vec2 normal = random.unit();
    const Vec2 on = small.center + scale * random.in_square(1.0);
    (random.chance(0.2) ? p.hard : p.soft).push_back({normal, dot(normal, on)});
  }
  return p;
}

using Generator = Program (*)(Random&);
struct Family {
  const char* name;
  Generator make;
};
inline std::ostream& operator<<(std::ostream& out, const Family& family) {
  return out << family.name;
}

constexpr Family kFamilies[] = {{"planner", planner_program},
                                {"general", general_program},
                                {"degenerate", degenerate_program},
                                {"nearly degenerate", nearly_degenerate_program},
                                {"lopsided", lopsided_program}};

}  // namespace avo::test
