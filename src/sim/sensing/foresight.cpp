// SPDX-License-Identifier: Apache-2.0
// What robots know of the paths of moving obstacles.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/plane.h"
#include "planner/rules/evading.h"
#include "planner/stages/certify.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

constexpr std::int64_t kStepsForeseen = 64;  // steps, after which trajectories are made anew
// steps; of a longer round only the beginning is known
constexpr std::int64_t kLongestRound = 16384;

// The longest evasive maneuver of any robot of the fleet.
double horizon_of(const World& world) {
  double longest = 0.0;
  const StepLaw law = certificate_law(world.planner()).step;
  for (std::size_t slot = 0; slot < world.fleet.size(); ++slot)
    longest = std::max(longest, longest_evasion(limits_of(world.fleet, slot), law));
  return longest;
}

// Follows the path until that step, and then until the obstacle has been at all points of the path
// once more. So all its future places are known, to within a step.
void follow_path(const MovingObstacle& obstacle, PathWalk walk, std::int64_t step,
                 std::int64_t until, double time_step, std::vector<TimedPlace>& places,
                 Trajectory& trajectory) {
  const auto time_of = [&](std::int64_t k) { return static_cast<double>(k) * time_step; };
  places.assign(1, {time_of(step), walk.position});
  const auto go_on = [&] {
    walk = next_on_path(obstacle, walk, time_step);
    places.push_back({time_of(++step), walk.position});
  };
  while (step < until) go_on();
  // to the end of its present leg, and of all others
  for (std::size_t left = obstacle.path.size() + 1; left > 0 && step < until + kLongestRound;) {
    const PathWalk before = walk;
    go_on();
    if (walk.next_point != before.next_point) --left;
    if (is_rest(walk.velocity) && walk.position == before.position) break;
  }
  const double bend = 0.125 * time_step * time_step * obstacle.max_deviation;
  trajectory.assign(places, bend, time_of(until));
}

bool foresees(const World& world) {
  return world.movers.has_paths && world.senses.are_exact() && !world.fleet.has_clocks &&
         world.all_matter();
}

}  // namespace

void foresee(World& world) {
  if (!foresees(world)) return;
  MoverColumns& movers = world.movers;
  Foresight& foresight = movers.foresight;
  const double horizon = world.changed ? horizon_of(world) : foresight.horizon;
  const double time_step = world.settings.time_step;
  const std::int64_t rest = kStepsForeseen - movers.steps % kStepsForeseen;
  const std::int64_t until =
      movers.steps + rest + static_cast<std::int64_t>(std::ceil(horizon / time_step));
  if (until == foresight.until) return;
  foresight.time_step = time_step, foresight.horizon = horizon, foresight.until = until;
  foresight.trajectory.resize(movers.setup.size());
  for (std::size_t k = 0; k < movers.setup.size(); ++k) {
    if (movers.setup[k].path.empty()) continue;
    follow_path(movers.setup[k], movers.walk(k), movers.steps, until, time_step, foresight.places,
                foresight.trajectory[k]);
  }
}

}  // namespace avo::inline sim
