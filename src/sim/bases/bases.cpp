// SPDX-License-Identifier: Apache-2.0
#include "sim/bases/bases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <variant>

#include "core/draws.h"
#include "core/elementary.h"
#include "core/hash.h"
#include "robots/ahead.h"
#include "robots/execution_bounds.h"
#include "sim/scene/scene_checks.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// What tells the draws of a base from other draws of the same robot and step.
constexpr std::uint64_t kBase = 0xba5e;
constexpr std::uint64_t kStep = 0xba5e + 1;

// In [-1, 1).
double drawn(Draws& draws) {
  return 2.0 * draws.uniform() - 1.0;
}

// Within a disc of that radius: each coordinate within its square.
Vec2 drawn(Draws& draws, double radius) {
  constexpr double kHalfDiagonal = 0.70710678118654746;  // √½, rounded down
  const double x = drawn(draws), y = drawn(draws);
  return (kHalfDiagonal * radius) * Vec2{x, y};
}

// 1 - e^(-t/T'): the part of the distance to its target that a velocity covers in that time.
double approached_in(double time, double lag) {
  return lag > 0.0 ? -elementary::expm1(-time / lag) : 1.0;
}

// For a drive: parts of each cycle of its wheels' controller, in which it turns evenly.
constexpr int kSubsteps = 4;

// The controller begins a cycle when a command begins to act, and when a step ends.
int cycles_in(double time, double heading_age) {
  return static_cast<int>(std::ceil(time / heading_age));
}

// s: what the velocity approaches a target for without interruption, in such a part of a step.
double evenly_in(const ExecutionModel& model, const MotionModel& robot, double time) {
  if (!std::holds_alternative<DifferentialDrive>(robot) || !(time > 0.0)) return time;
  return time / (kSubsteps * cycles_in(time, model.heading_age));
}

}  // namespace

Vec2 Base::place() const {
  return offset > 0.0 ? position - offset * ahead_of(heading) : position;
}

Bases::Bases(const Scenario& scenario)
    : model(scenario.execution),
      declared(scenario.execution_error),
      time_step(scenario.time_step),
      seed(scenario.seed) {
  if (!model) return;
  const double latest = model->dead_time + model->dead_time_error;
  depth = static_cast<std::size_t>(std::ceil(latest / time_step)) + 2;
}

double Bases::added_radius(const RobotSetup& body) const {
  if (declared || !model) return declared.value_or(0.0);
  return bounds_of(*model, body.model, limits_of(body), time_step).position;
}

RobotSetup Bases::reference_of(const RobotSetup& body) const {
  RobotSetup reference = body;
  reference.radius += added_radius(body);
  return reference;
}

void Bases::reserve_one() {
  if (all.size() == all.capacity()) all.reserve(2 * all.size() + 8);
  sent.reserve(all.capacity() * depth);
}

void Bases::add(RobotId robot, const RobotSetup& body) {
  if (!model) return;
  sent.resize((all.size() + 1) * depth);
  Draws draws(Draws::key_of(seed, 0, robot.value), kBase);
  Base base;
  base.radius = body.radius, base.added = added_radius(body);
  base.position = disc_center(body);
  if (const auto* drive = std::get_if<DifferentialDrive>(&body.model))
    base.heading = body.heading, base.offset = drive->offset;
  base.lag = model->time_constant + drawn(draws) * model->time_constant_error;
  const double dead_time = model->dead_time + drawn(draws) * model->dead_time_error;
  base.whole_steps = static_cast<std::size_t>(dead_time / time_step);
  base.rest =
      std::clamp(dead_time - static_cast<double>(base.whole_steps) * time_step, 0.0, time_step);
  base.before = approached_in(evenly_in(*model, body.model, base.rest), base.lag);
  base.after = approached_in(evenly_in(*model, body.model, time_step - base.rest), base.lag);
  all.push_back(base);
}

void Bases::remove(std::size_t rank) {
  if (!model) return;
  const auto first = sent.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  sent.erase(first, first + static_cast<std::ptrdiff_t>(depth));
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(rank));
}

void Bases::put_down(std::size_t rank, Vec2 position) {
  if (!model) return;
  all[rank].position = position, all[rank].velocity = {};
  std::fill_n(sent.begin() + static_cast<std::ptrdiff_t>(rank * depth), depth, Vec2{});
}

SensingError body_error(const Scenario& scenario) {
  SensingError most;
  if (!scenario.execution || scenario.sensing.is_exact()) return most;
  const Bases bases(scenario);
  for (const RobotSetup& robot : scenario.robots) {
    if (is_parked(robot)) continue;
    most.position = std::max(most.position, bases.added_radius(robot));
    most.velocity =
        std::max(most.velocity,
                 bounds_of(*bases.model, robot.model, limits_of(robot), bases.time_step).velocity);
  }
  return most;
}

Scenario with_references(const Scenario& scenario) {
  Scenario result = scenario;
  if (!scenario.sensing_error && body_error(scenario) != SensingError{} &&
      certified_options(scenario).certificate != Certificate::none)
    result.sensing_error = declared_error(scenario);
  const Bases bases(scenario);
  for (RobotSetup& robot : result.robots) robot = bases.reference_of(robot);
  result.execution.reset(), result.execution_error.reset();
  return result;
}

