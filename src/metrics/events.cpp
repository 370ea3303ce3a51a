// SPDX-License-Identifier: Apache-2.0
// Differences between what was observed last and what holds now.
#include "avo/events.h"

#include <array>
#include <utility>
#include <vector>

#include "avo/explanation.h"
#include "core/plane.h"
#include "core/ranges.h"
#include "metrics/mover_contacts.h"
#include "metrics/watched.h"

namespace avo {
namespace {

// In the order of EventKind.
constexpr std::array kEventWords{"gone",        "came",  "left",   "arrived",
                                 "unreachable", "stuck", "contact"};

}  // namespace

const char* to_string(EventKind kind) {
  return kEventWords[static_cast<std::size_t>(kind)];
}

struct Events::State {
  struct Watched : WatchedRobot<Vec2> {
    bool parked = false;
    double start_time = 0.0;  // s
  };

  double stuck_after = 0.0;  // s
  std::uint64_t roster = 0;  // of the robots below; 0: none
  double time = 0.0;         // s, of the last observation
  std::vector<Watched> robots;
  MoverContacts contacts;
  std::vector<Event> events;

  void tell(RobotId robot, EventKind kind) { events.push_back({.kind = kind, .robot = robot}); }
  void take_roster(const Simulation& simulation);
  void observe_robot(const Simulation& simulation, std::size_t row, Vec2 goal, Vec2 position);
  void observe_contacts(const Simulation& simulation, std::span<const Vec2> positions);
};

// Ids ascend in both. A robot that came is where it is, and nothing else is known of it.
void Events::State::take_roster(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet(Columns::id | Columns::setup);
  std::vector<Watched> present;
  present.reserve(fleet.id.size());
  auto known = robots.begin();
  for (std::size_t row = 0; row < fleet.id.size(); ++row) {
    const RobotSetup& setup = fleet.setup[row];
    for (; known != robots.end() && known->id.value < fleet.id[row].value; ++known)
      tell(known->id, EventKind::gone);
    const bool is_known = known != robots.end() && known->id == fleet.id[row];
    if (!is_known) tell(fleet.id[row], EventKind::came);
    Watched& robot = present.emplace_back(is_known ? *known++ : Watched{{.id = fleet.id[row]}});
    robot.parked = is_parked(setup);
    robot.preferred_speed = setup.preferred_speed, robot.max_speed = setup.max_speed;
    robot.start_time = setup.start_time;
    if (is_known) continue;
    robot.goal = setup.goal, robot.position = setup.position;
    robot.length = simulation.route(robot.id).length, robot.since = simulation.time();
  }
  for (; known != robots.end(); ++known) tell(known->id, EventKind::gone);
  robots = std::move(present);
  contacts.take(fleet);
  roster = simulation.roster();
}

void Events::State::observe_robot(const Simulation& simulation, std::size_t row, Vec2 goal,
                                  Vec2 position) {
  Watched& robot = robots[row];
  const RobotLook look{time, simulation.time(), stuck_after, !(goal == robot.goal)};
  watch_goal(robot, goal, simulation.is_at_goal(robot.id), events);
  const auto is_steered = [&] {
    return simulation.preferred_velocity(robot.id) || simulation.is_moved(robot.id) ||
           waits_to_start(robot.start_time, simulation.time());
  };
  const double length = simulation.route(robot.id).length;
  if (watch_progress(robot, position, length, look, is_steered, events))
    events.back().sentence = simulation.explain(robot.id).sentence;
}

void Events::State::observe_contacts(const Simulation& simulation,
                                     std::span<const Vec2> positions) {
  const double duration = simulation.time() - time;
  contacts.observe(simulation, positions);
  for (const MoverContact& contact : contacts.begun())
    events.push_back(contact_of(robots[contact.row], {contact.obstacle}, duration));
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
  if (simulation.roster() != state.roster) state.take_roster(simulation);
  const FleetView fleet = simulation.fleet(Columns::position | Columns::goal);
  for (std::size_t row = 0; row < state.robots.size(); ++row) {
    if (state.robots[row].parked) continue;
    state.observe_robot(simulation, row, fleet.goal[row], fleet.position[row]);
  }
  state.observe_contacts(simulation, fleet.position);
  state.time = simulation.time();
  sort_events(state.events);
  return state.events;
}

}  // namespace avo
