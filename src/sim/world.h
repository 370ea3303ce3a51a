// SPDX-License-Identifier: Apache-2.0
// All parts of a simulation, and its step.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/executor.h"
#include "core/stage_clock.h"
#include "guidance/at_goal.h"
#include "guidance/routes.h"
#include "planner/stages/relevance.h"
#include "planner/tile.h"
#include "robots/motion.h"
#include "sim/bystanders.h"
#include "sim/claims.h"
#include "sim/clocks.h"
#include "sim/columns/fleet.h"
#include "sim/columns/kinds.h"
#include "sim/columns/moving_columns.h"
#include "sim/columns/static_world.h"
#include "sim/columns/whereabouts.h"
#include "sim/host/external.h"
#include "sim/sensing/outliers.h"
#include "sim/sensing/senses.h"
#include "sim/sensing/snapshot.h"
#include "sim/taken_goals.h"

namespace avo::inline sim {

/// Number of candidate neighbors of a tile.
inline constexpr std::size_t kTileCandidates = 4096;

/// What one worker needs to take robots through a step without allocating, and its sums. No two
/// workers write to the same cache line.
struct alignas(128) Worker {
  PlanWorkspace workspace;
  Tile tile;
  MovingColumns moving;
  std::vector<NeighborQuery> queries;
  std::vector<std::uint32_t> deciding;  // slots of a tile, where some robots are parked
  std::vector<std::uint32_t> staying;   // slots in a tile of robots that stop at shared goals
  SearchScratch search, movers;
  SearchScratch outliers, again;  // for robots near outliers, one at a time
  LegScratch legs;
  std::vector<Heading> headings;    // by routes alone, of a tile, where some share goals
  std::vector<Present> seen;        // where senses are not exact: the robots seen by one robot,
  std::vector<Sighting> sightings;  // and their sightings
  // what the robots of a tile remember besides tile.detour: in the fleet, or in a copy
  std::vector<Travel*> travels;          // where there are routes
  std::vector<std::uint8_t*> has_stood;  // where some share room at their goals
  // where the only robot of a tile is explained: what leads it, and its neighbors, as in
  // Sighting::source
  Guide* told = nullptr;
  std::vector<int>* sources = nullptr;
  Occupied occupied;        // of one robot, see place_near()
  std::vector<Vec2> lost;   // m, see own_error(); of a tile, where there is localization
  std::vector<Wall> walls;  // the walls as those robots then see them
  bool fast = false;        // whether it moved a robot that exceeds its max_speed
  std::uint64_t crowding = 0;

  StageClock clock;
  std::int64_t pairs = 0, infeasible = 0;
};

/// The planner and the response of robots of one method, time horizon, arrival distance and
/// time_step.
struct Pace {
  Planner planner;
  StepResponse response;

  explicit Pace(const PlannerOptions& options)
      : planner(options), response(step_response(planner)) {}
};

struct World;

/// The world's paces, where there are moving obstacles or not. Only where there are some do robots
/// keep evasive maneuvers, and see all walls within their reach.
std::vector<Pace> paces_among(const World& world, bool has_movers);

/// What a robot has in common with another one, where both may not be in one place.
enum class Shares : std::uint8_t {
  nothing,
  room,  ///< their goals are so close that they cannot both be there
  goal,  ///< the same goal, bit for bit
};

/// What holds for some robots of the fleet, or for all.
struct FleetSummary {
  std::size_t idle = 0;   // robots that do not decide: parked, or moved by the host
  bool exceeds = false;   // some accelerate by more than their max_acceleration
  bool is_valid = false;  // all were valid when they came
  bool is_fast = false;   // some exceed their max_speed
};
FleetSummary summary_of(const World& world);

struct World {
  Scenario settings;        // without its robots and obstacles
  double sensing_radius;    // m; where the scene gives none, it grows with robots that are added
  std::vector<Pace> paces;  // the scene's first; further ones for robots with values of their own
  // indices of the further ones, by a hash of those values; some stand for others by now
  std::unordered_multimap<std::uint64_t, std::uint32_t> pace_at;
  Fleet fleet;
  std::optional<Kinds> kinds;  // of the fleet, once a robot has been added
  Bystanders bystanders;       // for edits between two steps
  MoverColumns movers;
  Senses senses;
  StaticWorld statics;
  std::vector<Routes> routes;        // of each floor
  std::vector<Claims> claims;        // of each floor's passages
  std::vector<std::uint32_t> floor;  // of each robot, by rank; empty where there is one
  std::vector<Travel> travels;       // by rank; empty without routes
  std::int64_t steps = 0;
  Instant now = 0, before = -1;  // for free clocks: the last step began at `before`, if at all
  std::uint64_t next_id = 0;

  Agenda agenda;  // for free clocks, like the next two
  Whereabouts whereabouts;
  std::atomic<bool> is_current = true;  // whether the fleet's columns have the present places

