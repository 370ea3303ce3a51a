// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo/space/check.h"
#include "check/counts.h"
#include "check/crowd.h"
#include "check/space_hits.h"
#include "check/space_path.h"
#include "check/space_refuse.h"
#include "check/space_step.h"

namespace avo::space {
namespace {

using judge::Block;
using judge::Cubic;
using judge::path_of;
using judge::slows_straight;
using judge::SpaceStep;
using judge::step_of;
using judge::Stick;
using judge::weighed;

constexpr double kAtRest = 1e-9;  // of max_speed

}  // namespace

struct Check::State {
  std::vector<CheckedRobot> robots;
  std::vector<Box> boxes;
  std::vector<CheckedMover> movers;
  CheckOptions options;
  CheckReport report;
  judge::SpaceHits hits;
  std::vector<CheckedState> before, movers_before;
  std::vector<std::uint8_t> seen, arrived, touched_box;
  std::vector<CheckedState> last;                              // of each robot
  std::vector<std::pair<std::int64_t, std::int64_t>> touched;  // pairs, ascending
  double time = 0.0;
  bool has_time = false;

  void judge_limits(const CheckedState& from, const CheckedState& to, double start,
                    double duration);
  void judge_row(const CheckedState& row, double now);
  void judge_pairs(const std::vector<SpaceStep>& steps, double start);
  void judge_pair(const SpaceStep& a, const SpaceStep& b, double start);
  void judge_boxes(const SpaceStep& step, double start);
  [[nodiscard]] bool is_at_goal(Vec3 position, Vec3 goal) const;
  void judge_movers(const std::vector<SpaceStep>& steps, std::span<const CheckedState> now,
                    double start, double duration);
};

void Check::State::judge_row(const CheckedState& row, double now) {
  const auto k = static_cast<std::size_t>(row.robot);
  const CheckedRobot& robot = robots[k];
  const double tolerance = 1.0 + options.relative_tolerance;
  const double speed = weighed(row.velocity, robot.vertical);
  report.largest_speed = std::max(report.largest_speed, norm(row.velocity));
  const double over =
      std::max({speed - robot.max_speed * tolerance, row.velocity.z - robot.climb * tolerance,
                -row.velocity.z - robot.sink * tolerance});
  if (over > 0.0) judge::count(report.speeds, {now, row.robot, {}, over});
  if (!seen[k]) ++report.robots;
  seen[k] = 1;
  last[k] = row;
  if (!robot.goal || arrived[k] != 0) return;
  if (!is_at_goal(row.position, *robot.goal)) return;
  arrived[k] = 1;
  ++report.arrived;
  report.last_arrival = now;
}

bool Check::State::is_at_goal(Vec3 position, Vec3 goal) const {
  return norm(position - goal) <= options.arrival_distance &&
         std::none_of(boxes.begin(), boxes.end(),
                      [&](const Box& box) { return judge::hides(box, position, goal); });
}

// The velocity of a step may change by a_max Δt, or be cut short straight by b Δt.
void Check::State::judge_limits(const CheckedState& from, const CheckedState& to, double start,
                                double duration) {
  const CheckedRobot& robot = robots[static_cast<std::size_t>(from.robot)];
  const Vec3 change = to.velocity - from.velocity;
  const double tolerance = 1.0 + options.relative_tolerance;
  const double acceleration = weighed(change, robot.vertical) / duration;
  report.largest_acceleration = std::max(report.largest_acceleration, norm(change) / duration);
  double allowed = robot.max_acceleration;
  const double braking = robot.max_braking.value_or(robot.max_acceleration);
  if (braking > allowed && slows_straight(from.velocity, to.velocity)) allowed = braking;
  // rounding of the two velocities
  const double rounding = 4e-16 * (norm(from.velocity) + norm(to.velocity)) / duration;
  const double over = acceleration - allowed * tolerance - rounding;
  if (over > 0.0) judge::count(report.accelerations, {start, from.robot, {}, over});
  const Vec3 off = to.position - from.position - 0.5 * duration * (from.velocity + to.velocity);
  const double most = 0.5 * allowed * std::max(robot.vertical, 1.0) * duration * duration;
  const double places = 1e-15 * (norm(from.position) + norm(to.position));
  if (norm(off) > most * tolerance + places)
    judge::count(report.jumps, {start, from.robot, {}, norm(off) - most});
}

void Check::State::judge_pair(const SpaceStep& a, const SpaceStep& b, double start) {
  const CheckedRobot &first = robots[a.robot], &second = robots[b.robot];
  const double contact = first.radius + second.radius;
  const double room = report.least_clearance.value_or(std::numeric_limits<double>::infinity());
  const double wash = std::max(first.downwash, second.downwash);
  if (gap(a, b) - wash > contact + std::max(room, 0.0)) return;
  Cubic relative;
  for (std::size_t i = 0; i < 4; ++i) relative[i] = a.path[i] - b.path[i];
  // b may not be below a: p_a - p_b is not on the stick from -w_b to w_a
  const Stick stick{-second.downwash, first.downwash};
  const double clearance =
      judge::least_distance(relative, stick, contact + std::max(room, 0.0)) - contact;
  report.least_clearance = std::min(room, clearance);
  if (!(clearance < -options.relative_tolerance * contact)) return;
  const auto one = static_cast<std::int64_t>(std::min(a.robot, b.robot));
  const auto other = static_cast<std::int64_t>(std::max(a.robot, b.robot));
  judge::note(report.overlaps, {start, one, other, -clearance});
  const std::pair pair{one, other};
  const auto place = std::lower_bound(touched.begin(), touched.end(), pair);
  if (place != touched.end() && *place == pair) return;
  touched.insert(place, pair);
  ++report.overlaps.count;
}

// Steps that overlap along x, in order of their low ends.
void Check::State::judge_pairs(const std::vector<SpaceStep>& steps, double start) {
  std::vector<const SpaceStep*> order;
  order.reserve(steps.size());
  for (const SpaceStep& step : steps) order.push_back(&step);
  std::sort(order.begin(), order.end(), [](const SpaceStep* a, const SpaceStep* b) {
    return a->low.x != b->low.x ? a->low.x < b->low.x : a->robot < b->robot;
  });
  double largest = 0.0;
  for (const CheckedRobot& robot : robots) largest = std::max(largest, robot.radius);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const double room = report.least_clearance.value_or(std::numeric_limits<double>::infinity());
      if (order[j]->low.x - order[i]->high.x > 2.0 * largest + std::max(room, 0.0)) break;
      judge_pair(*order[i], *order[j], start);
    }
  }
}

