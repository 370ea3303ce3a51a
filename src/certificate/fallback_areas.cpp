// SPDX-License-Identifier: Apache-2.0
#include "certificate/fallback_areas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "avo/half_plane.h"
#include "certificate/kernels.h"
#include "core/plane.h"
#include "walls/segment.h"

namespace avo::inline certificate {
namespace {

using Real = scalar::Pack<double>;

// rounding errors of a circle that is remembered, in steps of braking
constexpr double kLoitering = 4.0;

FallbackArea braking_area(Vec2 position, Vec2 velocity, double radius, const Ability& ability,
                          const StepLaw& law) {
  const Braking braking = braking_of(velocity, ability, law);
  return {position, braking.length * braking.direction, radius, braking.intervals};
}

FallbackArea loitering_area(const LoiterCircle& circle, double radius) {
  return {circle.center, {}, circle.radius + radius, kLoitering};
}

// The vector from B's to A's, odd in the exchange of the two, bit for bit. One of them is a point:
// the displacement of a or of b is 0.
Vec2 between(const FallbackArea& a, const FallbackArea& b) {
  const Vec2 p = a.start - b.start;
  return nearest_on_segment(p, p + (a.to_stop - b.to_stop));
}

// docs/certificate/rounding.md: a decision reduces the accumulated error by a share.
double margin_between(const FallbackArea& a, const FallbackArea& b, double share) {
  const double lengths = length_1(a.start) + length_1(b.start) + norm(a.to_stop) + norm(b.to_stop) +
                         a.radius + b.radius;
  return scalar::rounding_margin<Real>(lengths, std::max(a.intervals, b.intervals),
                                       std::min(share, 1.0 - share))
      .value;
}

struct Between {
  Vec2 normal;
  double gap, part;  // m
};

// A pair that overlaps keeps its present distance.
Between line_between(const FallbackArea& a, const FallbackArea& b, double share) {
  const Vec2 nearest = between(a, b);
  const double distance = norm(nearest), gap = distance - (a.radius + b.radius);
  const Vec2 normal = distance > 0.0 ? nearest / distance : Vec2{};
  return {normal, gap, gap >= 0.0 ? share * (gap - margin_between(a, b, share)) : 0.0};
}

double share_of(const Robot& robot, const Neighbor& neighbor) {
  return room_share(robot.max_acceleration, neighbor.max_acceleration, robot.priority,
                    neighbor.priority);
}

}  // namespace

FallbackArea fallback_area_of(const Robot& robot, const StepLaw& law) {
  if (robot.loiter) return loitering_area(*robot.loiter, robot.radius);
  return braking_area(robot.position, robot.velocity, robot.radius, ability_of(robot), law);
}

FallbackArea fallback_area_of(const Neighbor& neighbor, const StepLaw& law) {
  if (neighbor.loiter) return loitering_area(*neighbor.loiter, neighbor.radius);
  return braking_area(neighbor.position, neighbor.velocity, neighbor.radius, ability_of(neighbor),
                      law);
}

double gap_of(const FallbackArea& a, const FallbackArea& b) {
  return norm(between(a, b)) - (a.radius + b.radius);
}

void collect_loiterers(const Robot& robot, const Neighbors& neighbors, const StepLaw& law,
                       std::vector<LoiterLine>& lines, Invariant& invariant) {
  const FallbackArea own = fallback_area_of(robot, law);
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    if (!neighbor.loiter || neighbor.behavior != Behavior::decides) continue;
    const Between line =
        line_between(own, fallback_area_of(neighbor, law), share_of(robot, neighbor));
    invariant.slack = std::min(invariant.slack, line.gap);
    if (line.gap < 0.0)
      invariant.broken.take(static_cast<int>(k), -line.gap), invariant.doubtful = true;
    // A's fallback area begins at n . x = min(0, n . own.to_stop)
    const double begin = std::min(0.0, dot(line.normal, own.to_stop));
    lines.push_back({static_cast<int>(k), line.normal, begin - line.part, begin});
  }
}

