// SPDX-License-Identifier: Apache-2.0
// What the target of the first program has to keep to: what a robot's own motion can follow, and
// what walls ask. Of methods avo and buffered_voronoi: no more speed towards one than braking can
// take off before it. Of the others: the half-planes of the walls' obstacles.
#pragma once
#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "avo/planner.h"
#include "avo/robot.h"
#include "avo/wall.h"
#include "certificate/braking_path.h"

namespace avo::inline planner {

/// Whether half-planes of walls are about the speed towards them alone.
constexpr bool slows_before_walls(Method method) {
  return method == Method::avo || method == Method::buffered_voronoi;
}

/// m/s: the largest V with V Δt + l(V) <= gap.
double speed_before(double gap, double max_braking, const StepLaw& law);

/// A half-plane n . v' >= -V for each wall that the robot can reach with this decision, n away from
/// it, V by its gap. Of one that it is in, n . v' >= n . out, at least 0, out being its
/// velocity_out(); one that is touched by as little as rounding feigns is left within the step. 0
/// is in all others. Returns whether it is in any.
bool append_speed_planes(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                         Vec2 out, std::vector<HalfPlane>& half_planes);

/// m, from its surface: no farther wall can be touched before τ by a robot that is so fast now.
inline double obstacle_reach(double speed, double max_speed, const PlannerOptions& options) {
  return options.time_horizon * std::max(speed, max_speed);
}

/// The half-plane of the wall's obstacle, in v', all of it the robot's: that of its
/// acceleration-velocity obstacle, or of the limit δ -> 0 where v' is adopted at once. None of a
/// wall out of reach. Sets `overlapping` where the robot touches it already.
std::optional<WallPlane> obstacle_plane(const PlannerOptions& options, const Horizon& horizon,
                                        const Robot& robot, const Wall& wall, int index,
                                        bool& overlapping);

/// What a decision has to keep to. Scratch memory; allocates only while it grows.
struct Demands {
  std::vector<HalfPlane> planes;
  std::vector<double>
      excess;  ///< m/s, of those of walls, which come first, see WallPlane; none of speed planes
  bool overlapping = false;  ///< with a wall
  Vec2 out;                  ///< m/s, see velocity_out(); of speed planes

  void clear() { planes.clear(), excess.clear(), overlapping = false, out = {}; }
  void reserve(std::size_t walls) { planes.reserve(walls), excess.reserve(walls); }
};

/// Replaces the demands by those of all walls in reach, or by their speed planes, and those of the
/// robot's own motion.
void collect_demands(const Planner& planner, const Robot& robot, std::span<const Wall> walls,
                     const StepLaw& law, Demands& demands);

/// Whether v' keeps to them, as far as that is possible at all.
bool is_kept(const Demands& demands, Vec2 v_new);

}  // namespace avo::inline planner