void Check::State::judge_boxes(const SpaceStep& step, double start) {
  const double radius = robots[step.robot].radius;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Box& box = boxes[k];
    const Cubic path = judge::in_frame_of(box, step.path);
    const double contact = radius + box.radius;
    const double room =
        report.least_static_clearance.value_or(std::numeric_limits<double>::infinity());
    const double clearance =
        judge::least_distance(path, Block{box.min, box.max}, contact + std::max(room, 0.0)) -
        contact;
    report.least_static_clearance = std::min(room, clearance);
    if (!(clearance < -options.relative_tolerance * contact)) continue;
    judge::note(report.static_contacts, {start, static_cast<std::int64_t>(step.robot),
                                         static_cast<std::int64_t>(k), -clearance});
    if (touched_box[step.robot] == 0) ++report.static_contacts.count;
    touched_box[step.robot] = 1;
  }
}

void Check::State::judge_movers(const std::vector<SpaceStep>& steps,
                                std::span<const CheckedState> now, double start, double duration) {
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const CheckedState& from = movers_before[k];
    const SpaceStep other =
        step_of(static_cast<std::size_t>(from.robot),
                movers[k].straight ? judge::straight_path(from.position, now[k].position)
                                   : path_of(from, now[k], duration));
    for (const SpaceStep& step : steps) {
      const CheckedRobot& robot = robots[step.robot];
      const double radii = robot.radius + movers[k].radius;
      if (gap(step, other) > radii) continue;
      Cubic relative;
      for (std::size_t i = 0; i < 4; ++i) relative[i] = step.path[i] - other.path[i];
      const bool has_limit = std::isfinite(robot.max_speed);
      hits.meet({.robot = static_cast<std::int64_t>(step.robot),
                 .other = from.robot,
                 .start = start,
                 .duration = duration,
                 .contact = radii * (1.0 - options.relative_tolerance),
                 .at_rest = kAtRest * (has_limit ? robot.max_speed : 1.0)},
                step.path, relative);
    }
  }
}

