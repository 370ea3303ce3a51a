// SPDX-License-Identifier: Apache-2.0
// How near a body comes to a segment over one step, and when. These are its least distances from
// both ends and, where it is beside the segment, from the segment's line.
#pragma once
#include <optional>

#include "check/relative_path.h"

namespace avo::judge {

/// A body relative to one end of a segment over a step.
struct WallPath {
  RelativePath from_start;  // m
  Vec2 segment;             // from that end to the other one, m; zero: a point
};

/// The first instant at which it is nearest: to 1e-13 of its largest distance from an end.
Instant nearest_instant(const WallPath& path);

/// The distance at that fraction of the step, with the same precision.
double distance_at(const WallPath& path, double fraction);

/// First fraction of the step at which the distance is less than `limit` >= 0; none where it never
/// is.
std::optional<double> first_below(const WallPath& path, double limit);

/// No point of the path is nearer than this; it takes little time, and is far from sharp.
double lower_bound(const WallPath& path);

}  // namespace avo::judge
