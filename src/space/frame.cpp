// SPDX-License-Identifier: Apache-2.0
#include "space/frame.h"

#include "space/half_space_kernel.h"

namespace avo::space {

PairFrame frame_of(Vec3 p, Vec3 v) {
  using One = scalar::Pack<double>;
  const scalar::PackFrame<One> frame =
      scalar::frame_of(scalar::constant<One>(p), scalar::constant<One>(v));
  return {frame.distance.value, scalar::plain(frame.along), scalar::plain(frame.across),
          scalar::plain(frame.velocity)};
}

}  // namespace avo::space