  Snapshot snapshot;
  Outliers outliers;
  ExternalChoices external;
  PointGrid mover_grid;
  std::shared_ptr<Executor> executor;
  SerialExecutor serial;
  std::vector<Worker> workers;             // as many as the executor has
  std::vector<std::uint32_t> due;          // slots, by pace, where clocks are free
  bool torn = false;                       // a step ended when some robots had moved and others not
  bool changed = true;                     // robots came or went
  std::atomic<bool> has_new_goals = true;  // since find_shared_goals()
  std::vector<Shares> shares_goal;         // by rank; empty where no robots share anything
  TakenGoals taken_goals;
  FleetSummary summary;
  double near = 0.0;  // m, typical of Fleet::range
  // the step at which the cells are chosen anew and the robots put in order
  std::int64_t next_layout = 1;
  std::int64_t robot_steps = 0;  // measured

  World(const Scenario& scenario, std::shared_ptr<Executor> steps_by);
  /// Reserves memory, so that steps allocate nothing. Without it they allocate where they must.
  void reserve_workers() noexcept;

  const Planner& planner() const { return paces.front().planner; }
  /// The present moment of measurements, see Senses.
  std::int64_t moment() const { return senses.by_time ? now : steps; }
  /// s, since the start of the run.
  double time() const {
    return fleet.has_clocks ? seconds(now) : static_cast<double>(steps) * settings.time_step;
  }
  const Pace& pace(std::size_t slot) const { return paces[fleet.pace_of(slot)]; }
  /// m: the robot has arrived once it is that near to its goal.
  double arrival_distance(std::size_t slot) const {
    return fleet.own_arrival_distance(slot).value_or(settings.arrival_distance);
  }
  /// The index of the pace of such a robot; a missing pace is made. may_replace: the new pace may
  /// replace a pace of no robot, where all robots are in the fleet.
  std::uint32_t pace_of(const RobotSetup& setup, bool may_replace = false);
  /// The common planner of the robots with a certificate; the scene's where there are none.
  const Planner& certified_planner() const;
  /// Number of neighbors that the planner is given as the nearest.
  std::size_t most_nearest() const;
  /// A certificate must also know all others within the sensing radius.
  bool all_matter() const;
  bool all_matter_to(std::size_t slot) const {
    return pace(slot).planner.options().certificate != Certificate::none;
  }
  bool is_fast(std::size_t slot) const;
  std::size_t floor_of(std::size_t slot) const {
    return floor.empty() ? 0 : floor[static_cast<std::size_t>(fleet.rank[slot])];
  }
  const Routes& routes_of(std::size_t slot) const { return routes[floor_of(slot)]; }
  Routes& routes_of(std::size_t slot) { return routes[floor_of(slot)]; }
  /// Returns whether the start_time of the robot is yet to come.
  bool waits_to_start(std::size_t slot) const {
    return !fleet.rare.empty() &&
           avo::waits_to_start(fleet.rare[static_cast<std::size_t>(fleet.rank[slot])].start_time,
                               time());
  }
  /// m/s: what the robot prefers in place of a route to its goal; none where it goes to its goal.
  std::optional<Vec2> steered(std::size_t slot) const {
    return waits_to_start(slot) ? Vec2{} : fleet.told_velocity(slot);
  }
  bool steers_some() const { return !fleet.told.empty() || !fleet.rare.empty(); }
  bool has_routes() const;
  bool has_passages() const;  // on some floor
  /// m: the final target of the robot, its goal or the nearest place to it.
  Vec2 end_of(std::size_t slot) const {
    if (travels.empty()) return fleet.goal[slot];
    return travels[static_cast<std::size_t>(fleet.rank[slot])].heads_for(fleet.goal[slot]);
  }
};

/// Computes the future places of obstacles with a path, if they are not known yet. Robots that
/// sense exactly and decide at the same times know them.
void foresee(World& world);

/// Builds the grids of walls and finds the passages, where walls are new or a robot is larger or
/// reaches farther than before.
void find_walls(World& world);

/// Finds the robots that have the same goal as another one, where goals are new.
void find_shared_goals(World& world);

/// Returns whether the robot moves to its goal, and there is no room there for it and another one
/// (docs/arrival.md, rule 4).
bool shares_room(const World& world, std::size_t slot);
/// heading: by its route, before the rules of passages. lost: see own_error().
Seeker seeker_of(const World& world, std::size_t slot, const Heading& heading, Vec2 lost);
/// Returns whether a robot for which shares_room() was true has come to rest, at its goal or as
/// near as there was room.
bool rests_at_place(const World& world, std::size_t slot);
/// The decision of a robot that stops.
Plan stop_of(const World& world, std::size_t slot);

/// Reserves memory for the walls near a robot and its search for a route in a step.
void make_room(World& world);

/// Fills in what the robots of the worker's tile know of themselves, and their preferred
/// velocities. The tile has their neighbors, and pointers to their memory. worker.staying: the
/// robots that stop near goals that others share.
void set_out(const World& world, const Pace& pace, std::span<const Claims> claims,
             std::span<const std::uint32_t> slots, Worker& worker);

/// Gives the robots of the worker's tile what they remember.
void recall(World& world, std::span<const std::uint32_t> slots, Worker& worker);
/// Moves the robots of the worker's tile, which have decided.
void move(World& world, const Pace& pace, Worker& worker);

/// One sensing-acting cycle of all robots.
void step(World& world);

}  // namespace avo::inline sim
