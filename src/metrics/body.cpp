// SPDX-License-Identifier: Apache-2.0
#include "metrics/body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/plane.h"

namespace avo::inline metrics {

namespace {

// The cubic of such a small part of a step has a 65536th of the error of the cubic of the whole
// step.
constexpr int kParts = 16;

// m: an upper bound of the distance of the cubic of the whole step from the arc.
double off_arc(const Body& body) {
  return body.arc ? body.arc->path.length * std::abs(body.arc->path.turn) : 0.0;
}

StepPath path_in(const Body& body, int part, double step) {
  constexpr double kShare = 1.0 / kParts;
  const double from = part * kShare, to = (part + 1) * kShare;
  if (body.arc) return hermite_path(part_of(*body.arc, from, to), kShare * step);
  return part_of(body.path, from, to);
}

}  // namespace

judge::Instant separation_of(const Body& a, const Body& b, double step, double cutoff) {
  const double off = off_arc(a) + off_arc(b);
  const judge::Instant roughly = separation(a.path, b.path, cutoff + off);
  if (off == 0.0 || roughly.distance > cutoff + off) return roughly;
  judge::Instant least{0.0, std::numeric_limits<double>::infinity()};
  for (int part = 0; part < kParts; ++part) {
    const judge::Instant own = separation(path_in(a, part, step), path_in(b, part, step),
                                          std::min(cutoff, least.distance));
    if (own.distance < least.distance) least = {(part + own.fraction) / kParts, own.distance};
  }
  return least;
}

// Ids ascend in both.
void collect_rows(const FleetView& fleet, const LastSeen& last, std::vector<BodyRow>& rows) {
  rows.clear();
  std::size_t j = 0;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    while (j < last.robots.size() && last.robots[j].id.value < fleet.id[i].value) ++j;
    if (j == last.robots.size() || !(last.robots[j].id == fleet.id[i])) continue;
    const int discs = std::max(footprint_of(fleet.setup[i].model).discs, 1);
    for (int disc = 0; disc < discs; ++disc) rows.push_back({i, j, disc});
  }
}

namespace {

// m/s, of a point that is so far ahead of the disc that others sense, by the turn of the heading.
Vec2 swing_of(const MotionModel& model, Vec2 velocity, double heading, double ahead) {
  const auto* drive = std::get_if<DifferentialDrive>(&model);
  if (drive == nullptr || ahead == 0.0) return {};
  const Vec2 left = perpendicular(elementary::direction(heading));
  return (ahead * dot(left, velocity) / drive->offset) * left;
}

}  // namespace

Body body_of(const FleetView& fleet, const BodyStep& step, BodyRow row) {
  const auto [i, j, disc] = row;
  const LastSeen::LastRobot& last = step.last.robots[j];
  Body body;
  body.name = fleet.id[i].value;
  body.setup = &fleet.setup[i];
  const MotionModel& model = fleet.setup[i].model;
  const Footprint footprint = footprint_of(model);
  const double ahead = footprint ? footprint.ahead(disc) : 0.0;
  body.radius = footprint ? footprint.radius : disc_radius(fleet.setup[i]);
  body.velocity = last.velocity;
  const auto center = [&](Vec2 position, double heading) {
    if (is_holonomic(model)) return position;
    const Vec2 sensed = disc_center(model, position, heading);
    return ahead == 0.0 ? sensed : sensed + ahead * elementary::direction(heading);
  };
  body.position = center(last.position, last.heading);
  const Vec2 next = center(fleet.position[i], fleet.heading[i]);
  body.w = fleet.plan[i].new_velocity - body.velocity;
  const Method method = fleet.setup[i].method.value_or(step.method);
  const bool is_disc = step.moves && is_holonomic(model);
  body.exact = is_disc && method == step.method;
  const Vec2 start = adopts_at_once(method) && is_disc ? fleet.velocity[i] : body.velocity;
  if (!step.moves) {
    body.path.control.fill(body.position);
  } else if (!moves_along_heading(model)) {
    body.path = hermite_path(
        body.position, start + swing_of(model, start, last.heading, ahead), next,
        fleet.velocity[i] + swing_of(model, fleet.velocity[i], fleet.heading[i], ahead),
        step.duration);
  } else {
    const double turn = wrapped(fleet.heading[i] - last.heading);
    const double speed = norm(body.velocity), next_speed = norm(fleet.velocity[i]);
    const bool in_place = speed == 0.0 && next_speed == 0.0;  // its disc starts at rest
    body.arc = {arc_path(body.position, next, turn), speed, in_place ? 1.0 : next_speed};
    body.path = hermite_path(*body.arc, step.duration);
  }
  return body;
}

Sweep sweep_of(const FleetView& fleet, const BodyStep& step, BodyRow row) {
  const RobotSetup& setup = fleet.setup[row.now];
  if (!is_holonomic(setup.model)) {
    const Body body = body_of(fleet, step, row);
    return {body.path, body.radius, body.arc.has_value()};
  }
  const LastSeen::LastRobot& last = step.last.robots[row.before];
  const Vec2 position = last.position;
  if (!step.moves) return {{{position, position, position, position}}, setup.radius, false};
  const bool at_once = adopts_at_once(setup.method.value_or(step.method));
  const Vec2 next_velocity = fleet.velocity[row.now];
  const Vec2 velocity = at_once ? next_velocity : last.velocity;
  return {hermite_path(position, velocity, fleet.position[row.now], next_velocity, step.duration),
          setup.radius, false};
}

void collect_robots(const FleetView& fleet, const BodyStep& step, std::span<const BodyRow> rows,
                    std::vector<Body>& robots) {
  robots.clear();
  for (const BodyRow row : rows) robots.push_back(body_of(fleet, step, row));
}

void collect_movers(const MovingObstacleView& now, const BodyStep& step,
                    std::vector<Body>& obstacles) {
  const LastSeen& last = step.last;
  obstacles.clear();
  auto before = last.movers.begin();  // ids ascend in both
  for (std::size_t k = 0; k < now.setup.size(); ++k) {
    const std::uint64_t id = now.id[k].value;
    while (before != last.movers.end() && before->id < id) ++before;
    if (before == last.movers.end()) break;
    if (before->id != id) continue;  // it has just come
    Body body;
    body.name = id;
    body.radius = now.setup[k].radius;
    body.position = before->position;
    body.velocity = before->velocity;
    const bool is_straight = !now.setup[k].trajectory.empty();
    body.exact = step.moves && now.setup[k].acceleration == Vec2{} && now.setup[k].path.empty();
    Vec2 end_velocity = now.velocity[k];
    if (is_straight && step.moves)
      body.velocity = end_velocity = (now.position[k] - body.position) / step.duration;
    body.path =
        hermite_path(body.position, body.velocity, now.position[k], end_velocity, step.duration);
    if (!step.moves) body.path.control.fill(body.position);
    obstacles.push_back(body);
  }
}

}  // namespace avo::inline metrics
