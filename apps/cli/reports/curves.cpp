// SPDX-License-Identifier: Apache-2.0
// A recorded run as curves over time, and as frames of figures.
#include "reports/curves.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace avo_cli {
namespace {

using avo::Vec2;

constexpr std::size_t kMostPoints = 1000;  // per curve

/// Returns the moments until no robot moves any more: a run may go on long after that.
std::span<const avo_io::RecordedMoment> in_motion(const avo_io::RecordedRun& run) {
  constexpr double kStill = 1e-3;  // m/s
  std::size_t end = run.moments.size();
  while (end > 0 && !(run.moments[end - 1].fastest > kStill)) --end;
  if (end == 0) return run.moments;
  return std::span(run.moments).first(std::min(end + 1, run.moments.size()));
}

/// Returns the lowest point of every n, at its own place.
std::vector<Vec2> lowest(const std::vector<Vec2>& points) {
  const std::size_t stride = points.size() / kMostPoints + 1;
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < points.size(); k += stride) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(k);
    const auto end =
        points.begin() + static_cast<std::ptrdiff_t>(std::min(k + stride, points.size()));
    kept.push_back(*std::min_element(begin, end, [](Vec2 a, Vec2 b) { return a.y < b.y; }));
  }
  return kept;
}

}  // namespace

std::vector<Vec2> thinned(const std::vector<Vec2>& points) {
  const std::size_t stride = points.size() / kMostPoints + 1;
  std::vector<Vec2> kept;
  for (std::size_t k = 0; k < points.size(); k += stride) kept.push_back(points[k]);
  if (!points.empty() && (points.size() - 1) % stride != 0) kept.push_back(points.back());
  return kept;
}

std::vector<Vec2> arrivals_of(const avo_io::RecordedRun& run) {
  std::vector<Vec2> points;
  for (const avo_io::RecordedMoment& moment : in_motion(run))
    points.push_back(
        {moment.time, 100.0 * static_cast<double>(moment.arrived) /
                          static_cast<double>(std::max<std::int64_t>(run.travelers, 1))});
  return thinned(points);
}

std::vector<Vec2> clearances_of(const avo_io::RecordedRun& run) {
  std::vector<Vec2> points;
  for (const avo_io::RecordedMoment& moment : in_motion(run))
    if (moment.clearance) points.push_back({moment.time, *moment.clearance});
  return lowest(points);
}

std::vector<Vec2> top_speeds_of(const avo_io::RecordedRun& run) {
  std::vector<Vec2> points;
  for (const avo_io::RecordedMoment& moment : in_motion(run))
    points.push_back({moment.time, moment.fastest});
  return thinned(points);
}

std::vector<avo::figures::TrajectoryFrame> frames_of(const avo_io::RecordedRun& run) {
  std::vector<avo::figures::TrajectoryFrame> frames;
  for (const avo_io::RecordedFrame& frame : run.frames)
    frames.push_back({frame.time, frame.position, frame.heading, frame.mover_position});
  return frames;
}

}  // namespace avo_cli
