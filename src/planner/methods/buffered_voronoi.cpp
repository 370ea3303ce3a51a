// SPDX-License-Identifier: Apache-2.0
#include "planner/methods/buffered_voronoi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "certificate/pair.h"
#include "lp/linear_program.h"
#include "planner/decision.h"
#include "planner/scratch.h"
#include "planner/stages/demands.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/pairs.h"

namespace avo::inline planner {
namespace {

// of the radius: nearer to the point of its cell the robot is stuck there
constexpr double kStuck = 0.1;
constexpr double kOnSide = 1e-6;  // of the radius: rounding of a point on a side

// n . v of the frame in which the side is at rest.
double side_velocity(const CellSide& side, const Neighbor& neighbor) {
  return shares(neighbor) ? 0.0 : dot(side.normal, neighbor.velocity);
}

// m from the robot: the point of the cell nearest to `goal`. Half-planes are relative to p_A.
Vec2 nearest_in_cell(std::span<const HalfPlane> sides, Vec2 goal, ProgramRows& rows) {
  const Disc everywhere{{}, std::numeric_limits<double>::infinity()};
  return nearest_point(sides, everywhere, 2.0 * norm(goal), goal, rows).point;
}

// The right-hand rule: the direction along the side that `place` lies on and that blocks the robot
// most.
Vec2 to_the_right(std::span<const HalfPlane> sides, Vec2 place, Vec2 goal, double radius,
                  ProgramRows& rows) {
  Vec2 inward{};
  double most = 0.0;  // m
  for (const HalfPlane& side : sides) {
    const double along = -dot(side.normal, goal);
    const bool is_on = dot(side.normal, place) - side.offset <= kOnSide * radius;
    if (is_on && along > most) most = along, inward = side.normal;
  }
  return nearest_in_cell(sides, norm(goal) * perpendicular(inward), rows);
}

// The cell's sides, of the neighbors that count.
void collect_sides(const PlannerOptions& options, const Robot& robot, const Neighbors& neighbors,
                   std::vector<HalfPlane>& sides) {
  sides.clear();
  const std::size_t count = planned_with(options, neighbors);
  for (std::size_t k = 0; k < count; ++k) {
    const CellSide side = cell_side(options, robot, neighbors[k]);
    if (side.normal != Vec2{}) sides.push_back({-side.normal, -side.gap});
  }
}

Vec2 wish_within_cell(const PlannerOptions& options, const Robot& robot,
                      std::span<const HalfPlane> sides, ProgramRows& rows) {
  const Vec2 preferred = robot.preferred_velocity;
  const double speed = norm(preferred);
  if (!(speed > 0.0) || !(robot.distance_to_goal > 0.0)) return preferred;
  const double distance = std::min(robot.distance_to_goal, speed * options.time_horizon);
  const Vec2 goal = (distance / speed) * preferred;
  Vec2 place = nearest_in_cell(sides, goal, rows);
  if (place == goal) return preferred;
  if (norm(place) < kStuck * robot.radius && distance > robot.radius)
    place = to_the_right(sides, place, goal, robot.radius, rows);
  const double left = norm(place);
  if (!(left > 0.0)) return {};
  const Vec2 along = place / left;
  const double most =
      speed_within(left, dot(along, robot.velocity), planned_braking(robot), options.time_step);
  return std::clamp(most, 0.0, speed) * along;
}

// n . v' <= speed_within() of one side; for a mover relative to its velocity.
HalfPlane half_plane_of(const PlannerOptions& options, const CellSide& side, const Robot& robot,
                        const Neighbor& neighbor) {
  const double others = side_velocity(side, neighbor);
  const double most = speed_within(side.gap, dot(side.normal, robot.velocity) - others,
                                   planned_braking(robot), options.time_step);
  return {-side.normal, -(others + most)};
}

// Collects the half-planes of robot i, and marks its contacts.
void collect_cell(const PlannerOptions& options, const StepLaw& law, const RobotColumns& robots,
                  std::size_t i, SoftPlanes& soft) {
  const Robot robot = robots.robot(i);
  const Discs discs = discs_of(robot, law);
  const std::size_t count = planned_with(options, robots.neighbors[i]);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [disc, neighbor, gap] = nearest_discs(discs, robots.neighbors[i][k]);
    const Pair pair = relative(disc, neighbor);
    const double distance = norm(pair.position);
    if (distance < pair.radius) soft.overlapping[i] = 1;
    if (shares(neighbor) && nearly_coincide(distance, pair.radius)) soft.coinciding[i] = 1;
    const CellSide side = cell_side(options, disc, neighbor);
    if (side.normal == Vec2{}) continue;
    grow(soft.shared.kept, soft.planes.size() + 1);
    soft.shared.kept[soft.planes.size()] = static_cast<double>(k);
    soft.planes.push_back(half_plane_of(options, side, disc, neighbor));
    soft.excess.push_back(0.0);
  }
}

}  // namespace

CellSide cell_side(const PlannerOptions& options, const Robot& robot, const Neighbor& neighbor) {
  const Pair pair = relative(robot, neighbor);
  const double distance = norm(pair.position);
  const double part = shares(neighbor) ? 0.5 : 1.0;
  if (part < 1.0 && neighbor.parting != Vec2{})
    return {-(neighbor.parting / norm(neighbor.parting)), -part * pair.radius};
  if (!(distance > 0.0)) return {};
  return {-(pair.position / distance),
          part * (distance - reserved_radius(pair, reserve_of(options)))};
}

double speed_within(double gap, double speed, double max_braking, double time_step) {
  // Δt (speed + V)/2 + l(V) <= gap, where l(V) = Δt (V/2 + (V - u) + (V - 2 u) + ...) is the
  // braking distance from V. Δt V/2 + l(V) is the distance that speed_before() uses for a law
  // without lag.
  const double room = gap - 0.5 * time_step * speed;
  if (!(room > 0.0)) return 2.0 * room / time_step;
  const StepLaw law{.time_step = time_step, .lag = 0.0, .braking_time = time_step};
  return speed_before(room, max_braking, law);
}

void collect_cells(const PlannerOptions& options, const StepLaw& law, const Tile& tile,
                   SoftPlanes& soft) {
  clear(tile.robots.count, soft);
  for (std::size_t i = 0; i < tile.robots.count; ++i) {
    collect_cell(options, law, tile.robots, i, soft);
    soft.first[i + 1] = soft.planes.size();
  }
}

void wish_within_cells(const PlannerOptions& options, const RobotColumns& robots,
                       PlanWorkspace::Scratch& scratch) {
  for (std::size_t i = 0; i < robots.count; ++i) {
    collect_sides(options, robots.robot(i), robots.neighbors[i], scratch.hard_and_soft);
    const Vec2 wish =
        wish_within_cell(options, robots.robot(i), scratch.hard_and_soft, scratch.rows);
    scratch.decisions.wish_x[i] = wish.x, scratch.decisions.wish_y[i] = wish.y;
  }
}

}  // namespace avo::inline planner
