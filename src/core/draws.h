// SPDX-License-Identifier: Apache-2.0
// Errors of measurements, drawn from random numbers that are the same in every run.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "avo/scenario.h"
#include "core/hash.h"
#include "core/noise.h"

namespace avo::inline core {

/// The random numbers of one measurement, the same for any caller and at any time.
class Draws {
 public:
  Draws(std::uint64_t key, std::uint64_t neighbor) : key_(mixed(key, neighbor)) {}

  /// The key of all measurements that the observer makes in a generation.
  static std::uint64_t key_of(std::uint64_t seed, std::int64_t generation, std::uint64_t observer) {
    return mixed(mixed(mixed(0, seed), static_cast<std::uint64_t>(generation)), observer);
  }

  /// In [0, 1).
  double uniform() { return uniform_number(key_, count_++); }
  void gaussian(double most, GaussianDraws& draws) {
    draw_gaussian(key_, count_, most, draws);
    count_ += 2 * GaussianDraws::kTogether;
  }

 private:
  std::uint64_t key_, count_ = 0;
};

inline bool is_gaussian(const MeasurementNoise& model) {
  return model.distribution == NoiseDistribution::gaussian;
}

/// The largest error of a coordinate, in units of the scene's value.
inline double most_of_coordinate(const MeasurementNoise& model) {
  return is_gaussian(model) ? model.truncated.value_or(kUsualTruncation) : 1.0;
}

/// The errors of the first so many coordinates, in units of the scene's value. Gaussian noise is
/// drawn by rejection: it has exactly that density where it is not cut off.
template <std::size_t kCount>
std::array<double, kCount + GaussianDraws::kTogether> noise(const MeasurementNoise& model,
                                                            Draws& draws) {
  const double most = most_of_coordinate(model);
  std::array<double, kCount + GaussianDraws::kTogether> drawn;
  if (is_gaussian(model)) {
    GaussianDraws together;
    for (std::size_t count = 0; count < kCount;) {
      draws.gaussian(most, together);
      for (std::size_t k = 0; k < GaussianDraws::kTogether; ++k) {
        drawn[count] = together.x[k];
        count += static_cast<std::size_t>(together.taken[k]);
      }
    }
  } else {
    for (std::size_t k = 0; k < kCount; ++k) drawn[k] = most * (2.0 * draws.uniform() - 1.0);
  }
  return drawn;
}

}  // namespace avo::inline core
