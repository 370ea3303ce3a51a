// SPDX-License-Identifier: Apache-2.0
// Distance of two bodies, and of a body and a wall, in continuous time over one step: by the
// judge's paths of bodies.
#pragma once
#include <optional>

#include "avo/response.h"
#include "avo/vec.h"
#include "check/relative_path.h"
#include "walls/segment.h"

namespace avo::inline metrics {

/// A path over one step as a cubic Bézier curve, m. It is exact for held accelerations and for
/// straight lines. For anything else it is the Hermite interpolation of both ends' positions and
/// velocities.
using StepPath = judge::RelativePath;

StepPath hermite_path(Vec2 position, Vec2 velocity, Vec2 next_position, Vec2 next_velocity,
                      double time_step);

/// A path over one step by Eqs. (8), (9): p + t v + g(t) w.
struct ResponsePath {
  Vec2 position, velocity, w;  // m, m/s
  Response response;
  double time_step;  // s
};

/// The path of a disc over one step that turns with its robot: an arc of a circle.
struct ArcPath {
  Vec2 position;         // m
  double heading, turn;  // rad, of its tangent at the start
  double length;         // m
};

/// The motion of a disc along the arc, for a robot with those speeds along its heading that changes
/// its speed evenly; m/s, not both 0. Only their ratio matters.
struct ArcMotion {
  ArcPath path;
  double speed, next_speed;
};

/// The arc from one place to the next one, turning by less than half a turn.
ArcPath arc_path(Vec2 position, Vec2 next_position, double turn);
/// The arc as a cubic; its error in a part of the step is proportional to the fourth power of that
/// part.
StepPath hermite_path(const ArcMotion& arc, double time_step);

/// The same motion within a part of the step, as a path of that part alone; 0 <= from < to <= 1.
StepPath part_of(const StepPath& path, double from, double to);
ArcMotion part_of(const ArcMotion& arc, double from, double to);

/// The smallest distance of the two bodies, and when: to 1e-13 of the largest one. If it is beyond
/// `cutoff`, any distance beyond the cutoff may be returned.
judge::Instant separation(const StepPath& a, const StepPath& b, double cutoff);

/// m, the smallest distance from the segment, with the same precision and cutoff.
double separation(const StepPath& path, const Segment& segment, double cutoff);
double separation(const ResponsePath& path, const Segment& segment);
/// Its error is at most 1e-10 of the arc's radius.
double separation(const ArcPath& path, const Segment& segment, double cutoff);

/// The first fraction of the step at which the distance is less than `distance`; none where it
/// never is.
std::optional<double> first_below(const StepPath& a, const StepPath& b, double distance);

}  // namespace avo::inline metrics
