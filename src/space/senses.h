// SPDX-License-Identifier: Apache-2.0
// What robots of space sense of others where the scene says that they sense with errors, late, or
// not at all (docs/space.md, "Sensing"). The rules are those of the plane.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/space/box.h"
#include "avo/space/robot.h"
#include "avo/space/scenario.h"
#include "core/draws.h"

namespace avo::space {

struct PastState {
  Vec3 position, velocity;  // m, m/s
};

/// The states that measurements may use. Measurements are made of these states and of random
/// numbers that are found by (seed, step, observer, other): neither the order of robots nor the
/// number of threads matters.
struct Senses {
  SensingModel model = {};
  std::uint64_t seed = 0;
  double time_step = 0.0;            // s
  double radius = 0.0;               // m, the sensing radius
  std::size_t depth = 0;             // steps remembered, with the present one; 0: senses are exact
  std::vector<PastState> past = {};  // by robot, `depth` each, that of step g at g % depth
  std::int64_t step = 0;             // the present one

  [[nodiscard]] bool are_exact() const { return depth == 0; }
  [[nodiscard]] const PastState& at(std::size_t robot, std::int64_t g) const {
    return past[robot * depth + static_cast<std::size_t>(g) % depth];
  }
  /// Stores the states of the step that begins.
  void note(std::span<const Robot> robots, std::int64_t now);
};

Senses senses_of(const Scenario& scenario);

/// s: how long a robot may be in sight before it is first sensed, except with the probability
/// dropped^(kMostCarried + 1).
double time_unseen(const Scenario& scenario);

/// A robot that measures in the present step.
class Observer {
 public:
  Observer(const Senses& senses, std::size_t robot, std::span<const Box> boxes);

  /// The state of robot `other` as it is sensed; none where it is not.
  [[nodiscard]] std::optional<Neighbor> look_at(std::size_t other, const Robot& traits) const;
  /// The same for moving obstacle m, which is extrapolated at its acceleration.
  [[nodiscard]] std::optional<Mover> look_at(std::size_t m, const MovingObstacle& obstacle) const;

 private:
  /// The step of the last measurement that the robot has; place(step): the place of the other then.
  template <typename Place>
  [[nodiscard]] std::optional<std::int64_t> last_measured(std::uint64_t other,
                                                          const Place& place) const;
  /// Adds the noise of a measurement so many seconds ago, and extrapolates it.
  void disturb(std::int64_t moment, std::uint64_t other, Vec3& position, Vec3& velocity) const;
  [[nodiscard]] double seconds_since(std::int64_t moment) const;
  [[nodiscard]] Draws draws(std::int64_t moment, std::uint64_t other) const;
  [[nodiscard]] bool succeeds(Vec3 from, Vec3 to, std::int64_t moment, std::uint64_t other) const;

  const Senses& senses_;
  std::size_t robot_;
  std::span<const Box> boxes_;
  std::int64_t latest_;  // step of its latest measurement
  std::uint64_t key_;    // of the draws of that measurement
};

}  // namespace avo::space
