// SPDX-License-Identifier: Apache-2.0
// The line that takes an overlapping pair apart.
#include "obstacles/contact.h"

#include <algorithm>

#include "obstacles/constants.h"
#include "obstacles/contact_kernel.h"

namespace avo {

RelativeHalfPlane separate(const Pair& pair, double reach, const Horizon& horizon) noexcept {
  using Real = scalar::Pack<double>;
  const double d = norm(pair.position);
  const bool equal_centers = !(d > kTiniest);
  const Vec2 along = equal_centers ? pair.velocity : pair.position;
  const double length = norm(along);
  if (!(length > kTiniest)) return {PairState::coincident, {}};
  const double per_length = 1.0 / length;
  const double depth = pair.radius - (equal_centers ? 0.0 : d);
  const double h =
      scalar::separating<Real>(depth, dot(along, pair.velocity) * per_length, reach, horizon).value;
  return {
      PairState::overlapping, {per_length * along, std::min(h, reach)}, std::max(0.0, h - reach)};
}

}  // namespace avo
