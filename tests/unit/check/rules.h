// SPDX-License-Identifier: Apache-2.0
// Which rules of robots with headings a step breaks.
#pragma once
#include <cstdint>
#include <vector>

#include "unit/check/headings.h"

namespace avo::test {

inline constexpr double kStep = 0.1;                                     // s
inline constexpr double kWithin = 1.0 + 0.9e-9, kBeyond = 1.0 + 1.2e-9;  // of a limit

inline CheckReport step_of(const CheckedRobot& robot, const CheckedState& from,
                           const CheckedState& to) {
  return report_of({robot}, {{0.0, {from}}, {kStep, {to}}});
}

inline CheckReport held(const CheckedRobot& robot, const CheckedState& from, const Held& controls) {
  return step_of(robot, from, driven(from, controls, kStep));
}

/// All counts; in the order in which they are declared.
inline std::vector<std::int64_t> counts(const CheckReport& report) {
  return {report.accelerations.count, report.speeds.count,
          report.jumps.count,         report.headings.count,
          report.turns.count,         report.lateral_accelerations.count,
          report.reversals.count,     report.slow_flights.count,
          report.wheel_speeds.count,  report.wheel_accelerations.count};
}

inline std::vector<std::int64_t> only(std::size_t rule, std::int64_t count = 1) {
  std::vector<std::int64_t> expected(10);
  expected[rule] = count;
  return expected;
}
enum Rule : std::size_t {
  acceleration,
  speed,
  jump,
  heading,
  turn,
  lateral,
  reversal,
  slow,
  wheel_speed,
  wheel_acceleration
};
inline const std::vector<std::int64_t> kNone(10);

}  // namespace avo::test
