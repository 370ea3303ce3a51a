// SPDX-License-Identifier: Apache-2.0
// Checks of a saved state that bytes of another program, or forged ones, do not pass.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/plane.h"
#include "core/ranges.h"
#include "planner/rules/arrival.h"
#include "robots/model.h"
#include "sim/clocks.h"
#include "sim/scene/scene_checks.h"
#include "sim/state/saved_state.h"

namespace avo::inline sim {

void refuse_saved(const std::string& given, const std::string& allowed) {
  refuse("saved state", given, allowed);
}

namespace {

constexpr std::int64_t kLastInstant = std::int64_t{1} << 62;  // ns
// time() cannot distinguish later ones
constexpr std::int64_t kLastStep = std::int64_t{1} << 53;

// Checks as many robots at a time as a scene may have: a simulation may have more after additions.
void check_setups(const Scenario& scene) {
  Scenario part = scene;
  part.teams.clear();  // some of their robots may be gone
  constexpr auto kMost = static_cast<std::size_t>(kMostRobots);
  for (std::size_t first = 0; first == 0 || first < scene.robots.size(); first += kMost) {
    const std::size_t last = std::min(first + kMost, scene.robots.size());
    const auto begin = scene.robots.begin();
    part.robots.assign(begin + static_cast<std::ptrdiff_t>(first),
                       begin + static_cast<std::ptrdiff_t>(last));
    part.sensing_error = scene.sensing_error;
    forget_undeclared_error(part);
    validate(part);
  }
}

void check_led(const SavedState& state) {
  for (const Team& team : state.scene.teams) {
    validate(team.task);
    const auto is_sound = [](Vec2 point) { return is_finite(point); };
    const bool are_members =
        std::all_of(team.members.begin(), team.members.end(),
                    [&](const TeamMember& member) { return is_sound(member.goal); });
    // one that is led has a trail
    const bool has_trail = !std::holds_alternative<Follow>(team.task) || team.members.empty() ||
                           !team.members.front().is_led || !team.trail.empty();
    if (!are_members || !has_trail || !std::isfinite(team.since) ||
        !std::all_of(team.trail.begin(), team.trail.end(), is_sound))
      refuse_saved("a team that cannot be led", "one that can");
  }
}

// Checks that robots that fly are on their circles, as after a step.
void check_flights(const SavedState& state) {
  constexpr double kOff = 1e-6;  // of the radius
  std::size_t k = 0;
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const SavedRobot& robot = state.robots[i];
    if (can_rest(state.scene.robots[i].model)) continue;
    const LoiterCircle own =
        *circle_of(state.scene.robots[i].model, robot.position, robot.velocity);
    const LoiterCircle& saved = state.flights[k++].circle;
    const double off = kOff * own.radius;
    if (!(norm(own.center - saved.center) <= off && std::abs(own.radius - saved.radius) <= off))
      refuse_saved("a robot off its circle", "one on it");
  }
}

// Returns whether the steps are consecutive, up to the present one.
bool is_sound(const std::vector<Knot>& track, const SavedClock& clock) {
  const bool whole = track.size() >= 2 && track.front().at >= 0 && track.back().at == clock.end;
  const bool ascends = std::is_sorted(track.begin(), track.end(),
                                      [](const Knot& a, const Knot& b) { return a.at < b.at; });
  return whole && ascends && std::all_of(track.begin(), track.end(), [](const Knot& knot) {
           return is_finite(knot.state.position) && is_finite(knot.state.velocity) &&
                  kAnyValue.contains(knot.state.heading);
         });
}

// Checks the tracks, where past states are by instants.
void check_tracks(const SavedState& state) {
  const std::size_t robots = state.robots.size();
  bool sound = state.since.size() == robots && state.tracks.size() == robots &&
               state.clocks.size() == robots;
  for (std::size_t k = 0; k < robots && sound; ++k)
    sound = state.since[k] >= 0 && state.since[k] <= state.now &&
            is_sound(state.tracks[k], state.clocks[k]);
  if (!sound) refuse_saved("a past that no robots can have", "theirs");
}

void check_past(const SavedState& state) {
  if (senses_by_time(state.scene)) return check_tracks(state);
  const std::size_t depth = generations_needed(state.scene), robots = state.robots.size();
  if (depth < 2) return;
  const bool whole = state.since.size() == robots && state.past.size() == robots * depth;
  const bool dated = std::all_of(state.since.begin(), state.since.end(), [&](std::int64_t since) {
    return since >= 0 && since <= state.steps;
  });
  const bool finite = std::all_of(state.past.begin(), state.past.end(), [](const PastState& past) {
    return is_finite(past.position) && is_finite(past.velocity);
  });
  if (!whole || !dated || !finite) refuse_saved("a past that no robots can have", "theirs");
}

// Preferred velocities are of robots that decide, each once.
void check_told(const SavedState& state) {
  std::size_t k = 0;  // ids ascend in both
  for (const SavedTold& told : state.told) {
    while (k < state.robots.size() && state.robots[k].id.value < told.robot) ++k;
    if (k == state.robots.size() || state.robots[k].id.value != told.robot ||
        is_parked(state.scene.robots[k]))
      refuse_saved("a preferred velocity of robot " + std::to_string(told.robot),
                   "one of a robot that moves");
    if (!kAnyValue.contains(told.velocity.x) || !kAnyValue.contains(told.velocity.y))
      refuse_saved("a preferred velocity that is not finite", "finite");
    ++k;
  }
}

// The host moves robots of common clocks that have no heading and avoid nobody, each once.
void check_host_motions(const SavedState& state) {
  std::size_t k = 0;  // ids ascend in both
  for (const auto& [id, motion] : state.host_motions) {
    while (k < state.robots.size() && state.robots[k].id.value < id) ++k;
    const bool is_known = k < state.robots.size() && state.robots[k].id.value == id;
    const RobotSetup setup = is_known ? state.scene.robots[k] : RobotSetup{};
    if (!is_known || is_parked(setup) || !is_holonomic(setup.model) || setup.avoids.bits != 0 ||
        state.scene.clock == Clock::free || !state.bases.are_exact())
      refuse_saved("a velocity of robot " + std::to_string(id), "one of a robot that hosts move");
    if (!kAnyValue.contains(motion.velocity.x) || !kAnyValue.contains(motion.velocity.y))
      refuse_saved("a velocity that is not finite", "finite");
    if (!motion.ends && norm(motion.velocity) > setup.max_speed * (1.0 + kSpeedRounding))
      refuse_saved("a velocity of robot " + std::to_string(id) + " above its max_speed", "less");
    ++k;
  }
}

// For a robot that may move in any manner within its step, the step must be valid.
void check_clocks(const SavedState& state) {
  if (state.scene.clock != Clock::free) return;
  const auto is_whole = [](const MotionState& s) {
    return is_finite(s.position) && is_finite(s.velocity) && kAnyValue.contains(s.heading);
  };
  bool sound = state.now >= 0 && state.now <= kLastInstant;
  for (std::size_t k = 0; k < state.clocks.size() && sound; ++k) {
    const SavedClock& clock = state.clocks[k];
    const RobotSetup& robot = state.scene.robots[k];
    sound = clock.begin >= 0 && clock.begin <= state.now && clock.end >= state.now &&
            is_whole(clock.from) && is_whole(clock.to);
    if (is_parked(robot)) sound = sound && clock.end == std::numeric_limits<Instant>::max();
    if (is_parked(robot) || !sound) continue;
    const auto step = whole_nanoseconds(time_step_of(state.scene, robot));
    sound = step && clock.end - clock.begin <= *step &&
            (!clock.has_decided || clock.end - clock.begin == *step);
  }
  if (!sound) refuse_saved("clocks that no robots can have", "theirs");
}

bool is_sound(const Waiting& waiting) {
  const bool is_none = waiting.least == kInfinity && waiting.closed.empty();
  const bool is_one = waiting.least >= 0.0 && waiting.waited >= 0.0 && waiting.looks_at >= 0.0 &&
                      waiting.opens_at >= 0.0;
  return (is_none || is_one) && waiting.waited < kInfinity &&
         std::all_of(waiting.closed.begin(), waiting.closed.end(),
                     [](const Segment& gap) { return is_finite(gap.a) && is_finite(gap.b); });
}

// Refuses states that no simulation can reach: only forged bytes have them.
void check_states(const SavedState& state) {
  const auto is_finite_motion = [](const auto& body) {
    return is_finite(body.position) && is_finite(body.velocity);
  };
  const bool moves = std::all_of(state.robots.begin(), state.robots.end(), is_finite_motion) &&
                     std::all_of(state.movers.begin(), state.movers.end(), is_finite_motion);
  if (!moves) refuse_saved("a position or velocity that is not finite", "finite");
  if (!std::all_of(state.routes.begin(), state.routes.end(),
                   [](const SavedRoute& route) { return is_finite(route.place); }))
    refuse_saved("the end of a route that is not finite", "finite");
  if (!std::all_of(state.routes.begin(), state.routes.end(),
                   [](const SavedRoute& route) { return is_sound(route.waiting); }))
    refuse_saved("a wait that no robot can remember", "a sound one");
  for (std::size_t k = 0; k < state.movers.size(); ++k) {
    const std::size_t points =
        std::max<std::size_t>(state.scene.moving_obstacles[k].path.size(), 1);
    if (state.movers[k].next_point >= points)
      refuse_saved("path point " + std::to_string(state.movers[k].next_point),
                   "below " + std::to_string(points));
  }
  std::uint64_t next = 0;  // lower bound of the id
  const auto check_id = [&next](std::uint64_t id, std::uint64_t beyond) {
    if (id < next || id >= beyond)
      refuse_saved("id " + std::to_string(id),
                   "ascending and below the next, " + std::to_string(beyond));
    next = id + 1;
  };
  for (const ObstacleId id : state.static_ids) check_id(id.value, state.next_obstacle);
  next = 0;
  for (const MovingObstacleId id : state.mover_ids) check_id(id.value, state.next_mover);
  check_led(state);
  check_flights(state);
  check_past(state);
  check_clocks(state);
  next = 0;
  for (const std::uint64_t id : state.stood) check_id(id, state.next_id);
  next = 0;
  for (const SavedRobot& robot : state.robots) {
    if (!kAnyValue.contains(robot.heading))
      refuse_saved("heading " + text(robot.heading), "an angle in rad");
    if (!is_sound(robot.detour)) refuse_saved("a detour that no robot can remember", "a sound one");
    check_id(robot.id.value, state.next_id);
  }
  check_told(state);
  check_host_motions(state);
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    const SavedRobot& robot = state.robots[k];
    if (!is_parked(state.scene.robots[k])) continue;
    const RobotSetup& setup = state.scene.robots[k];
    const Vec2 center = disc_center(setup.model, setup.goal, robot.heading);
    if (!(robot.position == center && robot.velocity == Vec2{}))
      refuse_saved("a parked robot that has moved", "one at its goal");
  }
  if (state.steps < 0 || state.steps > kLastStep) {
    refuse_saved(std::to_string(state.steps) + " steps", "0 to " + std::to_string(kLastStep));
  }
}

}  // namespace

void check_saved(const SavedState& state) {
  check_setups(state.scene);
  const double radius = state.sensing_radius, named = state.scene.sensing_radius.value_or(radius);
  if (!kPositive.contains(radius) || radius != named)
    refuse_saved("a sensing radius of " + text(radius) + " m", "that of the scene");
  check_states(state);
}

}  // namespace avo::inline sim
