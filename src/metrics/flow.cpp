// SPDX-License-Identifier: Apache-2.0
#include "metrics/flow.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "avo/error.h"

namespace avo::inline metrics {
namespace {

// The point where a straight step crosses the line, as a fraction of the step. A center on the line
// counts as beyond it: no crossing counts twice.
std::optional<double> crossing(const MeasuringLine& line, Vec2 from, Vec2 to) {
  const Vec2 along = line.b - line.a;
  const double before = cross(along, from - line.a), after = cross(along, to - line.a);
  if ((before < 0.0) == (after < 0.0)) return std::nullopt;
  const double part = before / (before - after);
  const double place = dot(along, from + part * (to - from) - line.a);  // times the length
  if (place < 0.0 || place > norm_squared(along)) return std::nullopt;
  return part;
}

}  // namespace

LineFlow::LineFlow(const MeasuringLine& line) : line_(line) {
  if (!is_finite(line.a) || !is_finite(line.b))
    throw Error("line: found an end that is not finite, must be two points");
  if (!(norm_squared(line.b - line.a) > 0.0))
    throw Error("line: found one point, must be two points");
}

void LineFlow::observe(std::span<const Body> robots, double begin, double duration) {
  for (const Body& robot : robots) {
    const auto part = crossing(line_, robot.path.control[0], robot.path.control[3]);
    if (part && crossed_.insert(robot.name).second) times_.push_back(begin + *part * duration);
  }
}

void LineFlow::describe(RunMetrics& metrics) const {
  std::vector<double> times = times_;
  std::sort(times.begin(), times.end());
  if (times.size() >= 2 && times.back() > times.front()) {
    // the inverse of the mean time between two robots
    metrics.flow = static_cast<double>(times.size() - 1) / (times.back() - times.front());
    metrics.specific_flow = *metrics.flow / norm(line_.b - line_.a);
  }
  metrics.crossing_times = std::move(times);
}

}  // namespace avo::inline metrics
