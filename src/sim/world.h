// SPDX-License-Identifier: Apache-2.0
// All that a simulation is made of, and its step.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/executor.h"
#include "core/stage_clock.h"
#include "planner/relevance.h"
#include "planner/tile.h"
#include "robots/motion.h"
#include "sim/bystanders.h"
#include "sim/claims.h"
#include "sim/clocks.h"
#include "sim/fleet.h"
#include "sim/kinds.h"
#include "sim/moving_columns.h"
#include "sim/outliers.h"
#include "sim/places.h"
#include "sim/senses.h"
#include "sim/snapshot.h"
#include "sim/static_world.h"
#include "sim/ways.h"
#include "sim/whereabouts.h"

namespace avo::inline sim {

/// Candidates for being a neighbor, of a tile.
inline constexpr std::size_t kTileCandidates = 4096;

/// What one worker needs to take robots through a step without allocating, and its sums. No two
/// workers write to one line of the cache.
struct alignas(128) Worker {
  PlanWorkspace workspace;
  Tile tile;
  MovingColumns moving;
  std::vector<NeighborQuery> queries;
  std::vector<std::uint32_t> deciding;  // slots of a tile, where some robots are parked
  std::vector<std::uint32_t> staying;   // slots in a tile of those that stop at shared goals
  SearchScratch search, obstacles;
  SearchScratch outliers, again;  // of robots near outliers, one at a time
  LegScratch legs;
  std::vector<Heading> headings;    // by ways alone, of a tile, where some share goals
  std::vector<Present> seen;        // where senses are not exact: by one robot,
  std::vector<Sighting> sightings;  // and how
  Occupied occupied;                // of one robot, see place_near()
  std::vector<Vec2> lost;           // m, see own_error(); of a tile, where there is localization
  std::vector<Wall> walls;          // as those robots see them then
  bool fast = false;                // moved a robot that exceeds its max_speed
  std::uint64_t crowding = 0;

  StageClock clock;
  std::int64_t pairs = 0, infeasible = 0;
};

/// What robots of one method, time horizon and time_step decide and move by.
struct Pace {
  Planner planner;
  StepResponse response;

  explicit Pace(const PlannerOptions& options)
      : planner(options), response(step_response(planner)) {}
};

/// What a robot has in common with another one, where both may not be in one place.
enum class Shares : std::uint8_t {
  nothing,
  room,  ///< their goals are so close that they cannot be there both
  goal,  ///< bit for bit
};

struct World {
  Scenario settings;        // without its robots and obstacles
  double sensing_radius;    // m; where the scene names none, it grows with robots that are added
  std::vector<Pace> paces;  // the scene's first; others where robots have something of their own
  Fleet fleet;
  std::optional<Kinds> kinds;  // of the fleet, once somebody has been added
  Bystanders bystanders;       // of edits between two steps
  ObstacleColumns obstacles;
  Senses senses;
  StaticWorld statics;
  Ways ways;
  Claims claims;
  std::int64_t steps = 0;
  Instant now = 0, before = -1;  // of free clocks: the last step began before, if at all
  std::uint64_t next_id = 0;

  Agenda agenda;  // of free clocks, like the next two
  Whereabouts whereabouts;
  std::atomic<bool> is_current = true;  // the fleet's columns tell where all are now

  Snapshot snapshot;
  Outliers outliers;
  UniformGrid obstacle_grid;
  std::shared_ptr<Executor> executor;
  SerialExecutor serial;
  std::vector<Worker> workers;             // as many as the executor has
  std::vector<std::uint32_t> due;          // slots, by pace, where clocks are free
  bool torn = false;                       // a step ended while some had moved and others not
  bool changed = true;                     // robots came or went
  std::atomic<bool> has_new_goals = true;  // since find_shared_goals()
  std::vector<Shares> shares_goal;         // by rank; empty where nobody shares anything
  bool fast = false;                       // some robot exceeds its max_speed
  bool exceeding = false;                  // some accelerate by more than their max_acceleration
  std::size_t parked = 0;                  // robots
  bool certified = false;                  // some keep a certificate
  bool valid = false;                      // all robots were, when they came
  double near = 0.0;                       // m, typical of Fleet::range
  std::int64_t next_layout = 1;  // when the cells are chosen anew and the robots put in their order
  std::int64_t robot_steps = 0;  // measured

