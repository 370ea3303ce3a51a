// SPDX-License-Identifier: Apache-2.0
#include "space/senses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "space/boxes.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

MeasurementNoise as_measured(const LocalizationNoise& model) {
  return {model.position, 0.0, model.distribution, model.truncated};
}

// Of three coordinates, and their rounding, in units of the scene's value.
double most_of_three(const MeasurementNoise& noise) {
  return std::sqrt(3.0) * (1.0 + 0x1p-40) * most_of_coordinate(noise);
}

}  // namespace

double most_lost(const LocalizationNoise& model) {
  return most_of_three(as_measured(model)) * model.position;
}

Vec3 Senses::own_error(std::size_t robot) const {
  if (know_places()) return {};
  Draws numbers(Draws::key_of(seed, step, robot), robot);
  const auto drawn = noise<3>(as_measured(model.localization), numbers);
  return model.localization.position * Vec3{drawn[0], drawn[1], drawn[2]};
}

SensingError declared_error(const Scenario& scenario) {
  const MeasurementNoise& noise = scenario.sensing.noise;
  const double most = most_of_three(noise);
  SensingError error{most * noise.position, most * noise.velocity};
  if (scenario.sensing.delay == 0) return error;
  double change = 0.0;  // m/s^2
  for (const RobotSetup& robot : scenario.robots)
    change = std::max(change, top_acceleration(robot_of(robot)));
  for (const MovingObstacle& obstacle : scenario.moving_obstacles)
    change = std::max(change, obstacle.max_deviation);
  const double time = scenario.sensing.delay * scenario.time_step;
  error.position += time * error.velocity + 0.5 * change * time * time;
  error.velocity += change * time;
  return error;
}

double time_unseen(const Scenario& scenario) {
  const SensingModel& model = scenario.sensing;
  return (model.delay + (model.dropped > 0.0 ? kMostCarried : 0)) * scenario.time_step;
}

Senses senses_of(const Scenario& scenario) {
  const SensingModel& model = scenario.sensing;
  Senses senses{.model = model,
                .seed = scenario.seed,
                .time_step = scenario.time_step,
                .radius = sensing_radius_of(scenario)};
  SensingModel of_others = model;
  of_others.localization = {};
  if (!of_others.is_exact())
    senses.robots.depth = senses.movers.depth =
        1 + static_cast<std::size_t>(model.delay) + (model.misses() ? kMostCarried : 0);
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) senses.robots.add(0);
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k) senses.movers.add(0);
  return senses;
}

void PastStates::add(std::int64_t step) {
  states.resize(states.size() + depth);
  since.push_back(step);
}

void PastStates::remove(std::size_t k) {
  const auto first = states.begin() + static_cast<std::ptrdiff_t>(k * depth);
  states.erase(first, first + static_cast<std::ptrdiff_t>(depth));
  since.erase(since.begin() + static_cast<std::ptrdiff_t>(k));
}

void Senses::note(std::span<const Robot> now, std::span<const Mover> movers_now,
                  std::int64_t present) {
  step = present;
  if (are_exact()) return;
  robots.note(now, present);
  movers.note(movers_now, present);
}

Observer::Observer(const Senses& senses, std::size_t robot, std::span<const Box> boxes,
                   const Solids& solids)
    : senses_(senses),
      robot_(robot),
      boxes_(boxes),
      solids_(solids),
      latest_(std::max(senses.step - senses.model.delay, std::int64_t{0})),
      key_(Draws::key_of(senses.seed, latest_, robot)) {}

Draws Observer::draws(std::int64_t moment, std::uint64_t other) const {
  return {moment == latest_ ? key_ : Draws::key_of(senses_.seed, moment, robot_), other};
}

// At first no measurement fails: the start is known to all.
bool Observer::succeeds(Vec3 from, Vec3 to, std::int64_t moment, std::int64_t first,
                        std::uint64_t other) const {
  const SensingModel& model = senses_.model;
  if (!(norm_squared(to - from) <= senses_.radius * senses_.radius)) return false;
  if (model.dropped > 0.0 && moment > first && draws(moment, other).uniform() < model.dropped)
    return false;
  return !model.occlusion || solids_.are_apart(from, to, boxes_);
}

std::optional<std::int64_t> Observer::last_measured(const PastStates& bodies, std::size_t k,
                                                    std::uint64_t other) const {
  const std::int64_t first = bodies.since[k], carried = senses_.model.misses() ? kMostCarried : 0;
  for (std::int64_t moment = std::max(latest_, first); moment >= std::max(latest_ - carried, first);
       --moment) {
    const Vec3 from = senses_.robots.at(robot_, moment).position;
    if (succeeds(from, bodies.at(k, moment).position, moment, first, other)) return moment;
  }
  return std::nullopt;
}

int Observer::age(std::int64_t moment, std::int64_t since) const {
  return static_cast<int>(std::max(latest_, since) - moment);
}

double Observer::seconds_since(std::int64_t moment) const {
  return static_cast<double>(senses_.step - moment) * senses_.time_step;
}

void Observer::disturb(std::int64_t moment, std::uint64_t other, Vec3& position,
                       Vec3& velocity) const {
  const MeasurementNoise& off = senses_.model.noise;
  if (!(off.position > 0.0 || off.velocity > 0.0)) return;
  Draws numbers = draws(moment, other);
  numbers.uniform();  // the draw that decided whether it is missed
  const auto drawn = noise<6>(off, numbers);
  const Vec3 of_velocity = off.velocity * Vec3{drawn[3], drawn[4], drawn[5]};
  position = position + off.position * Vec3{drawn[0], drawn[1], drawn[2]} +
             seconds_since(moment) * of_velocity;
  velocity = velocity + of_velocity;
}

std::optional<Neighbor> Observer::look_at(std::size_t other, const Robot& traits) const {
  const auto moment = last_measured(senses_.robots, other, other);
  if (!moment) return std::nullopt;
  const PastState& seen = senses_.robots.at(other, *moment);
  Neighbor neighbor = neighbor_of(traits);
  neighbor.position = seen.position + seconds_since(*moment) * seen.velocity;
  neighbor.velocity = seen.velocity;
  neighbor.age = age(*moment, senses_.robots.since[other]);
  disturb(*moment, other, neighbor.position, neighbor.velocity);
  return neighbor;
}

std::optional<Mover> Observer::look_at(std::size_t m, MovingObstacleId id, const Mover& now) const {
  constexpr std::uint64_t kMoverBit = std::uint64_t{1} << 63;  // no robot has such a number
  const std::uint64_t number = kMoverBit | id.value;
  const auto moment = last_measured(senses_.movers, m, number);
  if (!moment) return std::nullopt;
  const PastState& seen = senses_.movers.at(m, *moment);
  Mover mover = now;
  const double time = seconds_since(*moment);
  mover.velocity = seen.velocity + time * mover.acceleration;
  mover.position = seen.position + (0.5 * time) * (seen.velocity + mover.velocity);
  mover.age = age(*moment, senses_.movers.since[m]);
  disturb(*moment, number, mover.position, mover.velocity);
  return mover;
}

}  // namespace avo::space
