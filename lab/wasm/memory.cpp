// SPDX-License-Identifier: Apache-2.0
// The data that a start does not contain, but that a simulation needs when it takes over. They are
// states to the last bit, and the robots' memories.
#include <algorithm>
#include <cstddef>

#include "host.h"
#include "sim/state/saved_state.h"

namespace avo_lab {
namespace {

using avo::SavedState;

constexpr double kRounding = 1e-6;  // m

/// Returns whether both have the same robots, with the same bodies.
bool same_robots(const SavedState& a, const SavedState& b) {
  if (a.robots.size() != b.robots.size()) return false;
  for (std::size_t k = 0; k < a.robots.size(); ++k) {
    const avo::RobotSetup &one = a.scene.robots[k], &other = b.scene.robots[k];
    if (a.robots[k].id != b.robots[k].id || one.model != other.model ||
        one.radius != other.radius || is_parked(one) != is_parked(other))
      return false;
  }
  return true;
}

bool has_goals_of(const SavedState& a, const SavedState& b) {
  return std::equal(a.scene.robots.begin(), a.scene.robots.end(), b.scene.robots.begin(),
                    b.scene.robots.end(),
                    [](const auto& one, const auto& other) { return one.goal == other.goal; });
}

/// Takes the states of robots that keep their places: a detour belongs to a robot's goal.
void take_states(const SavedState& now, SavedState& next) {
  std::size_t i = 0;
  for (std::size_t k = 0; k < next.robots.size(); ++k) {
    avo::SavedRobot& robot = next.robots[k];
    while (i < now.robots.size() && now.robots[i].id.value < robot.id.value) ++i;
    if (i == now.robots.size() || now.robots[i].id != robot.id) continue;
    const avo::RobotSetup &setup = next.scene.robots[k], &was = now.scene.robots[i];
    const double moved = norm(robot.position - now.robots[i].position);  // a start rounds the place
    if (setup.model != was.model || is_parked(setup) || moved > kRounding) continue;
    const avo::Detour fresh = robot.detour;
    robot = now.robots[i];
    if (!(setup.goal == was.goal)) robot.detour = fresh;
  }
}

/// Takes the waypoints that robots aim at. They belong to a graph, which depends on walls and
/// radii.
void take_routes(const SavedState& now, SavedState& next) {
  if (now.routes.size() != next.routes.size() || now.scene.obstacles != next.scene.obstacles ||
      now.scene.navigation != next.scene.navigation)
    return;
  for (std::size_t k = 0; k < next.routes.size(); ++k)
    if (now.scene.robots[k].goal == next.scene.robots[k].goal) next.routes[k] = now.routes[k];
}

bool same_clocks(const SavedState& a, const SavedState& b) {
  return a.scene.time_step == b.scene.time_step && a.clocks.size() == b.clocks.size() &&
         std::equal(a.scene.robots.begin(), a.scene.robots.end(), b.scene.robots.begin(),
                    b.scene.robots.end(), [](const auto& one, const auto& other) {
                      return one.time_step == other.time_step;
                    });
}

/// Takes the present time, and the past states: only for the same robots with the same senses and
/// clocks.
void take_time(const SavedState& now, SavedState& next) {
  if (now.scene.clock != next.scene.clock) return;
  const bool same = same_robots(now, next);
  const bool remember = !now.since.empty() || !next.since.empty();
  if (remember && (!same || now.scene.sensing != next.scene.sensing)) return;
  if (next.scene.clock == avo::Clock::free && (!same || !same_clocks(now, next))) return;
  next.steps = now.steps;
  next.now = now.now;
  next.clocks = now.clocks;
  next.since = now.since;
  next.past = now.past;
  next.tracks = now.tracks;
}

}  // namespace

void remember(avo::Simulation& simulation, const std::vector<bool>& goes_on) {
  const SavedState now = avo::from_bytes(plane().simulation->save());
  SavedState next = avo::from_bytes(simulation.save());
  take_states(now, next);
  for (std::size_t k = 0; k < std::min(goes_on.size(), next.movers.size()); ++k) {
    if (!goes_on[k]) continue;
    next.movers[k] = now.movers[k];
    if (now.scene.moving_obstacles[k].path != next.scene.moving_obstacles[k].path)
      next.movers[k].next_point = 0;
  }
  take_time(now, next);
  if (same_robots(now, next)) {
    take_routes(now, next);
    if (has_goals_of(now, next)) next.flights = now.flights;
  }
  simulation.restore(avo::to_bytes(std::move(next)));
}

}  // namespace avo_lab
