// SPDX-License-Identifier: Apache-2.0
// Cubics by dense sampling in long double.
#pragma once
#include <algorithm>
#include <cstddef>

#include "check/relative_path.h"

namespace avo::judge {

using Real = long double;

struct Place {
  Real x = 0, y = 0;
};

inline Place place_at(const RelativePath& path, Real u) {
  const Real q = 1 - u;
  const Real weight[] = {q * q * q, 3 * q * q * u, 3 * q * u * u, u * u * u};
  Place place;
  for (std::size_t k = 0; k < 4; ++k) {
    place.x += weight[k] * static_cast<Real>(path.control[k].x);
    place.y += weight[k] * static_cast<Real>(path.control[k].y);
  }
  return place;
}

/// The least distance(u) on [0, 1]: by samples, then by thirds around each of their minima.
template <typename Distance>
Real least_by_samples(const Distance& distance) {
  constexpr int kSamples = 500;
  Real best = std::min(distance(0), distance(1));
  for (int k = 1; k < kSamples; ++k) {
    Real low = static_cast<Real>(k - 1) / kSamples, high = static_cast<Real>(k + 1) / kSamples;
    const Real here = distance(static_cast<Real>(k) / kSamples);
    if (here > distance(low) || here > distance(high)) continue;
    for (int i = 0; i < 90; ++i) {
      const Real third = (high - low) / 3;
      if (distance(low + third) < distance(high - third))
        high -= third;
      else
        low += third;
    }
    best = std::min(best, distance(low));
  }
  return best;
}

}  // namespace avo::judge
