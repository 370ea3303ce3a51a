// SPDX-License-Identifier: Apache-2.0
// A holonomic base that executes commands late, in steps and not below some speed: the solution of
// its equation, computed apart from what the library expects of it.
#pragma once
#include <algorithm>
#include <cmath>
#include <deque>

#include "avo/execution.h"
#include "avo/vec.h"

namespace avo::test {

/// The true base: constants that its ExecutionModel only bounds.
struct SluggishBase {
  double lag = 0.0, dead_time = 0.0;     // s
  double deadband = 0.0, quantum = 0.0;  // m/s
  Vec2 position = {}, velocity = {};
  Vec2 error = {};  // m/s, of the executed velocity
  double time = 0.0;

  /// The command of now.
  void tell(Vec2 command) { sent.push_back({time + dead_time, executed(command)}); }

  /// The motion of a step, at `parts` times of which `look` is called.
  template <typename Look>
  void move(double duration, int parts, const Look& look) {
    const double from = time;
    for (int k = 1; k <= parts; ++k) {
      move_until(from + duration * k / parts);
      look(double(k) / parts);
    }
  }

 private:
  struct Sent {
    double from;  // s, when it begins to act
    Vec2 command;
  };
  std::deque<Sent> sent;
  Vec2 acting = {};

  [[nodiscard]] double executed(double coordinate) const {
    const double in_steps = quantum > 0.0 ? quantum * std::round(coordinate / quantum) : coordinate;
    return std::abs(in_steps) < deadband ? 0.0 : in_steps;
  }
  [[nodiscard]] Vec2 executed(Vec2 command) const {
    return {executed(command.x), executed(command.y)};
  }
  void move_until(double end) {
    while (!sent.empty() && sent.front().from <= end) {
      coast(std::max(sent.front().from - time, 0.0));
      acting = sent.front().command;
      sent.pop_front();
    }
    coast(end - time);
  }
  void coast(double duration) {
    const Vec2 target = acting + error;
    if (lag == 0.0) {
      position = position + duration * target;
      if (duration > 0.0) velocity = target;
    } else {
      const double left = std::exp(-duration / lag);
      position = position + duration * target + (lag * (1.0 - left)) * (velocity - target);
      velocity = target + left * (velocity - target);
    }
    time += duration;
  }
};

}  // namespace avo::test
