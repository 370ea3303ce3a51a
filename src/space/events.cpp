// SPDX-License-Identifier: Apache-2.0
// Differences between what was observed last and what holds now, as in the plane.
#include "avo/space/events.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "avo/space/explanation.h"
#include "core/ranges.h"
#include "metrics/wall_contacts.h"
#include "metrics/watched.h"

namespace avo::space {
struct Events::State {
  /// Ids of a robot and of a moving obstacle that overlap.
  struct MoverTouch {
    std::uint64_t robot = 0, mover = 0;
    auto operator<=>(const MoverTouch&) const = default;
  };

  double stuck_after = 0.0;  // s
  double time = 0.0;         // s, of the last observation
  std::vector<WatchedRobot<Vec3>> robots;
  std::vector<MoverTouch> touches, touched;  // ascending: now, and before
  std::vector<Event> events;

  void take_robots(const Simulation& simulation);
  void observe_robot(const Simulation& simulation, std::size_t k);
  void find_touches(const Simulation& simulation);
  void observe_touches(const Simulation& simulation);
};

// Another simulation may have another number of them.
void Events::State::take_robots(const Simulation& simulation) {
  for (; robots.size() > simulation.size(); robots.pop_back())
    events.push_back({.kind = EventKind::gone, .robot = robots.back().id});
  while (robots.size() < simulation.size()) {
    const RobotId id{robots.size()};
    const RobotSetup& setup = simulation.scenario().robots[robots.size()];
    events.push_back({.kind = EventKind::came, .robot = id});
    robots.push_back({.id = id,
                      .preferred_speed = setup.preferred_speed,
                      .max_speed = setup.max_speed,
                      .goal = setup.goal,
                      .position = simulation.robots()[robots.size()].position,
                      .length = simulation.route(id).length,
                      .since = simulation.time()});
  }
}

void Events::State::observe_robot(const Simulation& simulation, std::size_t k) {
  WatchedRobot<Vec3>& robot = robots[k];
  const Vec3 goal = simulation.goal(robot.id);
  const RobotLook look{time, simulation.time(), stuck_after, !(goal == robot.goal)};
  watch_goal(robot, goal, simulation.is_at_goal(robot.id), events);
  const double length = simulation.route(robot.id).length;
  if (watch_progress(
          robot, simulation.robots()[k].position, length, look, [] { return false; }, events))
    events.back().sentence = simulation.explain(robot.id).sentence;
}

void Events::State::find_touches(const Simulation& simulation) {
  const std::span<const Mover> movers = simulation.movers();
  std::swap(touches, touched);
  touches.clear();
  for (std::size_t k = 0; k < robots.size() && !movers.empty(); ++k) {
    const Robot& robot = simulation.robots()[k];
    for (std::size_t m = 0; m < movers.size(); ++m) {
      const double contact = (robot.radius + movers[m].radius) * (1.0 - kContact);
      if (norm_squared(movers[m].position - robot.position) < contact * contact)
        touches.push_back({k, simulation.moving_obstacle_ids()[m].value});
    }
  }
  touched.reserve(touches.capacity());  // the next call allocates nothing for the same ones
}

void Events::State::observe_touches(const Simulation& simulation) {
  const double duration = simulation.time() - time;
  find_touches(simulation);
  for (const MoverTouch& touch : touches) {
    if (std::binary_search(touched.begin(), touched.end(), touch)) continue;
    events.push_back(contact_of(robots[static_cast<std::size_t>(touch.robot)], duration));
    events.back().moving_obstacle = {touch.mover};
  }
}

Events::Events(const Simulation& simulation, const EventsOptions& options)
    : state_(std::make_unique<State>()) {
  require("stuck_after", options.stuck_after, kPositive, "s");
  state_->stuck_after = options.stuck_after;
  state_->time = simulation.time();
  static_cast<void>(observe(simulation));
}
Events::~Events() = default;

std::span<const Event> Events::observe(const Simulation& simulation) {
  State& state = *state_;
  state.events.clear();
  state.take_robots(simulation);
  for (std::size_t k = 0; k < state.robots.size(); ++k) state.observe_robot(simulation, k);
  state.observe_touches(simulation);
  state.time = simulation.time();
  sort_events(state.events);
  return state.events;
}

}  // namespace avo::space