Check::Check(std::vector<CheckedRobot> robots, std::vector<Box> boxes, const CheckOptions& options,
             std::vector<CheckedMover> movers)
    : state_(std::make_unique<State>()) {
  for (std::size_t k = 0; k < robots.size(); ++k) {
    judge::require_sound(robots[k], k);
    if (robots[k].goal) ++state_->report.with_goal;
  }
  for (std::size_t k = 0; k < boxes.size(); ++k) judge::require_sound(boxes[k], k);
  for (std::size_t k = 0; k < movers.size(); ++k) judge::require_sound(movers[k], k);
  if (!(options.relative_tolerance >= 0.0 && options.relative_tolerance < 1.0))
    throw Error("relative_tolerance: must be >= 0 and < 1");
  state_->robots = std::move(robots);
  state_->boxes = std::move(boxes);
  state_->movers = std::move(movers);
  state_->options = options;
  const std::size_t count = state_->robots.size();
  state_->seen.resize(count);
  state_->arrived.resize(count);
  state_->touched_box.resize(count);
  state_->last.resize(count);
}
Check::~Check() = default;
Check::Check(Check&&) noexcept = default;
Check& Check::operator=(Check&&) noexcept = default;

void Check::add(double time, std::span<const CheckedState> rows,
                std::span<const CheckedState> movers) {
  State& state = *state_;
  CheckReport& report = state.report;
  if (state.has_time && !(time >= state.time + 1e-12))
    throw Error("time " + std::to_string(time) + " s: must be later than the one before");
  judge::require_all(state.movers.size(), movers);
  std::int64_t previous = -1;
  for (const CheckedState& row : rows) {
    const bool is_known =
        row.robot > previous && row.robot < static_cast<std::int64_t>(state.robots.size());
    if (!is_known) throw Error("robot " + std::to_string(row.robot) + ": out of order or unknown");
    if (!is_finite(row.position) || !is_finite(row.velocity))
      throw RowError(row.robot, "a number that is not finite");
    previous = row.robot;
  }
  std::vector<SpaceStep> steps;
  const double duration = time - state.time;
  auto from = state.before.cbegin();
  for (const CheckedState& row : rows) {
    state.judge_row(row, time);
    ++report.rows;
    while (from != state.before.cend() && from->robot < row.robot) ++from;
    if (!state.has_time || from == state.before.cend() || from->robot != row.robot) continue;
    state.judge_limits(*from, row, state.time, duration);
    steps.push_back(step_of(static_cast<std::size_t>(row.robot), path_of(*from, row, duration)));
  }
  report.robot_steps += static_cast<std::int64_t>(steps.size());
  if (state.has_time) {
    ++report.steps;
    state.judge_pairs(steps, state.time);
    for (const SpaceStep& step : steps) state.judge_boxes(step, state.time);
    state.judge_movers(steps, movers, state.time, duration);
  } else {
    report.from = time;
  }
  report.to = state.time = time;
  state.has_time = true;
  state.before.assign(rows.begin(), rows.end());
  state.movers_before.assign(movers.begin(), movers.end());
}

void Check::set_movers(std::vector<CheckedMover> movers, std::span<const CheckedState> states) {
  for (std::size_t k = 0; k < movers.size(); ++k) judge::require_sound(movers[k], k);
  judge::require_all(movers.size(), states);
  state_->movers = std::move(movers);
  state_->movers_before.assign(states.begin(), states.end());
}

void Check::skip() {
  if (!state_->has_time) return;
  state_->before.clear();
  ++state_->report.unjudged_steps;
}

CheckReport Check::report() const {
  CheckReport report = state_->report;
  state_->hits.write(report);
  report.movers_at_rest = state_->options.movers_at_rest;
  const auto at_rest = judge::places_at_rest(state_->robots.size(), state_->before);
  std::vector<std::uint8_t> at_goal(state_->robots.size());
  for (std::size_t k = 0; k < state_->robots.size(); ++k) {
    const CheckedRobot& robot = state_->robots[k];
    if (!robot.goal || state_->seen[k] == 0) continue;
    at_goal[k] = state_->is_at_goal(state_->last[k].position, *robot.goal) ? 1 : 0;
  }
  const auto at_crowd = judge::rest_at_crowds(state_->robots, at_rest, at_goal);
  for (std::size_t k = 0; k < state_->robots.size(); ++k) {
    if (!state_->robots[k].goal || state_->seen[k] == 0) continue;
    const bool rests = at_crowd[k] != 0;
    if (at_goal[k] != 0 || rests) ++report.at_goal_at_end;
    if (state_->arrived[k] != 0) continue;
    if (!rests) report.not_arrived.push_back(static_cast<std::int64_t>(k));
    if (rests) ++report.arrived, report.last_arrival = state_->time;
  }
  if (report.arrived < report.with_goal) report.last_arrival.reset();
  return report;
}

}  // namespace avo::space
