// SPDX-License-Identifier: Apache-2.0
// Robots that decide by their own clocks: whether they hold what they have decided.
#pragma once
#include <optional>

#include "avo/check.h"

namespace avo::judge {

struct TimedState {
  CheckedState row;
  double time = 0.0;  // s
};

/// Two consecutive rows.
struct RowPair {
  TimedState from, to;
  double tolerance = 0.0;  // relative
};

/// What is known of one robot's clock.
struct JudgedClock {
  std::optional<double> phase = {};       // s, of its first change
  std::optional<TimedState> before = {};  // the row before the last one
};

/// m/s²: the change of its acceleration at the start of the passage, if that is none of its times.
std::optional<double> early_change(const CheckedRobot& robot, const RowPair& passage,
                                   JudgedClock& clock);

}  // namespace avo::judge
