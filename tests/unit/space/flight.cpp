// SPDX-License-Identifier: Apache-2.0
#include "unit/space/flight.h"

#include <algorithm>
#include <cmath>

namespace avo::space::tests {
namespace {

constexpr Vec3 kUp = {0.0, 0.0, 1.0};
constexpr double kMotorLag = 0.2;  // of the pole
constexpr int kGustTicks = 300;

Vec3 clipped(Vec3 a, double most) {
  const double length = norm(a);
  return length > most ? (most / length) * a : a;
}

// Turned about an axis of that length, rad.
Vec3 rotated(Vec3 a, Vec3 by) {
  const double angle = norm(by);
  if (!(angle > 0.0)) return a;
  const Vec3 n = by / angle;
  const Vec3 turned = std::cos(angle) * a + std::sin(angle) * cross(n, a) +
                      ((1.0 - std::cos(angle)) * dot(n, a)) * n;
  return turned / norm(turned);
}

}  // namespace

Flight::Flight(const Airframe& airframe, Vec3 position, std::uint64_t seed)
    : airframe_(airframe),
      pole_(0.5 * airframe.quadrotor.attitude_time),
      least_(airframe.quadrotor.min_thrust.value_or(0.1 * kGravity * airframe.quadrotor.mass) /
             airframe.quadrotor.mass),
      most_(airframe.quadrotor.max_thrust / airframe.quadrotor.mass),
      draws_(seed),
      position_(position),
      thrust_(kGravity) {}

Vec3 Flight::wanted_force(const SetPoint& set_point) const {
  const double pole = airframe_.feedback / airframe_.quadrotor.attitude_time;
  Vec3 force = set_point.acceleration + (pole * pole) * (set_point.position - position_) +
               (2.0 * pole) * (set_point.velocity - velocity_) + kGravity * kUp;
  force = (std::clamp(norm(force), least_, most_) / norm(force)) * force;
  const double across = std::hypot(force.x, force.y);
  const double widest = std::max(force.z, 0.0) * std::tan(airframe_.quadrotor.max_tilt);
  if (across > widest) force = {force.x * widest / across, force.y * widest / across, force.z};
  return force;
}

void Flight::turn(Vec3 direction) {
  const Vec3 normal = cross(axis_, direction);
  const double sine = norm(normal);
  Vec3 torque = (-2.0 / pole_) * turning_;
  if (sine > 1e-12)
    torque = torque + (std::atan2(sine, dot(axis_, direction)) / (sine * pole_ * pole_)) * normal;
  torque = clipped(torque, airframe_.largest_turn / (pole_ * pole_));
  torque_ = torque_ + (kTick / (kMotorLag * pole_)) * (torque - torque_);
  turning_ = turning_ + kTick * torque_;
  turning_ = turning_ - dot(turning_, axis_) * axis_;
  axis_ = rotated(axis_, kTick * turning_);
}

double Flight::wanted_thrust(Vec3 force) const {
  double thrust = norm(force);
  if (airframe_.law == ThrustLaw::projected) thrust = dot(force, axis_);
  if (airframe_.law == ThrustLaw::vertical) thrust = force.z / std::max(axis_.z, 0.3);
  return std::clamp(thrust, least_, most_);
}

void Flight::tick(const SetPoint& set_point) {
  const Vec3 force = wanted_force(set_point);
  turn(force / norm(force));
  thrust_ += (kTick / (kMotorLag * pole_)) * (wanted_thrust(force) - thrust_);
  if (ticks_++ % kGustTicks == 0) gust_ = draws_.within(airframe_.gust);
  const Vec3 acceleration = thrust_ * axis_ - kGravity * kUp + gust_;
  position_ = position_ + kTick * velocity_ + (0.5 * kTick * kTick) * acceleration;
  velocity_ = velocity_ + kTick * acceleration;
}

}  // namespace avo::space::tests
