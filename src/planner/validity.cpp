// SPDX-License-Identifier: Apache-2.0
// Valid inputs of a decision: numbers that are finite and in range, and robots that can do what the
// others expect of them. All of it is tested in release builds as well.
#include "planner/validity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/plane.h"
#include "core/ranges.h"
#include "planner/methods/flight.h"
#include "planner/stages/certify.h"
#include "robots/ahead.h"
#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

// 1 or 0, to be joined without a branch: nearly all values are valid.
int is_known(double value) {
  return static_cast<int>(std::abs(value) <= kLargest);
}
int is_known(Vec2 value) {
  return is_known(value.x) & is_known(value.y);
}
int is_size(double value) {
  return static_cast<int>(value >= kSmallest) & static_cast<int>(value <= kLargest);
}

}  // namespace

bool has_known_place(const Robot& robot) {
  return is_known(robot.position) != 0;
}

bool can_brake(const Robot& robot) {
  const int velocity = is_known(robot.velocity);
  const int braking = robot.max_braking ? is_size(*robot.max_braking) : 1;
  return (velocity & is_size(robot.max_acceleration) & is_size(robot.max_speed) & braking) != 0;
}

namespace {

// The disc of the radius must cover a footprint, up to the rounding of a float.
bool covers(double radius, const Footprint& footprint) {
  constexpr double kOfFloats = 1e-6;
  return !footprint || radius >= (1.0 - kOfFloats) * bounding_radius(footprint);
}

}  // namespace

bool can_drive(const Robot& robot) {
  return is_known(robot.heading) != 0 &&
         is_valid(robot.model, change_limit(robot), robot.max_speed) &&
         covers(robot.radius, footprint_of(robot.model));
}

bool is_valid(const Robot& robot) {
  const int places = is_known(robot.position) & is_known(robot.preferred_velocity);
  if (robot.loiter && (is_known(robot.loiter->center) & is_size(robot.loiter->radius)) == 0)
    return false;
  const int lengths = is_size(robot.radius) & is_size(robot.priority) &
                      static_cast<int>(robot.distance_to_goal >= 0.0) &
                      static_cast<int>(robot.lookahead >= 0.0);
  return can_brake(robot) && (places & lengths) != 0 &&
         (is_holonomic(robot.model) || can_drive(robot));
}

bool follows_heading(const Robot& robot) {
  if (!moves_along_heading(robot.model) || is_rest(robot.velocity)) return true;
  const Vec2 v = robot.velocity, heading = ahead_of(robot.heading);
  const bool backwards = model_traits(robot.model).can_reverse && dot(v, heading) < 0.0;
  return norm_squared(v - norm(v) * (backwards ? -heading : heading)) <=
         kHeadingTolerance * kHeadingTolerance * norm_squared(v);
}

namespace {

bool is_deviation(double value) {
  return value >= 0.0 && value <= kLargest;
}

// Tests a predicted neighbor. is_valid() tests for all neighbors the values that nearly all of them
// have.
bool is_valid_mover(const Neighbor& mover) {
  if (mover.behavior == Behavior::parked)
    return mover.velocity == Vec2{} && mover.acceleration == Vec2{} && mover.max_deviation == 0.0 &&
           mover.likely_deviation == 0.0 && mover.trajectory == nullptr && !mover.loiter;
  const bool is_placed = mover.trajectory == nullptr || (!mover.trajectory->places().empty() &&
                                                         is_known(mover.trajectory_time) != 0);
  return is_deviation(mover.max_deviation) && is_deviation(mover.likely_deviation) &&
         mover.max_speed >= kSmallest && !mover.loiter && is_placed;
}

bool is_valid_loiterer(const Neighbor& neighbor) {
  const LoiterCircle& circle = *neighbor.loiter;
  return (is_known(circle.center) & is_size(circle.radius)) != 0 &&
         !has_errors_of_its_own(neighbor);
}

}  // namespace

namespace {

bool is_valid_footprint(const Neighbor& neighbor) {
  constexpr double kUnit = 1e-6;  // of a length: a direction is that near to a unit vector
  return is_valid(neighbor.footprint) && covers(neighbor.radius, neighbor.footprint) &&
         std::abs(norm_squared(neighbor.ahead) - 1.0) <= kUnit && neighbor.spread >= 0.0 &&
         neighbor.spread <= std::numbers::pi;
}

}  // namespace

