// SPDX-License-Identifier: Apache-2.0
// The path of a disc with a heading over one step, as cubics through points on it.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "avo/check.h"
#include "check/arc.h"

namespace avo::judge {

struct DiscCourse {
  std::vector<CourseKnot> knots;  // at equal distances in time, 2^k + 1 of them
  double error = 0.0;             // m, of the cubics between them
};

/// m, from its position forward to the center of a disc, see CheckedRobot::discs.
double ahead_of(const CheckedRobot& robot, std::size_t disc = 0);
/// The number of its discs.
inline std::size_t disc_count(const CheckedRobot& robot) {
  return robot.discs.empty() ? 1 : robot.discs.size();
}
/// The place of a disc in a row.
Vec2 center_of(const CheckedRobot& robot, const CheckedState& row, std::size_t disc = 0);
/// Returns whether rows must have headings.
bool needs_heading(const CheckedRobot& robot);
/// Returns whether it is judged by its headings over this step.
inline bool has_heading(const CheckedRobot& robot, const CheckedState& before,
                        const CheckedState& now) {
  return !is_holonomic(robot.kinematics) && before.heading && now.heading;
}

/// None where it has no heading, or no possible motion from row to row: the cubic is used then.
std::optional<DiscCourse> course_of(const CheckedRobot& robot, std::size_t disc,
                                    const CheckedState& before, const CheckedState& now,
                                    double duration);

}  // namespace avo::judge
