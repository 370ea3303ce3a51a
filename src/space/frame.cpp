// SPDX-License-Identifier: Apache-2.0
#include "space/frame.h"

#include "space/half_space_kernel.h"

namespace avo::space {

PairFrame frame_of(Vec3 p, Vec3 v) {
  using Single = scalar::Pack<double>;
  const scalar::PackFrame<Single> frame =
      scalar::frame_of(scalar::constant<Single>(p), scalar::constant<Single>(v));
  return {frame.distance.value, scalar::plain(frame.along), scalar::plain(frame.across),
          scalar::plain(frame.velocity)};
}

}  // namespace avo::space
