// SPDX-License-Identifier: Apache-2.0
// The path of a disc with a heading over one step, as cubics through points on it.
#include "check/course.h"

#include <cstddef>

#include "check/towed_axle.h"
#include "core/elementary.h"

namespace avo::judge {
namespace {

constexpr double kFineEnough = 1e-10;  // m
constexpr std::size_t kMostParts = TowedAxle::kParts;

// The number of parts that the cubics need, and their remaining error: a cubic through positions
// and velocities has an error of Δt⁴ |p''''|/384 at most.
struct Division {
  std::size_t parts = 1;
  double error = 0.0;  // m
};

Division division_of(double fourth, double duration) {
  Division division{1, duration * duration * duration * duration * fourth / 384.0};
  for (; division.error > kFineEnough && division.parts < kMostParts; division.error /= 16.0)
    division.parts *= 2;
  return division;
}

// Its end is the place in the row: the difference is added as a drift.
template <typename KnotAt>
DiscCourse course_through(const Division& division, Vec2 end, double duration,
                          const KnotAt& knot_at) {
  const Vec2 missing = end - knot_at(division.parts).position;
  DiscCourse course{{}, division.error};
  course.knots.reserve(division.parts + 1);
  for (std::size_t k = 0; k <= division.parts; ++k) {
    const double fraction = static_cast<double>(k) / static_cast<double>(division.parts);
    const CourseKnot knot = knot_at(k);
    course.knots.push_back(
        {knot.position + fraction * missing, knot.velocity + missing / duration});
  }
  course.knots.back().position = end;
  return course;
}

}  // namespace

double ahead_of(const CheckedRobot& robot, std::size_t disc) {
  if (!robot.discs.empty()) return robot.discs[disc];
  const auto* car = std::get_if<CheckedCar>(&robot.kinematics);
  return car != nullptr ? car->body_offset : 0.0;
}

bool needs_heading(const CheckedRobot& robot) {
  return std::holds_alternative<CheckedDrive>(robot.kinematics) || !robot.discs.empty() ||
         ahead_of(robot) != 0.0;
}

Vec2 center_of(const CheckedRobot& robot, const CheckedState& row, std::size_t disc) {
  const double ahead = ahead_of(robot, disc);
  if (ahead == 0.0 || !row.heading) return row.position;
  return row.position + ahead * elementary::direction(row.heading->angle);
}

std::optional<DiscCourse> course_of(const CheckedRobot& robot, std::size_t disc,
                                    const CheckedState& before, const CheckedState& now,
                                    double duration) {
  if (!has_heading(robot, before, now)) return std::nullopt;
  const Vec2 end = center_of(robot, now, disc);
  const double ahead = ahead_of(robot, disc);
  if (const auto* drive = std::get_if<CheckedDrive>(&robot.kinematics)) {
    const TowedAxle axle = towed_axle(before, now, drive->offset, duration);
    const Division division = division_of(fourth_derivative(axle, ahead), duration);
    return course_through(division, end, duration, [&](std::size_t k) {
      return knot_on(axle, ahead, k * (TowedAxle::kParts / division.parts));
    });
  }
  const Arc arc = arc_of(before, now, duration);
  if (changes_direction(arc)) return std::nullopt;
  const Division division = division_of(fourth_derivative(arc, ahead), duration);
  return course_through(division, end, duration, [&](std::size_t k) {
    return knot_on(arc, ahead, static_cast<double>(k) / static_cast<double>(division.parts));
  });
}

}  // namespace avo::judge
