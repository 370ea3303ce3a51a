// SPDX-License-Identifier: Apache-2.0
// Counts broken rules.
#pragma once
#include <algorithm>
#include <tuple>

#include "avo/check.h"

namespace avo::judge {

/// Keeps the earliest violation, then that of the lowest robot, for any order within a step.
inline void note(CheckCount& rule, const CheckViolation& violation) {
  rule.worst = std::max(rule.worst, violation.amount);
  const auto place = [](const CheckViolation& v) {
    return std::tuple(v.time, v.robot, v.other.value_or(-1));
  };
  if (!rule.first || place(violation) < place(*rule.first)) rule.first = violation;
}

/// Adds one to the count.
inline void count(CheckCount& rule, const CheckViolation& violation) {
  ++rule.count;
  note(rule, violation);
}

}  // namespace avo::judge