  World(const Scenario& scenario, std::shared_ptr<Executor> steps_by);

  const Planner& planner() const { return paces.front().planner; }
  /// By which measurements are told, see Senses.
  std::int64_t moment() const { return senses.by_time ? now : steps; }
  const Pace& pace(std::size_t slot) const { return paces[fleet.pace_of(slot)]; }
  /// That of such a robot; it is made if there is none yet.
  OwnPace pace_of(const RobotSetup& setup);
  /// What those who keep a certificate have in common; the scene's where nobody does.
  const Planner& certified_planner() const;
  /// Neighbors that the planner is given for being the nearest.
  std::size_t most_nearest() const;
  /// A certificate has to know all others within the sensing radius as well.
  bool all_matter() const { return certified; }
  bool all_matter_to(std::size_t slot) const {
    return pace(slot).planner.options().certificate != Certificate::none;
  }
  bool is_fast(std::size_t slot) const;
  /// m: what the robot heads for in the end, its goal or the nearest place to it.
  Vec2 end_of(std::size_t slot) const {
    if (ways.travels.empty()) return fleet.goal[slot];
    return ways.travels[static_cast<std::size_t>(fleet.rank[slot])].heads_for(fleet.goal[slot]);
  }
  /// nearest: m, see heed_passages(). Of whose neighbors and walls `seen` tells; says there what
  /// the robot remembers of its goal, and whether it stops.
  Robot robot(std::size_t slot, double nearest, Simulation::Perception& seen) const;
};

/// Where those with a path will be, if that is not known yet. Robots know it that sense exactly and
/// decide at the same times.
void foresee(World& world);

/// Builds the grid of walls and finds the passages, where walls are new or a robot is larger or
/// reaches farther than they were made for.
void find_walls(World& world);

/// Finds who has the same goal as another one, where goals are new.
void find_shared_goals(World& world);

/// Whether it heads for its goal, and there is no room there for it and another one
/// (docs/arrival.md, rule 4).
bool shares_room(const World& world, std::size_t slot);
/// heading: by its way, whatever passages make of it. lost: see own_error().
Seeker seeker_of(const World& world, std::size_t slot, const Heading& heading, Vec2 lost);
/// What such a robot decides there, whatever else it would.
struct AtSharedGoal {
  std::optional<Vec2> heads_for = {};  // m, of its disc; none: where its way leads
  bool has_stood = false;              // then, see Fleet::has_stood
  bool stops = false;                  // it brakes until it stands, and lets nobody put it aside
};
/// Of that robot as a seeker, and what it sees; sets Detour::goal_taken.
AtSharedGoal at_shared_goal(const World& world, std::size_t slot, const Seeker& seeker,
                            Occupied& occupied, std::span<const Wall> walls, Detour& detour);
/// Whether one of which shares_room() held has come to rest, at its goal or as near as there was
/// room.
bool rests_at_place(const World& world, std::size_t slot);
/// The decision of one that stops.
Plan stop_of(const World& world, std::size_t slot);

/// For what the walls near a robot and its looking for a way take in a step.
void make_room(World& world);

/// Decides for the robots of the worker's tile, all of one pace, whose neighbors are known, moves
/// them, and empties it.
void plan_and_move(World& world, const Pace& pace, std::span<const std::uint32_t> slots,
                   Worker& worker);

/// One sensing-acting cycle of all robots.
void step(World& world);

}  // namespace avo::inline sim