bool is_valid(const Neighbor& neighbor) {
  const int dated = static_cast<int>(neighbor.age >= 0) &
                    static_cast<int>(neighbor.age <= kMostAge) &
                    static_cast<int>(is_deviation(neighbor.position_error));
  if ((is_known(neighbor.position) & is_known(neighbor.velocity) & is_known(neighbor.acceleration) &
       is_size(neighbor.radius) & dated) == 0)
    return false;
  if (is_predicted(neighbor) && !is_valid_mover(neighbor)) return false;
  if (!shares(neighbor)) return true;
  const double a_max = neighbor.max_acceleration;
  const int able = static_cast<int>(a_max > 0.0) & static_cast<int>(a_max <= kLargest) &
                   is_size(neighbor.priority) & is_known(neighbor.parting);
  if (able == 0) return false;
  if (neighbor.max_braking && is_size(*neighbor.max_braking) == 0) return false;
  if (neighbor.age > 0 && !is_deviation(neighbor.max_deviation)) return false;
  if (neighbor.footprint && !is_valid_footprint(neighbor)) return false;
  return !neighbor.loiter || is_valid_loiterer(neighbor);
}

bool is_valid(const Wall& wall) {
  const int places = is_known(wall.a) & is_known(wall.b);
  return (places & static_cast<int>(wall.radius >= 0.0) & is_known(wall.radius)) != 0;
}

bool all_valid(const Robot& robot, std::span<const Neighbor> neighbors) {
  return is_valid(robot) && std::all_of(neighbors.begin(), neighbors.end(),
                                        [](const Neighbor& n) { return is_valid(n); });
}

namespace {

// Tests a neighbor that decides and has only the common values; equal to is_valid().
bool is_valid_usual(const NeighborColumns& columns, std::size_t k) {
  const double a_max = columns.max_acceleration[k];
  const int places = is_known(columns.x[k]) & is_known(columns.y[k]);
  const int velocities = is_known(columns.v_x[k]) & is_known(columns.v_y[k]);
  const int limits = static_cast<int>(a_max > 0.0) & static_cast<int>(a_max <= kLargest);
  return (places & velocities & limits & is_size(columns.radius[k])) != 0;
}

}  // namespace

bool all_valid(const Robot& robot, const Neighbors& neighbors) {
  if (!is_valid(robot)) return false;
  const NeighborColumns& columns = *neighbors.columns;
  const bool have_more = columns.has_footprints || columns.has_priorities ||
                         columns.has_max_braking || columns.has_deviations || columns.has_partings;
  for (std::size_t k = neighbors.first; k < neighbors.first + neighbors.count; ++k) {
    const bool is_usual = !have_more && columns.kind(k) == NeighborKind::prompt;
    if (!(is_usual ? is_valid_usual(columns, k) : is_valid(columns[k]))) return false;
  }
  return true;
}

namespace {

// A robot that flies counts on what it senses of a robot, and it evades a mover with any errors.
bool may_fly_beside(const Neighbor& neighbor) {
  if (!shares(neighbor)) return true;
  return neighbor.behavior == Behavior::decides && !has_errors_of_its_own(neighbor);
}

template <typename Neighbors>
bool can_follow_among(const Robot& robot, const Neighbors& neighbors,
                      const PlannerOptions& options) {
  const bool flies = !can_rest(robot.model);
  bool loiters = flies;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor& neighbor = neighbors[k];
    if (flies && !may_fly_beside(neighbor)) return false;
    if (!neighbor.loiter) continue;
    loiters = true;
    if (!is_on_circle(neighbor)) return false;
  }
  if (flies && !can_fly(robot, options.time_step)) return false;
  if (loiters && !allows_loiterers(options)) return false;
  return is_holonomic(robot.model) || options.certificate == Certificate::none ||
         options.motion == Motion::held;
}

}  // namespace

namespace {

// Robots with clocks of their own are sensed within their steps, where the turn of discs is
// unknown.
bool allows_footprints(const PlannerOptions& options) {
  return options.clock == Clock::common || options.certificate == Certificate::none;
}

}  // namespace

bool can_follow(const Robot& robot, const Neighbors& neighbors, const PlannerOptions& options) {
  if ((neighbors.columns->has_footprints || has_footprint(robot.model)) &&
      !allows_footprints(options))
    return false;
  if (can_rest(robot.model) && !neighbors.columns->has_loiterers)  // nearly always
    return can_follow_among(robot, std::span<const Neighbor>{}, options);
  return can_follow_among(robot, neighbors, options);
}
bool can_follow(const Robot& robot, std::span<const Neighbor> neighbors,
                const PlannerOptions& options) {
  const bool are_covered = has_footprint(robot.model) ||
                           std::any_of(neighbors.begin(), neighbors.end(),
                                       [](const Neighbor& n) { return bool{n.footprint}; });
  if (are_covered && !allows_footprints(options)) return false;
  return can_follow_among(robot, neighbors, options);
}

bool can_decide(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, const PlannerOptions& options) {
  return all_valid(robot, neighbors) &&
         std::all_of(walls.begin(), walls.end(), [](const Wall& wall) { return is_valid(wall); }) &&
         follows_heading(robot) && can_follow(robot, neighbors, options);
}

}  // namespace avo::inline planner
