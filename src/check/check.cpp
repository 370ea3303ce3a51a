// SPDX-License-Identifier: Apache-2.0
// A judge of recorded motion: takes one time after the other and counts broken rules.
#include "avo/check.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "check/check_state.h"
#include "check/crowd.h"
#include "check/refuse.h"
#include "core/ranges.h"

namespace avo {

Check::Check(const std::vector<CheckedRobot>& robots, std::vector<CheckedMover> movers,
             const CheckOptions& options)
    : state_(std::make_unique<State>()) {
  judge::require_sound(options);
  for (std::size_t k = 0; k < movers.size(); ++k)
    judge::require_sound("movers." + std::to_string(k), movers[k]);
  state_->options = options;
  state_->movers = std::move(movers);
  state_->placed_before.resize(state_->movers.size());
  state_->placed.resize(state_->movers.size());
  for (const CheckedRobot& robot : robots) add_robot(robot);
}
Check::~Check() = default;
Check::Check(Check&&) noexcept = default;
Check& Check::operator=(Check&&) noexcept = default;

std::int64_t Check::add_robot(const CheckedRobot& robot) {
  const auto index = static_cast<std::int64_t>(state_->robots.size());
  if (index >= kMostRobots)
    throw Error("robots: found more than " + std::to_string(kMostRobots) +
                ", the most there can be");
  judge::require_sound("robots." + std::to_string(index), robot);
  state_->seen.emplace_back();
  state_->robots.push_back(robot);
  state_->pairs.add_robot(robot);
  return index;
}

void Check::set_walls(std::vector<CheckedWall> walls) {
  for (std::size_t k = 0; k < walls.size(); ++k)
    judge::require_sound("walls." + std::to_string(k), walls[k]);
  state_->walls.set_walls(std::move(walls));
}

void Check::place_mover(std::int64_t mover, Vec2 position, Vec2 velocity) {
  const auto count = static_cast<std::int64_t>(state_->movers.size());
  if (mover < 0 || mover >= count)
    refuse("mover", std::to_string(mover), "0 to " + std::to_string(count - 1));
  const std::string place = "movers." + std::to_string(mover);
  require(place + ".position", position, "m");
  require(place + ".velocity", velocity, "m/s");
  state_->placed[static_cast<std::size_t>(mover)] = judge::PlacedMover{position, velocity};
}

void Check::skip() {
  state_->skipped = state_->times > 0;
}

void Check::add(double time, std::span<const CheckedState> rows) {
  State& state = *state_;
  state.require_sound(time, rows);
  const bool begins = state.times == 0;
  state.duration = begins ? 0.0 : time - state.last_time;
  if (begins) state.last_time = state.report.from = time;
  state.discs.clear();
  for (const CheckedState& row : rows) state.judge_row(time, row);
  const judge::JudgedStep step{state.last_time, state.duration, state.options.relative_tolerance,
                               state.robots};
  for (const judge::MovingDisc& robot : state.discs) state.walls.judge(robot, step);
  for (std::size_t k = 0; k < state.movers.size(); ++k) {
    const CheckedMover& mover = state.movers[k];
    const auto told = [&](double t) { return judge::place_of(mover, t); };
    const judge::PlacedMover to = state.placed[k].value_or(told(time));
    const judge::PlacedMover from =
        begins && state.placed[k] ? to : state.placed_before[k].value_or(told(state.last_time));
    state.discs.push_back(judge::mover_disc(from, to, mover.radius, static_cast<std::int64_t>(k)));
    if (mover.straight && state.placed[k] && !begins)
      state.discs.back().from_velocity = state.discs.back().to_velocity =
          (to.position - from.position) / state.duration;
  }
  state.boxes.clear();
  for (std::size_t i = 0; i < state.discs.size(); ++i)
    state.boxes.push_back(judge::box_of(state.discs[i], i, state.duration));
  judge::sweep(
      state.boxes, [&state] { return state.pairs.reach(); },
      [&](std::size_t a, std::size_t b) {
        state.pairs.meet(state.discs[std::min(a, b)], state.discs[std::max(a, b)], step);
      });
  state.last_time = state.report.to = time;
  state.report.rows += static_cast<std::int64_t>(rows.size());
  state.report.steps = state.times++;
  if (std::exchange(state.skipped, false)) ++state.report.unjudged_steps;
  state.placed_before = state.placed;
}

// By robot, of the discs of robots at rest at the last time.
std::vector<std::optional<Vec2>> Check::State::places_at_rest() const {
  std::vector<std::optional<Vec2>> places(robots.size());
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const bool rests = seen[k].at == times - 1 && seen[k].row.velocity == Vec2{};
    if (rests) places[k] = judge::center_of(robots[k], seen[k].row);
  }
  return places;
}

CheckReport Check::report() const {
  const State& state = *state_;
  CheckReport report = state.report;
  double last_arrival = state.last_arrival;
  const std::vector<std::optional<Vec2>> at_rest = state.places_at_rest();
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const judge::SeenRobot& other = state.seen[i];
    if (other.at >= 0) ++report.robots;
    if (!state.robots[i].goal) continue;
    ++report.with_goal;
    // of its disc, with its present heading
    const Vec2 goal =
        *state.robots[i].goal + (at_rest[i].value_or(other.row.position) - other.row.position);
    const bool rests = !other.at_goal && judge::rests_at_crowd(i, goal, state.robots, at_rest);
    if (other.arrived || rests) ++report.arrived;
    if (other.at_goal || rests) ++report.at_goal_at_end;
    if (!other.arrived && !rests) report.not_arrived.push_back(static_cast<std::int64_t>(i));
    if (!other.arrived && rests) last_arrival = state.last_time;
  }
  if (report.with_goal > 0 && report.arrived == report.with_goal)
    report.last_arrival = last_arrival;
  state.pairs.write(report);
  state.walls.write(report);
  report.movers_at_rest = state.options.movers_at_rest;
  return report;
}

bool CheckReport::broken() const {
  const CheckCount* rules[] = {&overlaps,
                               &mover_contacts_moving,
                               &one_sided_contacts_moving,
                               &static_contacts,
                               &accelerations,
                               &speeds,
                               &jumps,
                               &headings,
                               &turns,
                               &lateral_accelerations,
                               &reversals,
                               &slow_flights,
                               &wheel_speeds,
                               &wheel_accelerations,
                               &changes};
  const bool is_run_over = mover_contacts_at_rest + one_sided_contacts_at_rest > 0;
  if (is_run_over && !movers_at_rest) return true;
  return std::any_of(std::begin(rules), std::end(rules),
                     [](const CheckCount* rule) { return rule->count > 0; });
}

}  // namespace avo
