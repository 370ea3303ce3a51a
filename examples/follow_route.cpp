// SPDX-License-Identifier: Apache-2.0
// The loop of a robot whose global planner is somebody else's, as with Nav2: a route comes as
// points, the robot follows it within 15 cm, gives way to a person, and ends in the heading of its
// dock.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

// Stands for a differential drive and its odometry: the point that is led, ahead of the axle.
struct Base {
  avo::DifferentialDrive drive{
      .track = 0.4, .offset = 0.2, .wheel_speed = 1.2, .wheel_acceleration = 2};
  avo::Vec2 axle = {};
  double heading = 0.0, speed = 0.0, turning = 0.0;  // rad, m/s, rad/s

  avo::Vec2 ahead() const { return {std::cos(heading), std::sin(heading)}; }
  avo::Robot self() const {
    const avo::Vec2 left = avo::perpendicular(ahead());
    return {.position = axle + drive.offset * ahead(),
            .velocity = speed * ahead() + drive.offset * turning * left,
            .radius = 0.4,
            .max_acceleration = 1.0,
            .max_speed = 1.0,
            .model = drive,
            .heading = heading};
  }
  void hold(avo::Vec2 a, double time) {  // as docs/on_board.md says, in cycles of 1 ms
    for (int k = 0; k < static_cast<int>(1000.0 * time); ++k) {
      const avo::Vec2 left = avo::perpendicular(ahead());
      const double faster = avo::dot(ahead(), a) + drive.offset * turning * turning;
      const double turn = (avo::dot(left, a) - speed * turning) / drive.offset;
      axle = axle + 1e-3 * speed * ahead();
      heading += 1e-3 * turning, speed += 1e-3 * faster, turning += 1e-3 * turn;
    }
  }
};

}  // namespace

int main() {
  const std::vector<avo::Vec2> route{{0.2, 0}, {6, 0}, {6, 5}, {12, 5}};
  const double dock = 1.5707963267948966;  // rad
  avo::NavigatorOptions options;
  options.route_tolerance = 0.15;     // m
  options.xy_goal_tolerance = 0.1;    // m
  options.yaw_goal_tolerance = 0.15;  // rad
  avo::Navigator navigator(options);
  navigator.set_route(route, dock);
  Base base;
  avo::Neighbor person{.position = {8, 16}, .velocity = {0, -0.8}, .radius = 0.3};
  person.behavior = avo::Behavior::moves_on;
  double time = 0.0, nearest = 100.0;
  avo::NavigatorDecision decision;
  for (; decision.status != avo::NavigatorStatus::reached && time < 90.0; time += 0.1) {
    const std::vector<avo::Neighbor> seen{person};
    decision = navigator.step(base.self(), seen, time);
    if (decision.status == avo::NavigatorStatus::stuck)
      std::puts(navigator.explain(base.self(), seen).sentence.c_str());
    base.hold(decision.plan.acceleration, 0.1);
    person.position = person.position + 0.1 * person.velocity;
    nearest = std::min(nearest, avo::norm(base.self().position - person.position) - 0.7);
  }
  const double off = avo::norm(base.axle - route.back()), turned = std::abs(base.heading - dock);
  std::printf("docked after %.1f s, %.0f cm off and %.2f rad turned off, person passed at %.2f m\n",
              time, 100.0 * off, turned, nearest);
  const bool has_docked = decision.status == avo::NavigatorStatus::reached && off < 0.1;
  return has_docked && turned < options.yaw_goal_tolerance && nearest > 0.0 ? 0 : 1;
}
