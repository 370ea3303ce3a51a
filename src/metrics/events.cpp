// SPDX-License-Identifier: Apache-2.0
// Differences between what was observed last and what holds now.
#include "avo/events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "avo/explanation.h"
#include "core/plane.h"
#include "core/ranges.h"
#include "metrics/mover_contacts.h"

namespace avo {
namespace {

constexpr double kGetsOn = 0.01;       // of the preferred speed: a slower robot makes no progress
constexpr double kPutDown = 2.0;       // of max_speed: a faster robot was put down elsewhere
constexpr double kStandsStill = 1e-9;  // of max_speed: a slower robot has not moved
constexpr double kSumOfSteps = 1e-9;   // of a duration: its rounding

// In the order of EventKind.
constexpr std::array kEventWords{"gone",        "came",  "left",   "arrived",
                                 "unreachable", "stuck", "contact"};

}  // namespace

const char* to_string(EventKind kind) {
  return kEventWords[static_cast<std::size_t>(kind)];
}

struct Events::State {
  /// A robot as it was observed last.
  struct Watched {
    RobotId id;
    bool parked = false, at_goal = false, unreachable = false;
    bool stuck = false;                             // that is told
    double preferred_speed = 0.0, max_speed = 0.0;  // m/s
    double start_time = 0.0;                        // s
    Vec2 goal = {}, position = {};                  // m
    double length = 0.0;                            // m, of its route
    double moved = 0.0;                             // m, since the observation before
    double since = 0.0;                             // s, when it last made progress
    double made = 0.0;                              // m, of its route since then; < 0: it went back
  };

  double stuck_after = 0.0;  // s
  std::uint64_t roster = 0;  // of the robots below; 0: none
  double time = 0.0;         // s, of the last observation
  std::vector<Watched> robots;
  MoverContacts contacts;
  std::vector<Event> events;

  void tell(RobotId robot, EventKind kind) { events.push_back({.kind = kind, .robot = robot}); }
  void take_roster(const Simulation& simulation);
  void observe_goal(const Simulation& simulation, std::size_t row, Vec2 goal);
  void observe_progress(const Simulation& simulation, std::size_t row, Vec2 position,
                        bool has_new_goal);
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
    Watched& robot = present.emplace_back(is_known ? *known++ : Watched{.id = fleet.id[row]});
    robot.parked = setup.parked;
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

void Events::State::observe_goal(const Simulation& simulation, std::size_t row, Vec2 goal) {
  Watched& robot = robots[row];
  const bool is_new = !(goal == robot.goal), is_at_goal = simulation.is_at_goal(robot.id);
  if (robot.at_goal && (is_new || !is_at_goal)) tell(robot.id, EventKind::left);
  if (is_at_goal && (is_new || !robot.at_goal)) tell(robot.id, EventKind::arrived);
  robot.goal = goal, robot.at_goal = is_at_goal;
}

// The part of the route that the robot made is at most what it moved. So a route that changes, as
// when a door opens, is no progress.
void Events::State::observe_progress(const Simulation& simulation, std::size_t row, Vec2 position,
                                     bool has_new_goal) {
  Watched& robot = robots[row];
  const double now = simulation.time(), length = simulation.route(robot.id).length;
  const bool unreachable = length == std::numeric_limits<double>::infinity();
  if (unreachable && (has_new_goal || !robot.unreachable)) tell(robot.id, EventKind::unreachable);
  robot.unreachable = unreachable;
  robot.moved = norm(position - robot.position);
  robot.made += std::clamp(robot.length - length, -robot.moved, robot.moved);
  robot.position = position, robot.length = length;
  // where time went back, too
  const bool was_put_down = robot.moved > kPutDown * robot.max_speed * (now - time);
  if (has_new_goal || robot.at_goal || unreachable || was_put_down ||
      robot.made > kGetsOn * robot.preferred_speed * stuck_after ||
      waits_to_start(robot.start_time, now) || simulation.preferred_velocity(robot.id)) {
    robot.made = 0.0, robot.since = now, robot.stuck = false;
  } else if (!robot.stuck && now - robot.since >= stuck_after * (1.0 - kSumOfSteps)) {
    robot.stuck = true;
    tell(robot.id, EventKind::stuck);
    events.back().sentence = simulation.explain(robot.id).sentence;
  }
}

void Events::State::observe_contacts(const Simulation& simulation,
                                     std::span<const Vec2> positions) {
  const double duration = simulation.time() - time;
  contacts.observe(simulation, positions);
  for (const MoverContact& contact : contacts.begun()) {
    const Watched& robot = robots[contact.row];
    events.push_back({.kind = EventKind::contact,
                      .robot = robot.id,
                      .moving_obstacle = {contact.obstacle},
                      .at_rest = robot.moved <= kStandsStill * robot.max_speed * duration});
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
  if (simulation.roster() != state.roster) state.take_roster(simulation);
  const FleetView fleet = simulation.fleet(Columns::position | Columns::goal);
  for (std::size_t row = 0; row < state.robots.size(); ++row) {
    if (state.robots[row].parked) continue;
    const bool has_new_goal = !(fleet.goal[row] == state.robots[row].goal);
    state.observe_goal(simulation, row, fleet.goal[row]);
    state.observe_progress(simulation, row, fleet.position[row], has_new_goal);
  }
  state.observe_contacts(simulation, fleet.position);
  state.time = simulation.time();
  const auto place = [](const Event& event) {
    return std::tuple(event.robot.value, event.kind, event.moving_obstacle.value);
  };
  std::sort(state.events.begin(), state.events.end(),
            [&](const Event& a, const Event& b) { return place(a) < place(b); });
  return state.events;
}

}  // namespace avo
