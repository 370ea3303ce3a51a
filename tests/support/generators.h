// SPDX-License-Identifier: Apache-2.0
// Situations of two robots for tests: wide ranges, and deliberately near-degenerate cases.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <ostream>

#include "avo/velocity_obstacle.h"

namespace avo::test {

/// SplitMix64: the same numbers on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  Vec2 direction() {
    const double angle = uniform(-std::numbers::pi, std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
  /// Returns 0, or 10^-16 to 10^-1 of either sign: the distance to a degenerate case.
  double near_zero() {
    const int kind = below(4);
    if (kind == 0) return 0.0;
    return (kind == 1 ? -1.0 : 1.0) * log_uniform(1e-16, 1e-1);
  }

 private:
  std::uint64_t state_;
};

/// Returns a point uniform in the disc about 0. (One draw per statement: C++ leaves the order
/// within a statement open.)
inline Vec2 in_disc(Random& random, double radius) {
  const double length = radius * std::sqrt(random.uniform(0.0, 1.0));
  return length * random.direction();
}

/// A pair, and the parameters of its plan.
struct Situation {
  Pair pair;
  double reach = 0.0;         // m/s
  double control_time = 0.0;  // s
  double time_horizon = 0.0;  // s
};

inline std::ostream& operator<<(std::ostream& out, const Situation& s) {
  out.precision(17);
  return out << "p {" << s.pair.position.x << ", " << s.pair.position.y << "} v {"
             << s.pair.velocity.x << ", " << s.pair.velocity.y << "} r " << s.pair.radius
             << " reach " << s.reach << " delta " << s.control_time << " tau " << s.time_horizon;
}

/// Returns a pair without contact, and nothing degenerate. The ranges are: δ 0.05 to 10 s, τ 0.2 to
/// 20 s, |v| to 5 m/s, r and reach over two to three decades. Distances range from nearly touching
/// to out of reach.
inline Situation wide_situation(Random& random) {
  Situation s;
  s.control_time = random.log_uniform(0.05, 10.0);
  s.time_horizon = random.log_uniform(0.2, 20.0);
  s.reach = random.below(2) == 0 ? s.control_time * random.uniform(0.3, 6.0)
                                 : random.log_uniform(0.05, 40.0);
  s.pair.radius = random.log_uniform(0.03, 5.0);
  const double gap = random.below(2) == 0 ? s.pair.radius * random.log_uniform(1e-3, 30.0)
                                          : random.uniform(0.0, 14.0);
  s.pair.position = (s.pair.radius + gap) * random.direction();
  s.pair.velocity = in_disc(random, 5.0);
  return s;
}

/// Returns the same pair, at most in contact: rounding may have made it overlap.
inline Situation apart(Situation s) {
  while (norm(s.pair.position) < s.pair.radius) s.pair.radius *= 1.0 - 0x1p-52;
  return s;
}

/// Returns a pair as above, moved next to (or exactly onto) one special case. Cases are: at rest,
/// parallel, head-on, in contact, grazing at the miss distance, on an axis, tiny or huge reach. The
/// pair never overlaps at the start.
inline Situation degenerate_situation(Random& random) {
  Situation s = wide_situation(random);
  Vec2& p = s.pair.position;
  Vec2& v = s.pair.velocity;
  const double r = s.pair.radius;
  const double speed = norm(v);
  if (random.below(3) == 0) p = norm(p) * (random.below(2) == 0 ? Vec2{1.0, 0.0} : Vec2{0.0, -1.0});
  switch (random.below(8)) {
    case 0:
      v = {0.0, 0.0};
      break;
    case 1:
      v = random.log_uniform(1e-18, 1e-3) * v;
      break;
    case 2:
      v = (-speed / norm(p)) * (p + random.near_zero() * perpendicular(p));
      break;
    case 3:
      v = (speed / norm(p)) * (p + random.near_zero() * perpendicular(p));
      break;
    case 4:
      p = (r * (1.0 + std::abs(random.near_zero())) / norm(p)) * p;
      break;
    case 5: {  // miss distance close to r
      const double sine = std::min(1.0, r / norm(p) * (1.0 + random.near_zero()));
      const double cosine = std::sqrt(1.0 - sine * sine);
      v = (speed / norm(p)) * (-cosine * p + sine * perpendicular(p));
      break;
    }
    case 6:
      v = (speed / norm(p)) * (perpendicular(p) + random.near_zero() * p);
      break;
    default:
      s.reach *= random.below(2) == 0 ? 1e-6 : 1e6;
      break;
  }
  // and additionally in contact, or nearly in contact
  if (random.below(6) == 0) p = (r * (1.0 + std::abs(random.near_zero())) / norm(p)) * p;
  return apart(s);
}

/// Returns lengths × `length`, times × `time`.
inline Situation scaled(const Situation& s, double length, double time) {
  const double speed = length / time;
  return {{length * s.pair.position, speed * s.pair.velocity, length * s.pair.radius},
          speed * s.reach,
          time * s.control_time,
          time * s.time_horizon};
}

/// Returns situations of which half are wide and half degenerate; lengths over 13 decades, times
/// over 4.
inline Situation any_situation(Random& random) {
  const Situation s = random.below(2) == 0 ? wide_situation(random) : degenerate_situation(random);
  if (random.below(2) == 0) return s;
  const double length = random.log_uniform(1e-6, 1e7);
  const double time = random.log_uniform(1e-2, 1e2);
  return apart(scaled(s, length, time));
}

inline Obstacle obstacle_of(const Situation& s) {
  return {s.pair, Response::proportional(s.control_time), s.time_horizon};
}

}  // namespace avo::test
