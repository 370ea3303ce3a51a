// SPDX-License-Identifier: Apache-2.0
// A fleet in space, and its step: what each robot senses, where it heads for, and its decision.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "avo/horizon.h"
#include "avo/space/planner.h"
#include "avo/space/scenario.h"
#include "avo/space/simulation.h"
#include "core/executor.h"
#include "space/bodies.h"
#include "space/cells.h"
#include "space/decide.h"
#include "space/goals.h"
#include "space/mover_columns.h"
#include "space/places.h"
#include "space/routes/routes.h"
#include "space/senses.h"
#include "space/shared_goals.h"
#include "space/workspace.h"

namespace avo::space {

/// The memory of a worker.
struct AVO_LOCAL SpaceWorker {
  PlanWorkspace::Scratch scratch;
  SpaceCells::Runs runs{};
  std::vector<Box> boxes;  // as the robot sees them
  std::vector<std::uint32_t> near_boxes;
  Vec3 lost;  // m, by which it errs in its own place
  std::vector<Mover> movers;
  std::vector<ObstacleId> box_ids;          // of the boxes
  std::vector<MovingObstacleId> mover_ids;  // of the movers
  HeadingScratch routes;
  std::vector<Neighbor> neighbors, on_map;  // where they are, and where the robot takes them to be
  SpaceOccupied occupied;
};

/// What a robot's scene says of its trip; near in memory, unlike the scene.
struct Trip {
  Vec3 goal;               // m
  double preferred_speed;  // m/s
  double box_range;        // m
};

/// What a robot knows and remembers on its route to its goal.
struct Travelling {
  Robot& robot;
  SpaceRoute& route;
  Detour& detour;
  std::uint8_t& has_stood;  ///< see SpaceSeeker::has_stood
};

/// The robots of a scene and what they know. Columns by the number of the robot in the scene.
struct AVO_LOCAL SpaceFleet {
  static constexpr std::size_t kTile = 16;  // robots that one task decides for

  Scenario scenario;
  PlannerOptions options;
  std::vector<Horizon> horizons;
  StepLaw law;
  Landing landing;
  double sensing_radius;
  std::shared_ptr<Executor> executor;
  SpaceCells cells;
  Bodies bodies;  // the robots in the order of the cells
  Senses senses;
  MoverColumns movers;  // beside scenario.moving_obstacles
  std::vector<Robot> robots;
  std::vector<Detour> detours;
  std::vector<Plan> plans;
  std::vector<Simulation::Touched> touched;  // where the last plan is overlapping
  std::vector<Trip> trips;
  std::vector<Tempo> tempos;
  Solids solids;  // scenario.boxes
  SpaceRoutes routes;
  SharedGoals shares;                   // as of the last step
  std::vector<std::uint8_t> has_stood;  // see SpaceSeeker::has_stood
  bool has_new_goals = true;
  bool has_downwash = false;  // some robot has
  std::vector<SpaceWorker> workers;
  std::int64_t steps = 0;

  SpaceFleet(const Scenario& scene, int threads);
  void step();
  void find_routes();
  [[nodiscard]] std::vector<Vec3> goals() const;
  /// Returns whether robot k rests at a place near a goal that leaves no room for it.
  [[nodiscard]] bool rests_at_place(std::size_t k) const;
  /// What robot k senses and wants before the next step, by the functions of a step.
  Simulation::Perception perceive(std::size_t k);

 private:
  /// What a step begins with. It changes nothing that robots remember.
  void begin_step();
  /// Puts the bodies into the order of the cells.
  void sort();
  void move();
  [[nodiscard]] bool is_in_range(Vec3 place, std::size_t k) const;
  /// The moving obstacles that a robot senses.
  void sense_movers(std::size_t k, SpaceWorker& worker) const;
  /// The robots that a robot senses by measurements, in the memory of the worker.
  void sense_robots(std::size_t k, std::size_t runs, SpaceWorker& worker) const;
  /// The static obstacle that a box of the scene is of.
  [[nodiscard]] ObstacleId obstacle_of(std::size_t box) const;
  /// Puts ids in the place of the lists of one decision.
  void name_touched(std::size_t k, const SpaceWorker& worker);
  /// The boxes that matter to a robot, where it sees them.
  void find_boxes(std::size_t k, SpaceWorker& worker) const;
  /// Sets the preferred velocity of robot k: along its route, where boxes are in between.
  void head_for_goal(std::size_t k, const BodiesAround& around, SpaceWorker& worker);
  [[nodiscard]] PassageView view_of(std::size_t k, std::span<const Neighbor> company) const {
    return {company, detours[k].angle, sensing_radius, law.time_step};
  }
  /// Sets the preferred velocity of a robot with the state of robot k. Returns what guides it.
  Guide head_for_goal(std::size_t k, std::span<const Neighbor> company, const Travelling& own,
                      SpaceWorker& worker) const;
  /// On the map, where a robot with the state of robot k heads for along its route.
  SpaceHeading heading_of(std::size_t k, std::span<const Neighbor> company, const Travelling& own,
                          SpaceWorker& worker) const;
  /// Where a robot with the state of robot k heads for that shares its goal. Where that is its
  /// route, it has no place.
  SpaceAtSharedGoal near_goal(std::size_t k, std::span<const Neighbor> company,
                              const Travelling& own, SpaceWorker& worker) const;
  [[nodiscard]] bool shares_goal(std::size_t k) const {
    return shares.of(k) != SpaceShares::nothing;
  }
  /// Decides for the robot at that place in the order of the cells.
  void decide(std::size_t at, SpaceWorker& worker);
  /// Calls visit(k, worker) for all k below the number of robots, in parallel where they are many.
  template <typename Visit>
  void for_all(const Visit& visit) {
    const std::size_t count = robots.size(), tiles = (count + kTile - 1) / kTile;
    const auto visit_tile = [&](std::size_t tile, std::size_t worker) {
      const std::size_t end = std::min((tile + 1) * kTile, count);
      for (std::size_t k = tile * kTile; k < end; ++k) visit(k, workers[worker]);
    };
    if (count >= kFewestParallel) return parallel_for(*executor, tiles, visit_tile);
    for (std::size_t tile = 0; tile < tiles; ++tile) visit_tile(tile, 0);
  }
};

}  // namespace avo::space
