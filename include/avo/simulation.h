// SPDX-License-Identifier: Apache-2.0
// A fleet of robots that all plan alone: at the same time, each from the same generation, or, where
// clocks are free, each at times of its own.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/executor.h"
#include "avo/export.h"
#include "avo/planner.h"
#include "avo/scenario.h"

namespace avo {

/// Stable name of a robot; never reused within a simulation.
struct RobotId {
  std::uint64_t value = 0;  ///< robots of the scenario are 0, 1, ... in its order
  friend constexpr bool operator==(RobotId, RobotId) = default;
};

/// Stable name of a static obstacle; never reused within a simulation.
struct ObstacleId {
  std::uint64_t value = 0;  ///< obstacles of the scenario are 0, 1, ... in its order
  friend constexpr bool operator==(ObstacleId, ObstacleId) = default;
};

/// Columns of a FleetView. Each costs a copy of the fleet's, once a generation.
enum class Columns : std::uint16_t {
  id = 1,
  position = 2,
  velocity = 4,
  heading = 8,
  goal = 16,
  setup = 32,
  detour = 64,
  plan = 128,
  applied_acceleration = 256,
  all = 511,
};
/// Those of both.
constexpr Columns operator|(Columns a, Columns b) {
  return static_cast<Columns>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
/// Whether each of `some` is one of `all`.
constexpr bool includes(Columns all, Columns some) {
  return (static_cast<unsigned>(some) & ~static_cast<unsigned>(all)) == 0;
}

/// Columns of the present generation, one entry a robot, by ascending id. Valid until the next
/// call that changes the simulation.
struct FleetView {
  std::span<const RobotId> id;
  std::span<const Vec2> position;     ///< m
  std::span<const Vec2> velocity;     ///< m/s
  std::span<const double> heading;    ///< rad; of cars, 0 for others
  std::span<const Vec2> goal;         ///< m
  std::span<const RobotSetup> setup;  ///< the constant part (radius, limits, car)
  std::span<const Detour> detour;     ///< what each remembers; method avo only
  std::span<const Plan> plan;         ///< of its last decision; value-initialized before the first
  /// m/s^2, the largest |a| within the last step; of a car with the exact set the larger part of
  /// it, along the heading or across.
  std::span<const double> applied_acceleration;
};

/// One robot's entries in the columns that steps change.
struct RobotState {
  RobotId id;
  Vec2 position, velocity;            ///< m, m/s
  double heading = 0.0;               ///< rad; of cars, 0 for others
  Vec2 goal;                          ///< m
  Detour detour;                      ///< see FleetView
  Plan plan;                          ///< see FleetView
  double applied_acceleration = 0.0;  ///< m/s^2, see FleetView
};

/// Columns of the moving obstacles, in the order of the scene. Valid as FleetView is.
struct ObstacleView {
  std::span<const Vec2> position;
  std::span<const Vec2> velocity;
  std::span<const MovingObstacle> setup;
  std::span<const std::uint32_t> target;  ///< index of the point of its path that it goes for
};

/// By ascending id. Valid until the next call that changes the simulation.
struct StaticObstacleView {
  std::span<const ObstacleId> id;
  std::span<const StaticObstacle> setup;
};

/// What one stage of the steps took, e.g. the search for neighbors.
struct StageTime {
  const char* name = "";
  double nanoseconds = 0.0;  ///< of all threads together
};

/// Sums over the steps that were measured.
struct StepProfile {
  std::int64_t robot_steps = 0;
  std::int64_t pairs = 0;       ///< neighbors that a half-plane was asked of
  std::int64_t infeasible = 0;  ///< decisions with a violation
  std::vector<StageTime> stages = {};
};

/// The state of a fleet, and its steps.
class AVO_API Simulation {
 public:
  /// Throws Error on a bad scenario (see validate), on one that breaks what its certificate assumes
  /// (see complaints), or threads not in [0, 1024]. 0: as many as this process may use processors.
  /// With Scenario::allow_broken_assumptions the second kind is accepted: pairs that braking does
  /// not keep apart are held to the distance that it does keep, so that no overlap grows deeper
  /// than braking makes it, and their decisions say `overlapping`.
  explicit Simulation(const Scenario& scenario, int threads = 0);
  /// Goes on from what another one saved: a checkpoint, or a state that someone reports. The bytes
  /// hold the scene as well. Throws Error as restore() does, and on the number of threads.
  explicit Simulation(std::span<const std::byte> saved, int threads = 0);
  /// The same on the host's own threads: large fleets are stepped by the executor, from 256 robots
  /// on; smaller ones by whoever calls step(). Throws Error also where there is none, or where its
  /// workers are not 1 to 1024. Other simulations may have the same one, and step at the same time
  /// if it can run tasks for both.
  Simulation(const Scenario& scenario, std::shared_ptr<Executor> executor);
  Simulation(std::span<const std::byte> saved, std::shared_ptr<Executor> executor);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// One sensing-acting cycle of all robots: decide from the present generation, move by Δt. Where
  /// clocks are free: those whose own step ends now decide, from the states of now, and all move to
  /// the next instant at which anybody decides.
  /// Bit-identical for any number of threads. Allocates nothing once warm, but where a robot
  /// searches for a way among many walls, or around a held passage. Where memory runs out it
  /// throws std::bad_alloc: either before anyone has moved, so that the step can be tried again, or
  /// after some have, and then every later step throws Error.
  void step();

  /// Throws Error on bad values, and under a certificate on a robot that would have to be seen from
  /// farther away than the sensing radius, or that starts where the certificate cannot keep it from
  /// the others, as they move now, and from obstacles; the scene may allow for such starts, as
  /// above. One that is parked is added like an obstacle, and costs and is refused as in
  /// add_obstacle() besides. Changes nothing where it throws.
  RobotId add_robot(const RobotSetup& setup);
  void remove_robot(RobotId robot);  ///< throws Error if there is no such robot
  /// The robot forgets what it remembers of the way to its old goal (Detour), but the congestion.
  /// The goal that it has already changes nothing. Throws Error if there is no such robot, or it is
  /// parked.
  void set_goal(RobotId robot, Vec2 goal);
  /// Somebody puts the robot down elsewhere, at rest; an airplane keeps its velocity. As if another
  /// one of its number had come: it forgets what it remembers, and is refused as in add_robot().
  /// Throws Error if there is none, or it is parked. Changes nothing where it throws.
  void move_robot(RobotId robot, Vec2 position);

  /// A door closes: from the next step on nobody may touch the obstacle. Throws Error on bad values
  /// (see validate), and under a certificate on an obstacle that some robot would come to touch if
  /// it braked at once, or that leaves a robot on the wrong side of its Fill; with the arithmetic.
  /// Nobody has to be near for it to cost something: the grid of walls and the maps of all goals
  /// are made anew, and all robots look for their ways. That takes at most as long as making the
  /// simulation; docs/navigation.md has figures. Many walls that come together are best one
  /// obstacle. Changes nothing where it throws.
  ObstacleId add_obstacle(const StaticObstacle& obstacle);
  /// A door opens. Costs as much. Throws Error if there is no such obstacle.
  void remove_obstacle(ObstacleId obstacle);

  /// The state and the setup as bytes, the same on every machine, 64 of state and 88 of setup
  /// (goal, radius, limits, wheelbase, priority, parked, layers) a robot, 8 of what it aims at
  /// where there are walls or movers at rest (24 where walls keep it from its goal), and its last
  /// states where the scene's sensing delays or misses measurements (docs/saving.md). Whoever has
  /// them has an equal state_hash() and an equal future, for any number of threads. They do not
  /// hold what only tells of the last step or of the past: plan and applied_acceleration of
  /// fleet(), which are value-initialized until the next step, sums of measure(), Metrics. Throws
  /// Error where a step ended in the midst.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// Back, or forth, to what this simulation or another one of the same settings and moving
  /// obstacles has saved: a rollback, which keeps the threads. Robots, goals, static obstacles and
  /// ids become those that were saved; ids that were given since may come again. Other static
  /// obstacles than the present ones cost as much as an edit. Throws Error on bytes that are cut
  /// off, changed, of another version of the library or of another scene; changes nothing where it
  /// throws. Makes a simulation whole whose step ended in the midst.
  void restore(std::span<const std::byte> saved);

  /// The columns that are wanted; the others are empty. Whoever looks at few robots calls robot().
  [[nodiscard]] FleetView fleet(Columns wanted = Columns::all) const;
  [[nodiscard]] std::size_t size() const;  ///< robots
  /// Another number whenever robots have come or gone or were restored, and of no other simulation.
  /// As long as it stays, so do their ids and, but for states and goals, their setups.
  [[nodiscard]] std::uint64_t roster() const;
  /// The robot at that index into fleet(). Takes no longer where there are many.
  [[nodiscard]] RobotState robot(std::size_t robot) const;
  [[nodiscard]] RobotSetup setup(std::size_t robot) const;  ///< likewise, see FleetView::setup
  /// Index of the robot into fleet(), which is not its number once another one has been removed or
  /// has left; none where it is gone itself.
  [[nodiscard]] std::optional<std::size_t> index_of(RobotId robot) const;
  [[nodiscard]] ObstacleView obstacles() const;
  [[nodiscard]] StaticObstacleView static_obstacles() const;
  [[nodiscard]] double time() const;  ///< s: steps() * time_step, or the instant of free clocks
  [[nodiscard]] std::int64_t steps() const;
  /// m: how far robots sense. Where the scene names no sensing_radius, a robot that is added and
  /// needs more makes it grow; nothing makes it less while robots are there.
  [[nodiscard]] double sensing_radius() const;
  /// Whether the next step ends by that time, s.
  [[nodiscard]] bool can_step_by(double time) const;
  /// s: when the robot (an index into fleet()) decides next. Now, where the clock is common; never,
  /// which is infinite, if it is parked.
  [[nodiscard]] double next_decision(std::size_t robot) const;
  /// Whether it decided in the last step, of all that were there then.
  [[nodiscard]] bool decided(std::size_t robot) const;
  /// Whether the robot (an index into fleet()) is within arrival_distance now, with no wall between
  /// it and its goal; of a goal that it cannot reach, none between it and the nearest place. Or it
  /// rests as near as others at rest leave room, where their goals are too close together for all
  /// of them (docs/arrival.md, rule 4).
  [[nodiscard]] bool is_at_goal(std::size_t robot) const;
  [[nodiscard]] bool all_at_goal() const;
  /// What is left of a robot's way.
  struct Way {
    double length = 0.0;  ///< m; infinite of those that unreachable() names
    Vec2 next = {};       ///< m: where it leads first, a corner of a wall or its end
    /// m, from its end to the goal: 0, unless walls keep the robot from its goal. Then the way ends
    /// at the nearest place that the robot gets to.
    double distance_left = 0.0;
  };
  /// The shortest way to its goal that the robot (an index into fleet()) knows: around walls with
  /// navigation (docs/navigation.md), else straight. Takes no longer where there are many walls.
  [[nodiscard]] Way way(std::size_t robot) const;
  /// Robots that could not get to their goals when these were set, or obstacles edited since, even
  /// alone, nor to a place within arrival_distance of them: walls leave no way that is wide enough,
  /// or the goal is nearer to a wall than the radius. With navigation they go to the nearest place,
  /// see Way::distance_left, and go on when a door opens. By ascending id.
  [[nodiscard]] std::vector<RobotId> unreachable() const;
  /// For whom a robot waits at a passage of one lane (docs/arrival.md, rules 7 to 9).
  struct Wait {
    Vec2 passage = {};  ///< m: the middle of its axis
    RobotId robot;      ///< that comes towards it, or is in the way
  };
  /// None where the robot (an index into fleet()) does not wait at one.
  [[nodiscard]] std::optional<Wait> wait(std::size_t robot) const;
  /// Equal for equal states, bit by bit: the determinism contract, testable by anyone.
  [[nodiscard]] std::uint64_t state_hash() const;

  /// What `robot` (an index into fleet()) would see and decide now: itself with its preferred
  /// velocity, and its neighbors as sensed, in the order in which they are planned with.
  struct Perception {
    Robot robot;
    std::vector<Neighbor> neighbors;   ///< none of one that is parked
    std::vector<std::int64_t> source;  ///< value of the RobotId, or -1 - k for moving obstacle k
    Detour detour = {};                ///< what it remembers
    bool among_movers = false;  ///< nobody else decides: planned by plan_among_obstacles (§III-C)
    /// All that matter to it, and more: where they are as it sees them, whose own place may be off.
    std::vector<Wall> walls = {};
    /// Of one that brakes until it stands, near a goal that others share (docs/arrival.md, rule 4):
    /// its decision, whatever it would plan, unless that is `overlapping`.
    std::optional<Plan> stop = {};
    /// Those that neighbors have: copies of this one have the same.
    std::vector<std::shared_ptr<const Trajectory>> trajectories = {};
    std::optional<Wait> wait = {};  ///< for whom it waits at a passage, if at one
  };
  [[nodiscard]] Perception perceive(std::size_t robot) const;
  [[nodiscard]] const Planner& planner() const;                   ///< of the scene's method
  [[nodiscard]] const Planner& planner(std::size_t robot) const;  ///< that this one plans with

  /// From now on the steps are measured, or no longer; the sums begin anew.
  void measure(bool on);
  [[nodiscard]] StepProfile profile() const;
  [[nodiscard]] int threads() const;  ///< that a step may use

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
