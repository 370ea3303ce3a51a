// SPDX-License-Identifier: Apache-2.0
// How near a body comes to a segment over one step, and when: its least distances from both ends
// and, where it is beside the segment, from the segment's line.
#pragma once
#include <optional>

#include "check/relative_path.h"

namespace avo::judge {

/// A body seen from one end of a segment over a step.
struct WallPath {
  RelativePath from_start;  // m
  Vec2 segment;             // from that end to the other one, m; zero: a point
};

/// Where it is nearest, the first such instant: to 1e-13 of its largest distance from an end.
Instant nearest_instant(const WallPath& path);

/// Where it is at that fraction of the step, to the same.
double distance_at(const WallPath& path, double fraction);

/// First fraction of the step at which the distance is less than `limit` >= 0; none where it never
/// is.
std::optional<double> first_below(const WallPath& path, double limit);

/// No point of the path is nearer than this; cheap, and far from sharp.
double lower_bound(const WallPath& path);

}  // namespace avo::judge
