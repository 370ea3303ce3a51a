// SPDX-License-Identifier: Apache-2.0
#include "evadable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

#include "placement.h"

namespace avo::safety {
namespace {

constexpr std::size_t kMost = 4000;  // the most states that are kept
constexpr double kHeld = 0.2;        // s, about: how long an acceleration is held
constexpr int kLooks = 8;            // tests of the distances while it is held
constexpr int kDirections = 12;      // number of directions of accelerations
// One state is kept in each cell. The sizes are m, and a part of what a held acceleration changes,
// so that it leads to another cell.
constexpr double kCell = 0.1, kPace = 0.5;

struct State {
  Vec2 position, velocity;  // m, m/s
};
using Places = std::vector<Vec2>;  // of all moving obstacles

// The places of the moving obstacles within their steps.
class Movers {
 public:
  explicit Movers(const Scenario& scenario) : scenario_(scenario) {
    for (const MovingObstacle& mover : scenario.moving_obstacles)
      walks_.push_back({mover.position, mover.velocity});
  }
  // Advances by so many steps and returns the places at kLooks evenly spaced times, the last one at
  // the end.
  std::array<Places, kLooks> go_on(std::int64_t steps) {
    std::array<Places, kLooks> looks;
    const double h = scenario_.time_step;
    std::int64_t gone = 0;
    for (int look = 0; look < kLooks; ++look) {
      const double at = static_cast<double>(steps) * (look + 1) / kLooks;  // steps
      while (static_cast<double>(gone + 1) <= at) step(), ++gone;
      const double within = (at - static_cast<double>(gone)) * h;
      for (std::size_t k = 0; k < walks_.size(); ++k) looks[look].push_back(place(k, within));
    }
    return looks;
  }

 private:
  PathWalk after_step(std::size_t k) const {
    const MovingObstacle& mover = scenario_.moving_obstacles[k];
    const double h = scenario_.time_step;
    if (!mover.path.empty()) return next_on_path(mover, walks_[k], h);
    const Vec2 velocity = walks_[k].velocity + h * mover.acceleration;
    return {walks_[k].position + (0.5 * h) * (walks_[k].velocity + velocity), velocity};
  }
  void step() {
    for (std::size_t k = 0; k < walks_.size(); ++k) walks_[k] = after_step(k);
  }
  Vec2 place(std::size_t k, double within) const {
    const Vec2 change = after_step(k).velocity - walks_[k].velocity;
    const double held = 0.5 * within * within / scenario_.time_step;
    return walks_[k].position + within * walks_[k].velocity + held * change;
  }

  const Scenario& scenario_;
  std::vector<PathWalk> walks_;
};

std::uint64_t cell_of(const State& state, double pace) {
  const auto part = [](double value, double size) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size))) &
           0xffffU;
  };
  return part(state.position.x, kCell) | part(state.position.y, kCell) << 16U |
         part(state.velocity.x, pace) << 32U | part(state.velocity.y, pace) << 48U;
}

// Returns accelerations that hold the velocity, that brake, and full accelerations in all
// directions.
std::array<Vec2, kDirections + 2> accelerations(const RobotSetup& robot, Vec2 velocity,
                                                double held) {
  std::array<Vec2, kDirections + 2> all{};
  const double speed = norm(velocity), most = robot.max_acceleration;
  if (speed > 0.0) all[1] = (-std::min(most / speed, 1.0 / held)) * velocity;
  for (int k = 0; k < kDirections; ++k)
    all[static_cast<std::size_t>(k) + 2] = most * circle_point(k, kDirections);
  return all;
}

struct Reach {
  const Scenario& scenario;
  const std::array<Places, kLooks>& looks;
  double held;  // s

  bool is_clear(const State& from, Vec2 acceleration) const {
    const RobotSetup& robot = scenario.robots[0];
    for (int look = 0; look < kLooks; ++look) {
      const double t = held * (look + 1) / kLooks;
      const Vec2 place = from.position + t * (from.velocity + (0.5 * t) * acceleration);
      const Places& places = looks[static_cast<std::size_t>(look)];
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (norm(place - places[k]) < robot.radius + scenario.moving_obstacles[k].radius)
          return false;
      }
    }
    return true;
  }
};

std::vector<State> states_after(const std::vector<State>& states, const Reach& reach) {
  const RobotSetup& robot = reach.scenario.robots[0];
  std::vector<State> next;
  std::unordered_set<std::uint64_t> cells;
  cells.reserve(2 * states.size());
  const double pace = kPace * reach.held * robot.max_acceleration;  // m/s
  for (const State& from : states) {
    for (const Vec2 a : accelerations(robot, from.velocity, reach.held)) {
      const Vec2 velocity = from.velocity + reach.held * a;
      const State to{from.position + (0.5 * reach.held) * (from.velocity + velocity), velocity};
      const std::uint64_t cell = cell_of(to, pace);
      if (norm(velocity) > robot.max_speed * (1.0 + 1e-9) || cells.count(cell) > 0) continue;
      if (!reach.is_clear(from, a)) continue;
      cells.insert(cell);
      next.push_back(to);
    }
  }
  return next;
}

}  // namespace

bool is_evadable(const Scenario& scenario) {
  const auto steps = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::llround(kHeld / scenario.time_step)));
  const double held = static_cast<double>(steps) * scenario.time_step;
  Movers movers(scenario);
  Random random(1, 12);
  std::vector<State> states{{scenario.robots[0].position, scenario.robots[0].velocity}};
  for (double time = 0.0; time < scenario.duration && !states.empty(); time += held) {
    const std::array<Places, kLooks> looks = movers.go_on(steps);
    states = states_after(states, {scenario, looks, held});
    if (states.size() <= kMost) continue;
    for (std::size_t k = 0; k < kMost; ++k)
      std::swap(states[k], states[k + random.below(states.size() - k)]);
    states.resize(kMost);
  }
  return !states.empty();
}

}  // namespace avo::safety
