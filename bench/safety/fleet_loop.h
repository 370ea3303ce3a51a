// SPDX-License-Identifier: Apache-2.0
// A fleet in a separate loop around Planner::plan: Sensing sets what robots know of each other, and
// Acting sets how they decide and move.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "avo/planner.h"
#include "placement.h"
#include "scenes.h"
#include "sensing.h"

namespace avo::safety {

class FleetLoop {
 public:
  /// Throws Error if the motion is not held, but states within a step are required.
  FleetLoop(const Scene& scene, std::uint64_t seed, const PlannerOptions& options);

  /// Makes the decisions and the motion of one tick.
  void tick();
  void send_all_to(Vec2 goal);
  /// Gives every obstacle a new acceleration.
  void turn_movers();

  [[nodiscard]] double time() const { return static_cast<double>(ticks_) * tick_time_; }
  [[nodiscard]] std::int64_t ticks() const { return ticks_; }
  [[nodiscard]] const std::vector<Robot>& robots() const { return robots_; }
  [[nodiscard]] const std::vector<RobotSetup>& setup() const { return setup_; }
  [[nodiscard]] const std::vector<Neighbor>& obstacles() const { return obstacles_; }
  /// Returns the plans of the last tick.
  [[nodiscard]] const std::vector<Plan>& plans() const { return plans_; }

 private:
  static constexpr std::int64_t kNever = -1;
  // The motion of the drive: within a step it goes from its velocity to the next velocity, which it
  // then keeps.
  struct Drive {
    Vec2 position, velocity, next_velocity;
    std::int64_t since = 0;  // tick
  };
  struct Command {
    Vec2 next_velocity;
    std::int64_t at = kNever;  // tick
  };

  [[nodiscard]] const Planner& planner(std::size_t i) const { return planners_[odd_[i]]; }
  [[nodiscard]] std::int64_t step_ticks(std::size_t i) const;
  Plan decide(std::size_t i);
  void follow_commands();
  void move(std::size_t i);

  std::vector<RobotSetup> setup_;
  Acting acting_;
  std::array<Planner, 2> planners_;  // of most robots; of the odd robots
  Senses senses_;
  Random random_;
  double tick_time_;
  std::vector<Robot> robots_, before_;
  std::vector<Neighbor> obstacles_, neighbors_;
  std::vector<std::uint8_t> odd_;            // 0 or 1
  std::vector<std::int64_t> next_decision_;  // ticks
  std::vector<Command> commands_;
  std::vector<Drive> drives_;
  std::vector<Detour> detours_;
  std::vector<Plan> plans_;
  PlanWorkspace workspace_;
  std::int64_t ticks_ = 0;
};

}  // namespace avo::safety
