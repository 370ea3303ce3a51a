// SPDX-License-Identifier: Apache-2.0
// Set points of quadrotors for PX4 and the Crazyflie.
#include <algorithm>
#include <array>
#include <cstddef>

#include "avo/space/autopilots.h"
#include "convert.h"
#include "space_convert.h"

namespace avo_c {
namespace {

avo::space::SetPoint point_from_c(const avo_set_point& point) {
  return {from_c(point.position), from_c(point.velocity), from_c(point.acceleration)};
}

template <std::size_t Size>
void copy(const std::array<float, Size>& from, float (&to)[Size]) {
  std::copy(from.begin(), from.end(), to);
}

template <typename From, typename To>
void copy_motion(const From& from, To& to) {
  copy(from.position, to.position);
  copy(from.velocity, to.velocity);
  copy(from.acceleration, to.acceleration);
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_get_px4_set_point(avo_set_point set_point, double time, avo_px4_set_point* result) {
  return guarded([&] {
    avo_px4_set_point& to = at(result, "result");
    const avo::space::Px4SetPoint found = px4_set_point(point_from_c(set_point), time);
    to.timestamp = found.timestamp;
    copy_motion(found, to);
    copy(found.jerk, to.jerk);
    to.yaw = found.yaw, to.yawspeed = found.yawspeed;
  });
}

avo_result avo_get_crazyflie_set_point(avo_set_point set_point, avo_crazyflie_set_point* result) {
  return guarded([&] {
    avo_crazyflie_set_point& to = at(result, "result");
    const avo::space::CrazyflieSetPoint found = crazyflie_set_point(point_from_c(set_point));
    copy_motion(found, to);
    copy(found.orientation, to.orientation);
    to.roll_rate = found.roll_rate, to.pitch_rate = found.pitch_rate, to.yaw_rate = found.yaw_rate;
  });
}
