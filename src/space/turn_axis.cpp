// SPDX-License-Identifier: Apache-2.0
#include "space/turn_axis.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "space/boxes.h"

namespace avo::space {
namespace {

constexpr double kSideBySide = 4.4;  // radii: the width in which two robots pass side by side

// The direction from a box to the robot, and how far away the box is, m.
struct Face {
  Vec3 normal;
  double away = 0.0;
};

std::optional<Face> face_of(const Robot& robot, const Box& box) {
  const NearestToBox at = nearest(robot.position, robot.position, box);
  const double away = at.distance - box.radius;
  if (!(at.distance > 0.0 && away < kSideBySide * robot.radius)) return std::nullopt;
  return Face{(at.on_segment - at.on_box) / at.distance, away};
}

// Returns whether the robot is between the two, and they leave no room for two robots side by side.
bool is_narrow_between(const Face& a, const Face& b, double radius) {
  constexpr double kOpposed = -0.99;  // a cosine
  return dot(a.normal, b.normal) < kOpposed && a.away + b.away < kSideBySide * radius;
}

// The normal of the slot in which the robot is; none in the open, and in a tube.
std::optional<Vec3> normal_of_slot(const Robot& robot, std::span<const Box> boxes) {
  constexpr double kSame = 0.1;  // the squared sine between normals of one slot
  std::array<Face, 8> faces;     // more are no slot
  std::size_t count = 0;
  std::optional<Vec3> found;
  for (const Box& box : boxes) {
    const std::optional<Face> face = face_of(robot, box);
    if (!face) continue;
    if (count == faces.size()) return std::nullopt;
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_narrow_between(*face, faces[k], robot.radius)) continue;
      if (found && norm_squared(cross(*found, face->normal)) > kSame) return std::nullopt;
      found = face->normal;
    }
    faces[count++] = *face;
  }
  return found;
}

// The same for all robots of a slot, whatever rounding makes of its normal.
bool is_positive(Vec3 normal) {
  constexpr double kNearZero = 1e-6;
  if (std::abs(normal.z) > 0.5) return normal.z > 0.0;
  return std::abs(normal.x) > kNearZero ? normal.x > 0.0 : normal.y > 0.0;
}

}  // namespace

Vec3 axis_across(Vec3 heading) {
  constexpr double kSteep = 0.1;  // the squared cosine of a course that is steep
  const double length = norm(heading);
  if (!(length > 0.0)) return {0.0, 0.0, 1.0};
  const Vec3 d = heading / length, up{0.0, 0.0, 1.0}, ahead{1.0, 0.0, 0.0};
  Vec3 axis = up - d.z * d;
  if (norm_squared(axis) < kSteep) axis = ahead - d.x * d;
  return axis / norm(axis);
}

Vec3 turn_axis(const Robot& robot, std::span<const Box> boxes) {
  constexpr double kAlong = 0.5;  // the cosine between the normal and a course that is not along
  const Vec3 usual = axis_across(robot.preferred_velocity);
  if (boxes.empty()) return usual;
  const std::optional<Vec3> normal = normal_of_slot(robot, boxes);
  if (!normal ||
      std::abs(dot(*normal, robot.preferred_velocity)) > kAlong * norm(robot.preferred_velocity))
    return usual;
  return is_positive(*normal) ? *normal : -*normal;
}

}  // namespace avo::space
