// SPDX-License-Identifier: Apache-2.0
#include "space/senses.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "space/boxes.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

bool is_in_sight(Vec3 from, Vec3 to, std::span<const Box> boxes) {
  return std::all_of(boxes.begin(), boxes.end(),
                     [&](const Box& box) { return nearest(from, to, box).distance > box.radius; });
}

}  // namespace

SensingError declared_error(const Scenario& scenario) {
  const MeasurementNoise& noise = scenario.sensing.noise;
  // three coordinates, and their rounding
  const double most = std::sqrt(3.0) * (1.0 + 0x1p-40) * most_of_coordinate(noise);
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
  if (model.is_exact()) return senses;
  senses.depth = 1 + static_cast<std::size_t>(model.delay) + (model.misses() ? kMostCarried : 0);
  senses.past.resize(senses.depth * scenario.robots.size());
  return senses;
}

void Senses::note(std::span<const Robot> robots, std::int64_t now) {
  step = now;
  if (are_exact()) return;
  const std::size_t place = static_cast<std::size_t>(now) % depth;
  for (std::size_t k = 0; k < robots.size(); ++k)
    past[k * depth + place] = {robots[k].position, robots[k].velocity};
}

Observer::Observer(const Senses& senses, std::size_t robot, std::span<const Box> boxes)
    : senses_(senses),
      robot_(robot),
      boxes_(boxes),
      latest_(std::max(senses.step - senses.model.delay, std::int64_t{0})),
      key_(Draws::key_of(senses.seed, latest_, robot)) {}

Draws Observer::draws(std::int64_t moment, std::uint64_t other) const {
  return {moment == latest_ ? key_ : Draws::key_of(senses_.seed, moment, robot_), other};
}

// At first no measurement fails: the start is known to all.
bool Observer::succeeds(Vec3 from, Vec3 to, std::int64_t moment, std::uint64_t other) const {
  const SensingModel& model = senses_.model;
  if (!(norm_squared(to - from) <= senses_.radius * senses_.radius)) return false;
  if (model.dropped > 0.0 && moment > 0 && draws(moment, other).uniform() < model.dropped)
    return false;
  return !model.occlusion || is_in_sight(from, to, boxes_);
}

template <typename Place>
std::optional<std::int64_t> Observer::last_measured(std::uint64_t other, const Place& place) const {
  const std::int64_t oldest =
      std::max(latest_ - (senses_.model.misses() ? kMostCarried : 0), std::int64_t{0});
  for (std::int64_t moment = latest_; moment >= oldest; --moment) {
    if (succeeds(senses_.at(robot_, moment).position, place(moment), moment, other)) return moment;
  }
  return std::nullopt;
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
  const auto moment =
      last_measured(other, [&](std::int64_t m) { return senses_.at(other, m).position; });
  if (!moment) return std::nullopt;
  const PastState& seen = senses_.at(other, *moment);
  Neighbor neighbor = neighbor_of(traits);
  neighbor.position = seen.position + seconds_since(*moment) * seen.velocity;
  neighbor.velocity = seen.velocity;
  neighbor.age = static_cast<int>(latest_ - *moment);
  disturb(*moment, other, neighbor.position, neighbor.velocity);
  return neighbor;
}

std::optional<Mover> Observer::look_at(std::size_t m, const MovingObstacle& obstacle) const {
  constexpr std::uint64_t kMoverBit = std::uint64_t{1} << 63;  // no robot has such a number
  const auto at = [&](std::int64_t step) {
    return mover_at(obstacle, static_cast<double>(step) * senses_.time_step);
  };
  const std::uint64_t number = kMoverBit | m;
  const auto moment = last_measured(number, [&](std::int64_t step) { return at(step).position; });
  if (!moment) return std::nullopt;
  Mover mover = at(*moment);
  const double time = seconds_since(*moment);
  const Vec3 velocity = mover.velocity + time * mover.acceleration;
  mover.position = mover.position + (0.5 * time) * (mover.velocity + velocity);
  mover.velocity = velocity;
  mover.age = static_cast<int>(latest_ - *moment);
  disturb(*moment, number, mover.position, mover.velocity);
  return mover;
}

}  // namespace avo::space
