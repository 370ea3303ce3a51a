// SPDX-License-Identifier: Apache-2.0
// Random numbers and vectors of space for tests.
#pragma once
#include <cstdint>
#include <random>

#include "avo/vec3.h"

namespace avo::space::tests {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : generator_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(generator_() >> 11U) * 0x1p-53);
  }
  int below(int count) { return static_cast<int>(generator_() % static_cast<unsigned>(count)); }
  /// A unit vector, in all directions alike.
  Vec3 direction() {
    for (;;) {
      const Vec3 a{between(-1, 1), between(-1, 1), between(-1, 1)};
      const double squared = norm_squared(a);
      if (squared > 1e-3 && squared < 1.0) return a / norm(a);
    }
  }
  Vec3 within(double radius) { return between(0.0, radius) * direction(); }

 private:
  std::mt19937_64 generator_;
};

}  // namespace avo::space::tests
