// SPDX-License-Identifier: Apache-2.0
// The loop of two robots with sluggish bases, as with Nav2: cmd_vel arrives 60 ms late, the wheels
// follow it with a lag of 80 ms, turn in steps of 1 cm/s, and not below 3 cm/s. The robots change
// places. Each one senses where the body of the other one is.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <vector>

#include <avo/avo.h>

namespace {

constexpr double kStep = 0.1, kCycle = 0.01;  // s: of decisions, and of the wheels' controller
const avo::ExecutionModel kModel{.time_constant = 0.08,
                                 .dead_time = 0.06,
                                 .deadband = 0.03,
                                 .quantum = 0.01,
                                 .heading_age = kCycle};
const avo::DifferentialDrive kDrive{
    .track = 0.4, .offset = 0.2, .wheel_speed = 0.9, .wheel_acceleration = 2.0};

// Stands for the base and its odometry.
struct Base {
  avo::Vec2 axle;
  double heading, speed = 0.0, turning = 0.0;             // rad, m/s, rad/s
  std::deque<avo::Vec2> sent = std::deque<avo::Vec2>(6);  // m/s, on their way: one each cycle

  avo::Vec2 ahead() const { return {std::cos(heading), std::sin(heading)}; }
  avo::Robot body() const {
    return {.position = axle + kDrive.offset * ahead(),
            .velocity = speed * ahead() + kDrive.offset * turning * avo::perpendicular(ahead()),
            .radius = 0.4,
            .max_acceleration = 0.5,
            .max_speed = 0.5,
            .model = kDrive,
            .heading = heading};
  }
  void cycle(avo::Vec2 command) {
    sent.push_back(command);
    const avo::DriveCommand told = avo::drive_command(kModel, body(), sent.front());
    sent.pop_front();
    constexpr int kParts = 10;
    for (int k = 0; k < kParts; ++k) {
      const double time = kCycle / kParts, part = time / kModel.time_constant;
      axle = axle + time * speed * ahead();
      heading += time * turning;
      speed += part * (told.speed - speed), turning += part * (told.turning_rate - turning);
    }
  }
};

}  // namespace

int main() {
  std::array<Base, 2> bases{{{{0, 0}, 0.0}, {{8, 0.2}, 3.0}}};
  const avo::ExecutionError most = avo::execution_error(kModel, bases[0].body(), kStep);
  avo::NavigatorOptions options;
  options.execution = kModel;
  options.planner.sensing_error = {most.position, most.velocity};  // and what your sensors add
  std::vector<avo::Navigator> navigators;
  for (const avo::Vec2 goal : {avo::Vec2{8, 0.2}, avo::Vec2{0, 0}}) {
    navigators.emplace_back(options);
    navigators.back().set_goal(goal);
    ++options.id.value;
  }
  double time = 0.0, farthest = 0.0, nearest = 100.0;
  int arrived = 0;
  bool has_left = false;
  for (; arrived < 2 && time < 90.0; time += kStep) {
    std::array<avo::NavigatorDecision, 2> decisions;
    arrived = 0;
    for (std::size_t k = 0; k < 2; ++k) {
      const avo::Robot other = bases[1 - k].body();
      const std::vector<avo::Neighbor> seen{{.position = other.position,
                                             .velocity = other.velocity,
                                             .radius = other.radius + most.position,
                                             .max_acceleration = other.max_acceleration}};
      decisions[k] = navigators[k].step(bases[k].body(), seen, time);
      farthest = std::max(farthest, decisions[k].command->deviation);
      has_left = has_left || decisions[k].command->has_left;
      if (decisions[k].status == avo::NavigatorStatus::reached) ++arrived;
    }
    for (int cycle = 0; cycle < 10; ++cycle) {
      for (std::size_t k = 0; k < 2; ++k) bases[k].cycle(decisions[k].command->velocity);
      const double apart = avo::norm(bases[0].body().position - bases[1].body().position);
      nearest = std::min(nearest, apart - 0.8);
    }
  }
  std::printf("%d of 2 arrived after %.1f s, passed at %.2f m, at most %.1f of %.1f mm off%s\n",
              arrived, time, nearest, 1000.0 * farthest, 1000.0 * most.position,
              has_left ? ", a base has left its reference" : "");
  return arrived == 2 && nearest > 0.0 && farthest <= most.position && !has_left ? 0 : 1;
}
