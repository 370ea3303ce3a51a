// SPDX-License-Identifier: Apache-2.0
// Many worlds at once for learning: their state and their steps.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "avo/planner.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "bind.h"

namespace avo_python {

struct World {
  std::vector<avo::Robot> robots;  // their discs, as others sense them
  std::vector<avo::Vec2> goals;
  std::vector<avo::Wall> walls;
  std::vector<avo::MovingObstacle> movers;  // as they are now
  std::vector<std::uint32_t> targets;       // of their paths
  std::int64_t steps = 0;
  // moves all of a world in which some robots have wheels; `robots` and `movers` follow it
  std::unique_ptr<avo::Simulation> wheels;

  /// m; of a robot with wheels the middle of its axle.
  [[nodiscard]] avo::Vec2 position(std::size_t robot) const {
    return wheels ? wheels->fleet().position[robot] : robots[robot].position;
  }
  /// rad; 0 of robots without wheels
  [[nodiscard]] double heading(std::size_t robot) const {
    return wheels ? wheels->fleet().heading[robot] : 0.0;
  }
};

/// Keeps two threads from using the same worlds. Throws Error if a thread uses them already.
class InUse {
 public:
  explicit InUse(std::atomic<bool>& used) : used_(used) {
    if (used_.exchange(true))
      throw avo::Error("worlds: found in use by another thread, must be used by one at a time");
  }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;
  ~InUse() { used_ = false; }

 private:
  std::atomic<bool>& used_;
};

/// E worlds of N robots each, with the settings of one scene.
class Worlds {
 public:
  Worlds(std::size_t worlds, const avo::Scenario& scenario);

  /// Puts the robots, goals, walls and moving obstacles of the scenario into that world.
  void place(std::size_t world, const avo::Scenario& scenario);

  /// preferred: for all robots of all worlds, m/s. moving: the worlds that take part. home: the
  /// robots that go to their goals by themselves where there are wheels, or empty.
  void step(std::span<const avo::Vec2> preferred, const std::vector<char>& moving,
            std::span<const bool> home) {
    for (std::size_t e = 0; e < all_.size(); ++e) {
      if (moving[e] == 0) continue;
      const auto own = preferred.subspan(e * robots_, robots_);
      const auto at_home = home.empty() ? home : home.subspan(e * robots_, robots_);
      all_[e].wheels ? drive(all_[e], own, at_home) : step(all_[e], own);
    }
  }

  [[nodiscard]] std::size_t worlds() const { return all_.size(); }
  [[nodiscard]] std::size_t robots() const { return robots_; }
  [[nodiscard]] const World& world(std::size_t e) const { return all_[e]; }
  [[nodiscard]] std::atomic<bool>& used() const { return used_; }

  /// Finds the neighbors that robot i of the world senses: squared distances, m^2, and numbers,
  /// nearest first. Moving obstacles have the numbers behind those of robots.
  void find_near(const World& world, std::size_t i,
                 std::vector<std::pair<double, std::size_t>>& near) const;
  /// The neighbor with such a number.
  [[nodiscard]] avo::Neighbor neighbor(const World& world, std::size_t j) const;
  [[nodiscard]] double sensing_radius() const { return sensing_radius_; }

 private:
  /// First all robots decide from the same states, and then all robots move.
  void step(World& world, std::span<const avo::Vec2> preferred);
  /// The same by a simulation, where some robots have wheels.
  static void drive(World& world, std::span<const avo::Vec2> preferred, std::span<const bool> home);

  avo::Planner planner_;
  double sensing_radius_;
  std::size_t robots_;
  std::vector<World> all_;
  mutable std::atomic<bool> used_ = false;
  std::vector<avo::Vec2> next_;
  std::vector<std::pair<double, std::size_t>> near_;
  std::vector<avo::Neighbor> neighbors_;
};

/// What robots observe, see Worlds.nearest(), nearest_walls() and movers() of Python.
py::array_t<float> nearest(const Worlds& self, std::size_t k);
py::array_t<float> nearest_walls(const Worlds& self, std::size_t k);
py::array_t<double> movers_of(const Worlds& self, std::size_t world);

}  // namespace avo_python
