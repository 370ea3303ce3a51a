// SPDX-License-Identifier: Apache-2.0
// How a broken rule is counted.
#pragma once
#include <algorithm>
#include <tuple>

#include "avo/check.h"

namespace avo::judge {

/// Keeps the earliest, then the lowest: whatever the order in which those of a step are met.
inline void note(CheckCount& rule, const CheckViolation& violation) {
  rule.worst = std::max(rule.worst, violation.amount);
  const auto place = [](const CheckViolation& v) {
    return std::tuple(v.time, v.robot, v.other.value_or(-1));
  };
  if (!rule.first || place(violation) < place(*rule.first)) rule.first = violation;
}

/// Once more.
inline void count(CheckCount& rule, const CheckViolation& violation) {
  ++rule.count;
  note(rule, violation);
}

}  // namespace avo::judge
