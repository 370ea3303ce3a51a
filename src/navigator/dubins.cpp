// SPDX-License-Identifier: Apache-2.0
#include "navigator/dubins.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "core/plane.h"

namespace avo::inline navigator {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kRounding = 1e-7;  // rad, and radii: what rounding leaves of nothing

// [0, 2π)
double positive(double angle) {
  const double turned = angle - kTurn * std::floor(angle / kTurn);
  return turned < kTurn - kRounding ? turned : 0.0;
}

double arc_cosine(double x) {
  return elementary::atan2(std::sqrt(std::max(1.0 - x * x, 0.0)), x);
}

// The problem in circles' radii, with the goal on the x axis: distance, headings, and their
// cosines and sines.
struct Normal {
  double d = 0.0, a = 0.0, b = 0.0;
  Vec2 of_a, of_b;
  double together = 0.0;  // cosine of a - b

  explicit Normal(const Pose& from, const Pose& to, double radius) {
    const Vec2 line = to.place - from.place;
    const double along = elementary::atan2(line.y, line.x);
    d = norm(line) / radius, a = positive(from.heading - along), b = positive(to.heading - along);
    of_a = elementary::direction(a), of_b = elementary::direction(b), together = dot(of_a, of_b);
  }
};

// Angles of the first and the last arc, and the length or the angle between.
struct Word {
  double first, middle, last;
  [[nodiscard]] double length() const { return first + middle + last; }
};

// Two arcs to the same side, side 1 left, with a straight piece between.
std::optional<Word> same_side(const Normal& n, double side) {
  const double a = side * n.of_a.y, b = side * n.of_b.y;  // sines
  const double square = 2.0 + n.d * n.d - 2.0 * n.together + 2.0 * n.d * (a - b);
  if (square < -kRounding) return std::nullopt;
  const double turn = elementary::atan2(n.of_b.x - n.of_a.x, n.d + a - b);
  return Word{positive(-side * n.a + turn), std::sqrt(std::max(square, 0.0)),
              positive(side * n.b - turn)};
}

// The first arc to that side, the last one to the other.
std::optional<Word> other_side(const Normal& n, double side) {
  const double sum = side * (n.of_a.y + n.of_b.y);
  const double square = -2.0 + n.d * n.d + 2.0 * n.together + 2.0 * n.d * sum;
  if (square < -kRounding) return std::nullopt;
  const double middle = std::sqrt(std::max(square, 0.0));
  const double turn =
      elementary::atan2(-n.of_a.x - n.of_b.x, n.d + sum) - elementary::atan2(-2.0, middle);
  return Word{positive(-side * n.a + turn), middle, positive(-side * n.b + turn)};
}

// Three arcs, the middle one to the other side.
std::optional<Word> three_arcs(const Normal& n, double side) {
  const double difference = side * (n.of_b.y - n.of_a.y);
  const double cosine = (6.0 - n.d * n.d + 2.0 * n.together + 2.0 * n.d * difference) / 8.0;
  if (std::abs(cosine) > 1.0 + kRounding) return std::nullopt;
  const double middle = positive(kTurn - arc_cosine(cosine));
  const double turn = elementary::atan2(n.of_a.x - n.of_b.x, n.d - difference);
  const double first = positive(-side * n.a - turn + 0.5 * middle);
  return Word{first, middle, positive(side * (n.b - n.a) - first + middle)};
}

}  // namespace

std::array<PathPiece, 3> dubins_path(const Pose& from, const Pose& to, double radius) {
  const Normal n(from, to, radius);
  std::array<PathPiece, 3> best{};
  double least = kInfinity;
  const auto take = [&](const std::optional<Word>& word, double first, double middle, double last) {
    if (!word || !(word->length() < least)) return;
    least = word->length();
    best = {{{first / radius, radius * word->first},
             {middle / radius, radius * word->middle},
             {last / radius, radius * word->last}}};
  };
  for (const double side : {1.0, -1.0}) {
    take(same_side(n, side), side, 0.0, side);
    take(other_side(n, side), side, 0.0, -side);
    take(three_arcs(n, side), side, -side, side);
  }
  return best;
}

}  // namespace avo::inline navigator
