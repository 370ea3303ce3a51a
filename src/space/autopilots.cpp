// SPDX-License-Identifier: Apache-2.0
#include "avo/space/autopilots.h"

#include <cmath>
#include <string>

#include "core/ranges.h"

namespace avo::space {
namespace {

constexpr Range kInPacket{-32.767, 32.767, false};  // m, m/s, m/s²

std::array<float, 3> floats(const char* name, const Vec3& vector, const Range& range,
                            const char* unit) {
  const std::string of = name;
  require(of + ".0", vector.x, range, unit);
  require(of + ".1", vector.y, range, unit);
  require(of + ".2", vector.z, range, unit);
  return {static_cast<float>(vector.x), static_cast<float>(vector.y), static_cast<float>(vector.z)};
}

std::array<float, 3> north_east_down(const char* name, const Vec3& vector, const char* unit) {
  const auto [east, north, up] = floats(name, vector, kAnyValue, unit);
  return {north, east, -up};
}

}  // namespace

Px4SetPoint px4_set_point(const SetPoint& point, double time) {
  require("time", time, kNotNegative, "s");
  Px4SetPoint result;
  result.timestamp = static_cast<std::uint64_t>(std::llround(time * 1e6));
  result.position = north_east_down("position", point.position, "m");
  result.velocity = north_east_down("velocity", point.velocity, "m/s");
  result.acceleration = north_east_down("acceleration", point.acceleration, "m/s^2");
  return result;
}

CrazyflieSetPoint crazyflie_set_point(const SetPoint& point) {
  CrazyflieSetPoint result;
  result.position = floats("position", point.position, kInPacket, "m");
  result.velocity = floats("velocity", point.velocity, kInPacket, "m/s");
  result.acceleration = floats("acceleration", point.acceleration, kInPacket, "m/s^2");
  return result;
}

}  // namespace avo::space