Bases bases_of(const Scenario& scenario) {
  Bases bases(scenario);
  if (bases.are_exact()) return bases;
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) bases.add({k}, scenario.robots[k]);
  return bases;
}

namespace {

// The exact motion towards a velocity that is held.
void go_on(Vec2 target, double time, double part, Base& base) {
  const Vec2 gained = part * (target - base.velocity);
  base.position = base.position + time * target - base.lag * gained;
  base.velocity = base.lag > 0.0 ? base.velocity + gained : target;
}

// A velocity of the point ahead of the axle, which the wheels are to have.
struct Told {
  Vec2 velocity, error;  // m/s; what is executed is wrong by the error
  Vec2 misread;          // m/s, what the measured velocity is wrong by
};

// The axle turns evenly within a substep, to the third order of its length.
void turn_on(const DriveCommand& told, Vec2 error, double time, double part, Base& base) {
  const Vec2 h = ahead_of(base.heading), axle = base.place();
  const double speed = dot(h, base.velocity);
  const double turning = cross(h, base.velocity) / base.offset;
  const double target = told.speed + dot(h, error);
  const double target_turning = told.turning_rate + cross(h, error) / base.offset;
  const double gained = part * (target - speed);
  const double gained_turning = part * (target_turning - turning);
  const double turned = time * target_turning - base.lag * gained_turning;
  const double way = time * target - base.lag * gained;
  const Vec2 there = axle + way * ahead_of(base.heading + 0.5 * turned);
  base.heading = std::remainder(base.heading + turned, 2.0 * std::numbers::pi);
  const Vec2 ahead = ahead_of(base.heading);
  const double next_turning = base.lag > 0.0 ? turning + gained_turning : target_turning;
  base.position = there + base.offset * ahead;
  base.velocity = (base.lag > 0.0 ? speed + gained : target) * ahead +
                  (base.offset * next_turning) * perpendicular(ahead);
}

// The motion of a drive towards a velocity, in a part of a step.
void drive_on(const ExecutionModel& model, const DifferentialDrive& drive, const Told& told,
              double time, double part, Base& base) {
  const int cycles = cycles_in(time, model.heading_age);
  Robot body;
  body.model = drive;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    body.velocity = base.velocity + told.misread, body.heading = base.heading;
    const DriveCommand command = drive_command(model, body, told.velocity);
    for (int k = 0; k < kSubsteps; ++k)
      turn_on(command, told.error, time / (kSubsteps * cycles), part, base);
  }
}

// `after`: the reference at the end of the step. drive: none of a holonomic base.
void move_base(const Bases& bases, std::size_t step, Draws draws, const MotionState& after,
               const DifferentialDrive* drive, std::span<Vec2> sent, Base& base) {
  const ExecutionModel& model = *bases.model;
  const Vec2 position = base.position + drawn(draws, model.measured_position_error);
  const Vec2 misread = drawn(draws, model.measured_velocity_error);
  const Vec2 velocity = base.velocity + misread;
  const Vec2 error = drawn(draws, model.velocity_error);
  const Vec2 wanted = command_towards(
      model, after, position, velocity,
      still_to_come(sent, step % bases.depth, model.dead_time, bases.time_step), bases.time_step);
  // the wheels of drives are rounded at each of their cycles
  sent[step % bases.depth] = drive != nullptr ? wanted : executable(model, wanted);
  const auto acting = [&](std::size_t late) {  // nothing was sent before the first step
    return step >= late ? sent[(step - late) % bases.depth] : Vec2{};
  };
  const auto go = [&](Vec2 command, double time, double part) {
    if (!(time > 0.0)) return;
    if (drive != nullptr)
      return drive_on(model, *drive, {command, error, misread}, time, part, base);
    go_on(command + error, time, part, base);
  };
  go(acting(base.whole_steps + 1), base.rest, base.before);
  go(acting(base.whole_steps), bases.time_step - base.rest, base.after);
}

}  // namespace

void move_bases(World& world) {
  Fleet& fleet = world.fleet;
  Bases& bases = fleet.bases;
  const auto step = static_cast<std::size_t>(world.steps - 1);
  for (std::size_t rank = 0; rank < bases.all.size(); ++rank) {
    const std::uint32_t slot = fleet.slot_of[rank];
    if (fleet.is_parked(slot)) continue;
    const Draws draws(Draws::key_of(bases.seed, world.steps, fleet.id[slot].value), kStep);
    const MotionModel* own = fleet.own_model(slot);
    const auto* drive = own != nullptr ? std::get_if<DifferentialDrive>(own) : nullptr;
    Base& base = bases.all[rank];
    move_base(bases, step, draws, fleet.state(slot), drive,
              std::span(bases.sent).subspan(rank * bases.depth, bases.depth), base);
    // the wheels have to follow the next decision from where they are
    if (drive != nullptr) fleet.heading[slot] = base.heading;
  }
}

std::uint64_t hash_of(const Bases& bases, std::uint64_t hash) {
  const auto mix = [&](Vec2 value) {
    hash = mixed(mixed(hash, word_of(value.x)), word_of(value.y));
  };
  for (const Base& base : bases.all) mix(base.position), mix(base.velocity);
  for (const Vec2 command : bases.sent) mix(command);
  return hash;
}

}  // namespace avo::inline sim
