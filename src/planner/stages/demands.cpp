// SPDX-License-Identifier: Apache-2.0
// Speeds with which a robot can still stop before a wall, and obstacles of walls.
#include "planner/stages/demands.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate/wall_constraints.h"
#include "obstacles/wall_half_plane.h"
#include "planner/rules/out_of_walls.h"
#include "planner/stages/contact.h"
#include "planner/stages/disc_pairs.h"
#include "robots/footprint.h"
#include "robots/model.h"
#include "walls/segment.h"

namespace avo::inline planner {

// With k whole steps of u and a fraction f of one, V = (k + f) u and
// V Δt + l(V) = u [Δt k (k + 1)/2 + k s + f (Δt (k + 1) + s)]: a quadratic in k, linear in f.
double speed_before(double gap, double max_braking, const StepLaw& law) {
  if (!(gap > 0.0)) return 0.0;
  const double u = braking_decrement(max_braking, law), h = law.time_step, s = law.lag;
  const auto length_of = [&](double k) { return u * (0.5 * h * k * (k + 1.0) + k * s); };
  const double half = 0.5 * h + s;
  double steps = std::floor((std::sqrt(half * half + 2.0 * h * gap / u) - half) / h);
  if (length_of(steps) > gap) steps -= 1.0;  // rounding
  const double fraction = (gap - length_of(steps)) / (u * (h * (steps + 1.0) + s));
  return u * (steps + std::clamp(fraction, 0.0, 1.0));
}

namespace {

// m/s: the speed away from a wall that is touched only within rounding. A robot with a place that
// is rounded in each step then does not drift into a wall, however long it drives along it. Values
// that no double-precision sum loses stay the same.
double leaving_speed(double depth, const Robot& robot, const Wall& wall, const StepLaw& law) {
  const WallRounding rounding =
      wall_rounding(robot.radius, robot.max_speed, ability_of(robot), law);
  return depth > wall_margin(wall, rounding) ? depth / law.time_step : 0.0;
}

// Appends a half-plane n . v' >= -V for each wall that the robot can reach with this decision. n
// points away from the wall, V depends on its gap. For a wall that the robot is in, it is n . v'
// >= n . out, at least 0; out is velocity_out(). A wall that is touched only within rounding is
// left within the step. 0 satisfies all others. Returns whether the robot is in any wall.
bool append_speed_planes(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                         Vec2 out, Demands& demands) {
  bool is_in_any = false;
  const Ability ability = planned_ability_of(robot);
  const double reach = wall_reach(norm(robot.velocity), robot.max_speed, ability, law);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Wall& wall = walls[k];
    const Vec2 away = robot.position - nearest_on({wall.a, wall.b}, robot.position);
    const double distance = norm(away), depth = robot.radius + wall.radius - distance;
    const double gap = -depth - law.localization_error;
    if (!(gap < reach)) continue;
    if (!(distance > 0.0)) {  // the wall itself gives no direction
      is_in_any = true;
      if (out != Vec2{}) demands.add({out / norm(out), norm(out)}, k);
      continue;
    }
    const Vec2 normal = away / distance;
    const bool is_in = depth > 0.0 && depth > feigned(robot, wall, law);
    is_in_any = is_in_any || is_in;
    const double leaving = is_in         ? std::max(dot(normal, out), 0.0)
                           : depth > 0.0 ? leaving_speed(depth, robot, wall, law)
                                         : -speed_before(gap, ability.braking, law);
    demands.add({normal, std::max(leaving, -robot.max_speed)}, k);
  }
  return is_in_any;
}

}  // namespace

std::optional<WallPlane> obstacle_plane(const PlannerOptions& options, const Horizon& horizon,
                                        const Robot& robot, const Wall& wall, int index,
                                        bool& overlapping) {
  const double away = distance(robot.position, {wall.a, wall.b});
  const double reach = obstacle_reach(norm(robot.velocity), robot.max_speed, options);
  if (!(away - robot.radius - wall.radius <= reach)) return {};
  const WallPair pair = relative(robot, wall);
  const RelativeHalfPlane relative =
      disregards_acceleration(options.method)
          ? orca_wall_half_plane(pair, options.time_horizon, options.time_step)
          : wall_half_plane(pair, options.control_time * robot.max_acceleration, horizon);
  const bool coincident = relative.state == PairState::coincident;
  if (coincident || relative.state == PairState::overlapping) overlapping = true;
  if (coincident || relative.state == PairState::free) return {};
  // near contact it has no bound; keep it finite
  const double excess = std::min(relative.excess, std::numeric_limits<double>::max());
  return WallPlane{index, apportion(relative.plane, robot.velocity, 1.0), excess};
}

namespace {

void append_slowing(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                    Demands& demands) {
  const std::size_t before = demands.planes.size();
  if (!append_speed_planes(robot, walls, law, {}, demands)) return;
  demands.out = velocity_out(robot, walls, law);
  const bool is_out_of_all = is_kept(demands, demands.out);
  demands.planes.resize(before), demands.wall.resize(before);
  append_speed_planes(robot, walls, law, is_out_of_all ? demands.out : Vec2{}, demands);
}

// Appends the demands of walls on a robot, or on one disc of it.
void append_demands(const Planner& planner, const Robot& robot, std::span<const Wall> walls,
                    const StepLaw& law, Demands& demands) {
  const PlannerOptions& options = planner.options();
  if (slows_before_walls(options.method)) return append_slowing(robot, walls, law, demands);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto own =
        obstacle_plane(options, planner.horizon(), robot, walls[k], 0, demands.overlapping);
    if (!own) continue;
    demands.add(own->plane, k);
    demands.excess.push_back(own->excess);
  }
}

}  // namespace

void collect_demands(const Planner& planner, const Robot& robot, std::span<const Wall> walls,
                     const StepLaw& law, Demands& demands) {
  demands.clear();
  const PlannerOptions& options = planner.options();
  const bool at_once = adopts_at_once(options.method);
  if (!has_footprint(robot.model)) {
    append_demands(planner, robot, walls, law, demands);
  } else {
    const Discs discs = discs_of(robot, law);
    for (const Robot& disc : discs.all()) append_demands(planner, disc, walls, law, demands);
  }
  append_own_half_planes(robot, at_once ? options.time_step : options.control_time, demands.planes);
}

bool is_kept(const Demands& demands, Vec2 v_new) {
  const auto exceeds = [](double excess) { return excess > 0.0; };
  return std::none_of(demands.excess.begin(), demands.excess.end(), exceeds) &&
         std::all_of(demands.planes.begin(), demands.planes.end(),
                     [&](const HalfPlane& plane) { return violation(plane, v_new) <= 0.0; });
}

}  // namespace avo::inline planner
