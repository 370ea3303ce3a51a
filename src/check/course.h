// SPDX-License-Identifier: Apache-2.0
// The way of a disc with a heading over one step, as cubics through places on it.
#pragma once
#include <optional>
#include <vector>

#include "avo/check.h"
#include "check/arc.h"

namespace avo::judge {

struct Course {
  std::vector<Knot> knots;  // at equal distances in time, 2^k + 1 of them
  double error = 0.0;       // m, of the cubics between them
};

/// m, of the disc's center; the heading is that of the row.
double ahead_of(const CheckedKinematics& kinematics);
/// Where the disc is in a row.
Vec2 center_of(const CheckedRobot& robot, const CheckedState& row);
/// Whether rows have to have headings.
bool needs_heading(const CheckedKinematics& kinematics);
/// Whether it is judged by its headings over this step.
inline bool has_heading(const CheckedRobot& robot, const CheckedState& before,
                        const CheckedState& now) {
  return !is_holonomic(robot.kinematics) && before.heading && now.heading;
}

/// None where it has no heading, or none that it could have from row to row: then the cubic is
/// taken.
std::optional<Course> course_of(const CheckedRobot& robot, const CheckedState& before,
                                const CheckedState& now, double duration);

}  // namespace avo::judge
