// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <vector>

#include "navigation/passages.h"

namespace avo::test {

inline constexpr double kWatched = 16.0;  // radii

inline Passages passages_of(const std::vector<Wall>& walls,
                            const std::vector<double>& radii = {0.5}) {
  return {walls, radii, kWatched};
}

}  // namespace avo::test
