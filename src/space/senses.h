// SPDX-License-Identifier: Apache-2.0
// What robots of space sense of others where the scene says that they sense with errors, late, or
// not at all (docs/space.md, "Sensing"). The rules are those of the plane.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/ids.h"
#include "avo/space/box.h"
#include "avo/space/mover.h"
#include "avo/space/robot.h"
#include "avo/space/scenario.h"
#include "core/draws.h"
#include "space/routes/solids.h"

namespace avo::space {

struct PastState {
  Vec3 position, velocity;  // m, m/s
};

/// The last states of bodies, `depth` steps each.
struct PastStates {
  std::size_t depth = 0;
  std::vector<PastState> states = {};    // by body, that of step g at g % depth
  std::vector<std::int64_t> since = {};  // by body: the step in which it came

  void add(std::int64_t step);
  void remove(std::size_t k);
  [[nodiscard]] const PastState& at(std::size_t k, std::int64_t g) const {
    return states[k * depth + static_cast<std::size_t>(g) % depth];
  }
  template <typename Bodies>
  void note(const Bodies& bodies, std::int64_t step) {
    const std::size_t place = static_cast<std::size_t>(step) % depth;
    for (std::size_t k = 0; k < bodies.size(); ++k)
      states[k * depth + place] = {bodies[k].position, bodies[k].velocity};
  }
};

/// The states that measurements may use. Measurements are made of these states and of random
/// numbers that follow from (seed, step, observer, other). So neither the order of robots nor the
/// number of threads matters.
struct Senses {
  SensingModel model = {};
  std::uint64_t seed = 0;
  double time_step = 0.0;  // s
  double radius = 0.0;     // m, the sensing radius
  PastStates robots = {};  // with the present states; depth 0: senses are exact
  PastStates movers = {};
  std::int64_t step = 0;  // the present one

  /// Whether others are sensed exactly.
  [[nodiscard]] bool are_exact() const { return robots.depth == 0; }
  [[nodiscard]] bool know_places() const { return !(model.localization.position > 0.0); }
  /// m: the error of the robot's own place in the present step.
  [[nodiscard]] Vec3 own_error(std::size_t robot) const;
  /// Stores the states of the step that begins.
  void note(std::span<const Robot> now, std::span<const Mover> movers_now, std::int64_t present);
};

Senses senses_of(const Scenario& scenario);

/// m: a bound of own_error().
double most_lost(const LocalizationNoise& model);

/// s: how long a robot may be in sight before it is first sensed, except with the probability
/// dropped^(kMostCarried + 1).
double time_unseen(const Scenario& scenario);

/// A robot that measures in the present step.
class Observer {
 public:
  Observer(const Senses& senses, std::size_t robot, std::span<const Box> boxes,
           const Solids& solids);

  /// The state of robot `other` as it is sensed; none where it is not.
  [[nodiscard]] std::optional<Neighbor> look_at(std::size_t other, const Robot& traits) const;
  /// The same for moving obstacle m of that id, which is extrapolated at its acceleration. now: as
  /// it is.
  [[nodiscard]] std::optional<Mover> look_at(std::size_t m, MovingObstacleId id,
                                             const Mover& now) const;

 private:
  /// The step of the last measurement that the robot has of body k of these. other: its number in
  /// draws.
  [[nodiscard]] std::optional<std::int64_t> last_measured(const PastStates& bodies, std::size_t k,
                                                          std::uint64_t other) const;
  /// Whole steps from that measurement to the one that the robot might have.
  [[nodiscard]] int age(std::int64_t moment, std::int64_t since) const;
  /// Adds the noise of a measurement so many seconds ago, and extrapolates it.
  void disturb(std::int64_t moment, std::uint64_t other, Vec3& position, Vec3& velocity) const;
  [[nodiscard]] double seconds_since(std::int64_t moment) const;
  [[nodiscard]] Draws draws(std::int64_t moment, std::uint64_t other) const;
  [[nodiscard]] bool succeeds(Vec3 from, Vec3 to, std::int64_t moment, std::int64_t first,
                              std::uint64_t other) const;

  const Senses& senses_;
  std::size_t robot_;
  std::span<const Box> boxes_;
  const Solids& solids_;  // of these boxes
  std::int64_t latest_;   // step of its latest measurement
  std::uint64_t key_;     // of the draws of that measurement
};

}  // namespace avo::space
