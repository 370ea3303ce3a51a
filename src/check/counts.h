// SPDX-License-Identifier: Apache-2.0
// Counts broken rules.
#pragma once
#include <algorithm>
#include <tuple>
#include <vector>

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

/// Returns the hits by time, robot and other robot: the order of a table has no influence.
template <typename Hits>
std::vector<CheckedHit> listed(const Hits& hits) {
  std::vector<CheckedHit> list;
  list.reserve(hits.size());
  for (const auto& [pair, hit] : hits) list.push_back(hit);
  std::sort(list.begin(), list.end(), [](const CheckedHit& a, const CheckedHit& b) {
    return std::tie(a.time, a.robot, a.other) < std::tie(b.time, b.robot, b.other);
  });
  return list;
}

/// Adds one to the count.
inline void count(CheckCount& rule, const CheckViolation& violation) {
  ++rule.count;
  note(rule, violation);
}

}  // namespace avo::judge
