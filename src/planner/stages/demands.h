// SPDX-License-Identifier: Apache-2.0
// The demands that the target of the first program must keep: the limits of a robot's own motion,
// and the demands of walls. For methods avo and buffered_voronoi a robot moves no faster towards a
// wall than braking can take off before it. For the others they are the half-planes of the walls'
// obstacles.
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

/// Returns whether half-planes of walls limit only the speed towards them.
constexpr bool slows_before_walls(Method method) {
  return method_traits(method).has_rules || method_traits(method).stays_in_cell;
}

/// m/s: the largest V with V Δt + l(V) <= gap.
double speed_before(double gap, double max_braking, const StepLaw& law);

/// m, from the wall's surface: a robot that is now so fast can touch no farther wall before τ.
inline double obstacle_reach(double speed, double max_speed, const PlannerOptions& options) {
  return options.time_horizon * std::max(speed, max_speed);
}

/// The half-plane of the wall's obstacle, in v', with the whole share of the robot. It is that of
/// the acceleration-velocity obstacle, or of the limit δ -> 0 where v' is adopted at once. None for
/// a wall out of reach. Sets `overlapping` where the robot touches the wall already.
std::optional<WallPlane> obstacle_plane(const PlannerOptions& options, const Horizon& horizon,
                                        const Robot& robot, const Wall& wall, int index,
                                        bool& overlapping);

/// The demands on a decision. Scratch memory; allocates only while it grows.
struct Demands {
  std::vector<HalfPlane> planes;
  std::vector<double>
      /// m/s, of the planes of walls, which come first, see WallPlane; none for speed planes
      excess;
  std::vector<int> wall;     ///< index of the wall of each of these planes
  bool overlapping = false;  ///< whether the robot overlaps a wall
  Vec2 out;                  ///< m/s, see velocity_out(); for speed planes

  void clear() { planes.clear(), excess.clear(), wall.clear(), overlapping = false, out = {}; }
  void reserve(std::size_t walls) {
    planes.reserve(walls), excess.reserve(walls), wall.reserve(walls);
  }
  /// Appends a half-plane of a wall.
  void add(const HalfPlane& plane, std::size_t of_wall) {
    planes.push_back(plane), wall.push_back(static_cast<int>(of_wall));
  }
};

/// Replaces the demands by those of all walls in reach, or by their speed planes, and those of the
/// robot's own motion.
void collect_demands(const Planner& planner, const Robot& robot, std::span<const Wall> walls,
                     const StepLaw& law, Demands& demands);

/// Returns whether v' keeps them, as far as that is possible at all.
bool is_kept(const Demands& demands, Vec2 v_new);

}  // namespace avo::inline planner
