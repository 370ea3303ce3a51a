// SPDX-License-Identifier: Apache-2.0
// Separating lines of stopping capsules.
#include "certificate/stopping_capsules.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace avo::inline certificate {
namespace {

// The vector that is nearer to the origin, or the middle of two equally near ones, which only
// rounding tells apart. The result is the same for either order, negated if both are, and turned by
// 90 degrees if both are.
Vec2 nearer_of(Vec2 a, Vec2 b) {
  const double of_a = norm_squared(a), of_b = norm_squared(b);
  if (of_a != of_b) return of_a < of_b ? a : b;
  return 0.5 * (a + b);
}

// The line of largest margin between two segments, as its normal from B's to A's. It is the
// direction of the point of their difference, a parallelogram, that is nearest to the origin. It is
// unique even where the segments are parallel. It is odd in the exchange of A and B, bit for bit.
// Each edge runs from the places of the robots to where they stop; the edges that change places are
// compared with each other.
Vec2 separating_normal(const std::array<Vec2, 4>& corners) {
  const auto edge = [&](std::size_t from, std::size_t to) {
    return nearest_on_segment(corners[from], corners[to]);
  };
  const Vec2 nearest =
      nearer_of(nearer_of(edge(0, 1), edge(0, 3)), nearer_of(edge(3, 2), edge(1, 2)));
  const double length = norm(nearest);
  return length > 0.0 ? nearest / length : Vec2{};
}

}  // namespace

void collect_capsules(const Robot& robot, const Neighbors& neighbors, const StepLaw& law,
                      std::vector<CapsuleConstraint>& constraints, Invariant& invariant) {
  const Braking a = braking_of(robot.velocity, ability_of(robot), law);
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor neighbor = neighbors[k];
    if (neighbor.behavior != Behavior::decides || neighbor.loiter) continue;
    const BrakingPair pair = braking_pair(robot, neighbor, a, law);
    if (cannot_meet(pair, neighbor, law)) continue;
    const Vec2 s_A = pair.a.length * pair.a.direction, s_B = pair.b.length * pair.b.direction;
    const std::array<Vec2, 4> corners{pair.p, pair.p + s_A, pair.p + (s_A - s_B), pair.p - s_B};
    const Vec2 n = separating_normal(corners);
    double distance = dot(n, corners[0]);
    for (const Vec2 corner : corners) distance = std::min(distance, dot(n, corner));
    const double held = held_distance(pair, distance, static_cast<int>(k), invariant);
    if (n == Vec2{}) continue;  // they coincide: there is no direction, and nothing to lose
    // A's capsule begins at n . x = min(0, n . s_A), and may use its share of the gap
    const double begin = std::min(0.0, dot(n, s_A));
    constraints.push_back({static_cast<int>(k), n, begin - pair.share * (distance - held), begin});
  }
}

bool keeps_capsules(std::span<const CapsuleConstraint> constraints, const CandidatePath& path,
                    const StepLaw& law) {
  if (constraints.empty()) return true;
  const double length = stopping_length(path.braking, law);
  const Vec2 end = path.first + length * path.direction;
  return std::all_of(
      constraints.begin(), constraints.end(), [&](const CapsuleConstraint& constraint) {
        return dot(constraint.normal, path.first) - path.bend >= constraint.offset &&
               dot(constraint.normal, end) >= constraint.offset &&
               (path.swing == Vec2{} ||
                constraint.begin + dot(constraint.normal, path.swing) >= constraint.offset);
      });
}

void append_half_planes(std::span<const CapsuleConstraint> constraints, const Robot& robot,
                        const StepLaw& law, double top_speed, std::vector<HalfPlane>& half_planes) {
  const double decrement = decrement_of(robot, law);
  const double lead = law.time_step - law.lag;
  // l(S)/S, nondecreasing: a slower robot stops earlier than the half-plane assumes
  const double stopping_time =
      top_speed > 0.0 ? stopping_length(top_speed, decrement, law) / top_speed : law.lag;
  for (const CapsuleConstraint& constraint : constraints) {
    if (constraint.normal == Vec2{}) continue;  // the centers are equal: there is no direction
    // n . (s v + (Δt - s) v_1 + l(S)/S v_1) >= offset, exact for |v_1| = S
    const double start = law.lag * dot(constraint.normal, robot.velocity);
    const double rest = constraint.offset - start;
    half_planes.push_back({constraint.normal, rest / (lead + (rest <= 0.0 ? stopping_time : 0.0))});
  }
}

}  // namespace avo::inline certificate
