// SPDX-License-Identifier: Apache-2.0
// The density of a crowd.
#include "density.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "placement.h"

namespace avo::safety {
namespace {

// Returns the part of a disc of radius r beyond a chord that lies `offset` from its center.
double segment(double r, double offset) {
  const double cosine = std::clamp(offset / r, -1.0, 1.0);
  return r * r * (std::acos(cosine) - cosine * std::sqrt(1.0 - cosine * cosine));
}

// Returns the area that two discs with a distance d between their centers have in common.
double common_area(double d, double a, double b) {
  if (d >= a + b) return 0.0;
  const double smaller = std::min(a, b);
  if (d <= std::abs(a - b)) return kPi * smaller * smaller;
  const double from_a = 0.5 * (d * d + a * a - b * b) / d;  // to the common chord
  return segment(a, from_a) + segment(b, d - from_a);
}

}  // namespace

double densest_disc(const FleetView& fleet) {
  const std::size_t count = fleet.position.size();
  Vec2 centroid;
  for (const Vec2 p : fleet.position) centroid = centroid + p;
  centroid = centroid / static_cast<double>(count);
  std::vector<double> distance;
  for (const Vec2 p : fleet.position) distance.push_back(norm(p - centroid));
  std::vector<double> reaches = distance;
  std::sort(reaches.begin(), reaches.end());
  double densest = 0.0;
  for (std::size_t k = count / 4; k < count; ++k) {
    const double reach = reaches[k];
    if (!(reach > 0.0)) continue;
    double covered = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      covered += common_area(distance[i], fleet.setup[i].radius, reach);
    }
    densest = std::max(densest, covered / (kPi * reach * reach));
  }
  return densest;
}

}  // namespace avo::safety