bool keeps_loiterers(std::span<const LoiterLine> lines, const CandidatePath& path,
                     const StepLaw& law) {
  if (lines.empty()) return true;
  const double length = stopping_length(path.braking, law);
  const Vec2 end = path.first + length * path.direction;
  return std::all_of(lines.begin(), lines.end(), [&](const LoiterLine& line) {
    return dot(line.normal, path.first) - path.bend >= line.offset &&
           dot(line.normal, end) >= line.offset &&
           (path.swing == Vec2{} || line.begin + dot(line.normal, path.swing) >= line.offset);
  });
}

void append_half_planes(std::span<const LoiterLine> lines, const Robot& robot, const StepLaw& law,
                        double top_speed, std::vector<HalfPlane>& half_planes) {
  const double decrement = decrement_of(robot, law);
  const double lead = law.time_step - law.lag;
  // l(S)/S, nondecreasing: a slower robot stops earlier than the half-plane assumes
  const double stopping_time =
      top_speed > 0.0 ? stopping_length(top_speed, decrement, law) / top_speed : law.lag;
  for (const LoiterLine& line : lines) {
    if (line.normal == Vec2{}) continue;  // the centers are equal: there is no direction
    // n . (s v + (Δt - s) v_1 + l(S)/S v_1) >= offset, exact for |v_1| = S
    const double start = law.lag * dot(line.normal, robot.velocity);
    const double rest = line.offset - start;
    half_planes.push_back({line.normal, rest / (lead + (rest <= 0.0 ? stopping_time : 0.0))});
  }
}

double flight_margin(const Wall& wall, double radius, double circle) {
  const double places = std::max(length_1(wall.a), length_1(wall.b));
  return 0x1p-44 * (2.0 * places + 3.0 * (wall.radius + radius + 2.0 * circle));
}

void collect_flight(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                    const StepLaw& law, FlightConstraints& constraints) {
  const FallbackArea own = fallback_area_of(robot, law);
  constraints = {std::move(constraints.lines),
                 std::move(constraints.walls),
                 std::numeric_limits<double>::infinity(),
                 {},
                 {}};
  constraints.lines.clear(), constraints.walls.clear();
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    if (neighbor.behavior != Behavior::decides) continue;
    const Between line =
        line_between(own, fallback_area_of(neighbor, law), share_of(robot, neighbor));
    constraints.slack = std::min(constraints.slack, line.gap);
    constraints.broken.take(static_cast<int>(k), -line.gap);
    constraints.lines.push_back({static_cast<int>(k), line.normal, line.part});
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Wall& wall = walls[k];
    const double kept = robot.radius + wall.radius;
    const double away = distance(own.start, {wall.a, wall.b}) - robot.loiter->radius;
    constraints.broken_wall.take(static_cast<int>(k), kept - away);
    constraints.walls.push_back(
        {wall.a, wall.b, kept + flight_margin(wall, robot.radius, robot.loiter->radius)});
  }
}

bool keeps_flight(const FlightConstraints& constraints, const Robot& robot,
                  const FlightStep& step) {
  const LoiterCircle &now = *robot.loiter, &next = step.motion.next.circle;
  const bool circles_kept =
      std::all_of(constraints.lines.begin(), constraints.lines.end(), [&](const auto& line) {
        const Vec2 n = line.normal;
        return dot(n, next.center - now.center) - (next.radius - now.radius) >= -line.part;
      });
  if (!circles_kept) return false;
  const ArcEnd end = end_of(step.arc, step.chord);
  const bool lines_kept =
      std::all_of(constraints.lines.begin(), constraints.lines.end(), [&](const auto& line) {
        const Vec2 n = line.normal;
        return dot(n, step.arc.start - now.center) + now.radius + lowest(step.arc, end, n) >=
               -line.part;
      });
  if (!lines_kept) return false;
  const Segment chord{step.arc.start, step.motion.next.position};
  const double off = sagitta(step.arc);
  return std::all_of(constraints.walls.begin(), constraints.walls.end(), [&](const Wall& wall) {
    const Segment segment{wall.a, wall.b};
    return distance(next.center, segment) - next.radius >= wall.radius &&
           distance(chord, segment) - off >= wall.radius;
  });
}

}  // namespace avo::inline certificate
