// SPDX-License-Identifier: Apache-2.0
// Refuses values that no run records, before any code uses them.
#include "io/recording/block_checks.h"

#include <cmath>
#include <fmt/format.h>

#include "avo/planner.h"
#include "avo_io/errors.h"
#include "core/ranges.h"

namespace avo_io {

void BlockChecks::check(const BlockShape& shape, const RecordingBlock& block) {
  for (std::size_t k = 0; k < block.times; ++k) {
    check_time(block.time[k]);
    for (std::size_t i = 0; i < shape.robots; ++i) check_robot(shape, block, k, i);
  }
}

// Checks the time. With a free clock times are irregular, but they also ascend and end with the
// scene.
void BlockChecks::check_time(double time) {
  constexpr double kRounding = 1e-9;  // of k Δt, which may exceed the duration by its last bits
  const auto refuse_time = [&](const std::string& allowed) {
    throw RecordingError(fmt::format("{}: time: found {} s, must be {}", path_, time, allowed));
  };
  if (!std::isfinite(time)) refuse_time("a finite number");
  if (time < 0.0) refuse_time(">= 0 s");
  if (!(time > last_)) refuse_time(fmt::format("> {} s, the time before", last_));
  if (time > avo::kLargest) refuse_time(fmt::format("<= {:g} s", avo::kLargest));
  if (time > end_ * (1.0 + kRounding))
    refuse_time(fmt::format("<= {} s, the duration of its scene", end_));
  last_ = time;
}

void BlockChecks::refuse(double time, std::size_t robot, const char* column, double value) const {
  throw RecordingError(fmt::format(
      "{}: time {} s, robot {}: {}: found {}, must be {}", path_, time, robot, column, value,
      std::isfinite(value) ? fmt::format("from -{0:g} to {0:g}", avo::kLargest)
                           : std::string("a finite number")));
}

// Checks a robot's row: an absent robot has no numbers, and a robot without headings has neither
// heading nor speed.
void BlockChecks::check_robot(const BlockShape& shape, const RecordingBlock& block, std::size_t k,
                              std::size_t robot) const {
  const std::uint8_t status = block.status[k * shape.robots + robot];
  if (status == kAbsent) return;
  if (status > static_cast<std::uint8_t>(avo::PlanStatus::detour))
    throw RecordingError(fmt::format(
        "{}: time {} s, robot {}: status: found {}, must be 0 to {}, "
        "or {}, absent",
        path_, block.time[k], robot, status, static_cast<int>(avo::PlanStatus::detour), kAbsent));
  const auto value = [&](std::size_t column) { return block.row(shape, column, k)[robot]; };
  const bool heading = shape.has_headings() && !(std::isnan(value(4)) && std::isnan(value(5)));
  const std::size_t columns =
      shape.has_headings() && !heading ? kPlainColumns.count : shape.columns();
  for (std::size_t c = 0; c < columns; ++c)
    if (!avo::kAnyValue.contains(value(c)))
      refuse(block.time[k], robot, shape.state->names[c], value(c));
}

}  // namespace avo_io
