// SPDX-License-Identifier: Apache-2.0
// A fleet of robots that each plan alone. They plan at the same time, each from the same
// generation, or, where clocks are free, each at its own times.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/executor.h"
#include "avo/export.h"
#include "avo/fleet_view.h"
#include "avo/ids.h"
#include "avo/planner.h"
#include "avo/scenario.h"

namespace avo {

/// The duration of one stage of the steps, e.g. the search for neighbors.
struct StageTime {
  const char* name = "";
  double nanoseconds = 0.0;  ///< sum over all threads
};

/// Sums over the steps that were measured.
struct StepProfile {
  std::int64_t robot_steps = 0;
  std::int64_t pairs = 0;       ///< neighbors for which a half-plane was computed
  std::int64_t infeasible = 0;  ///< decisions with a violation
  std::vector<StageTime> stages = {};
};

struct Explanation;

/// The state of a fleet, and its steps.
class AVO_API Simulation {
 public:
  /// Throws Error on a bad scenario (see validate), on a scenario that breaks the assumptions of
  /// its certificate (see complaints), or threads not in [0, 1024]. 0: as many threads as
  /// processors that this process may use. Scenario::allow_broken_assumptions accepts the second
  /// kind. Pairs that braking does not keep apart must then keep the distance that braking does
  /// keep. No overlap grows deeper than braking makes it, and the decisions of these robots say
  /// `overlapping`.
  explicit Simulation(const Scenario& scenario, int threads = 0);
  /// Continues from what another simulation saved: a checkpoint, or a reported state. The bytes
  /// hold the scene as well. Throws Error as restore() does, and on the number of threads.
  explicit Simulation(std::span<const std::byte> saved, int threads = 0);
  /// Runs on the host's own threads: the executor steps large fleets, from 256 robots on; the
  /// thread that calls step() steps smaller ones. Throws Error also where there is no executor, or
  /// where its workers are not 1 to 1024. Simulations may share an executor, and step at the same
  /// time if it can run tasks for both.
  Simulation(const Scenario& scenario, std::shared_ptr<Executor> executor);
  Simulation(std::span<const std::byte> saved, std::shared_ptr<Executor> executor);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// One sensing-acting cycle of all robots: they decide from the present generation and move by
  /// Δt. Where clocks are free, each robot decides when its own step ends, from the present states.
  /// All then move to the next instant at which any robot decides. The result is bit-identical for
  /// any number of threads. A warm simulation allocates nothing, unless a robot searches for a
  /// route among many walls, or around a held passage, or has an external method, or decides again
  /// after the host has moved it. Where memory runs out it throws std::bad_alloc. If no robot has
  /// moved by then, the step can be tried again; otherwise every later step throws Error.
  /// Robots of an external method first get their velocities from its function. Where there is
  /// none, where it throws, or where a velocity is not finite, the step throws and has moved
  /// no robot. Hosts with frames of any length that look for step(dt): see can_step_by(), and
  /// docs/manual/howto/host.md, "Time".
  void step();

  /// Sets the function behind the scene's external_method. A simulation that was made from saved
  /// bytes needs it: they hold the name alone.
  void set_external(ExternalMethod method);

  /// Throws Error on bad values. Under a certificate it also throws Error on a robot that would
  /// have to be seen from farther away than the sensing radius. The same holds for a start from
  /// which the certificate cannot keep the robot from obstacles, and from the others as they move
  /// now. The scene may allow such starts, as above. A parked robot is added like an obstacle: it
  /// costs as much, and is also refused as in add_obstacle(). Changes nothing where it throws.
  RobotId add_robot(const RobotSetup& setup);
  void remove_robot(RobotId robot);  ///< throws Error if there is no such robot
  /// Sets a goal. The robot forgets what it remembers of the route to its old goal (Detour), except
  /// the congestion. The goal that it has already changes nothing. Throws Error if there is no such
  /// robot, or it is parked.
  void set_goal(RobotId robot, Vec2 goal);
  /// Puts the robot down elsewhere, at rest; an airplane keeps its velocity. The effect is that of
  /// a new robot with the same number: it forgets what it remembers, and is refused as in
  /// add_robot(). Throws Error if there is no such robot, or it is parked. Changes nothing where it
  /// throws.
  void move_robot(RobotId robot, Vec2 position);

  /// Changes what the robot can do and how it behaves: all of its setup but its state, goal, model
  /// and time_step. These are not read, except that another model or time_step is refused. A robot
  /// at rest can be parked where it stands, and a parked robot set free. Both cost as much as
  /// add_obstacle(), and its goal is then its place. Others know the new values at once. Throws
  /// Error as add_robot() does on values that break what the certificate assumes. Examples are a
  /// larger disc, other brakes or other layers where the robot is now. A robot that is faster than
  /// its new max_speed slows down, and others allow for that. Where clocks are free and there is a
  /// certificate, only speeds, priority, horizon and arrival distance change. The robot keeps what
  /// it remembers. Changes nothing where it throws.
  void change_robot(RobotId robot, const RobotSetup& setup);
  /// The teams of its scene, which each step leads: serve a queue, or change the members. Valid
  /// until restore().
  [[nodiscard]] std::span<Team> teams();
  /// Sets the preferred velocity, m/s, that the robot has from now on, in place of a route to its
  /// goal. With none it goes to its goal again. Meanwhile the robot has no goal: is_at_goal() is
  /// false, and it takes no part in the rules for passages and goals. The certificate holds as
  /// before. Throws Error if there is no such robot, it is parked, or the velocity is not finite.
  void set_preferred_velocity(RobotId robot, std::optional<Vec2> velocity);
  /// Moves the robot from now on: after each step it has this velocity, m/s, whatever is in its
  /// way, e.g. a player. It decides nothing and keeps no promise. Others see it and keep clear of
  /// it alone: meanwhile avoids of its setup is empty. As long as the velocity changes by at most
  /// max_acceleration * time_step a step, it touches no robot that avoids it and is in motion.
  /// Where motion is exponential, δ (1 - e^{-Δt/δ}) takes the place of time_step. With none it
  /// brakes with max_braking. It decides again once it rests, every robot in motion could stop
  /// before it, and the scene allows its setup. The first call throws Error as change_robot() does.
  /// Every call throws Error if the velocity is faster than max_speed, if the robot is parked or
  /// has a heading, and in scenes with free clocks or execution.
  void set_velocity(RobotId robot, std::optional<Vec2> velocity);
  /// The same calls for many robots: one goal, velocity or setup for each robot. Where one of them
  /// is refused, they throw Error, and nothing has changed.
  void set_goals(std::span<const RobotId> robots, std::span<const Vec2> goals);
  void set_preferred_velocities(std::span<const RobotId> robots, std::span<const Vec2> velocities);
  std::vector<RobotId> add_robots(std::span<const RobotSetup> setups);
  void remove_robots(std::span<const RobotId> robots);
  /// The velocity that set_preferred_velocity() gave to the robot. Throws Error, as all questions
  /// about one robot do, if there is no such robot.
  [[nodiscard]] std::optional<Vec2> preferred_velocity(RobotId robot) const;
  /// The velocity that set_velocity() gave to the robot, until it is taken back.
  [[nodiscard]] std::optional<Vec2> host_velocity(RobotId robot) const;
  /// Returns whether the host moves the robot, or the robot brakes since the host gave it back. It
  /// decides nothing meanwhile.
  [[nodiscard]] bool is_moved(RobotId robot) const;
  /// A moving obstacle comes: a person, a vehicle, or a player that the host moves. With a
  /// trajectory it is where the trajectory says at the present time. Throws Error on bad values
  /// (see validate). Under a certificate it also throws Error, with the arithmetic, on an obstacle
  /// that some robot cannot keep clear of. Changes nothing where it throws.
  MovingObstacleId add_moving_obstacle(const MovingObstacle& obstacle);
  /// Changes the moving obstacle: its place, velocity, radius, limits and path are those of
  /// `obstacle` from now on. Robots count on no more than max_deviation and max_speed say. The host
  /// may change the obstacle faster than these allow, as a player that turns at once. Robots then
  /// evade it as well as they can, and nothing is promised. Throws Error on bad values, and if
  /// there is none of that id. Changes nothing where it throws.
  void change_moving_obstacle(MovingObstacleId id, const MovingObstacle& obstacle);
  void remove_moving_obstacle(MovingObstacleId id);  ///< throws Error if there is none of that id
  /// A door closes: from the next step on no robot may touch the obstacle. Throws Error on bad
  /// values (see validate). Under a certificate it also throws Error, with the arithmetic, on an
  /// obstacle that some robot would touch if it braked at once. The same holds for an obstacle that
  /// leaves a robot on the wrong side of its Fill. The call costs time even if no robot is near.
  /// The grid of walls and the maps of all goals are made anew, and all robots search for their
  /// routes. That takes at most as long as making the simulation; docs/navigation.md has figures.
  /// Many walls that come together are best one obstacle. Changes nothing where it throws.
  ObstacleId add_obstacle(const StaticObstacle& obstacle);
  /// A door opens. The call costs as much as add_obstacle(). Throws Error if there is no such
  /// obstacle.
  void remove_obstacle(ObstacleId obstacle);

  /// Returns the state and the setup as bytes, the same on every machine. A robot takes 64 bytes of
  /// state and 88 of setup (goal, radius, limits, wheelbase, priority, parked, layers). Its aim
  /// takes 8 more where there are walls or movers at rest (24 where walls keep it from its goal).
  /// Its last states are added where the scene's sensing delays or misses measurements
  /// (docs/saving.md). A simulation made from the bytes has an equal state_hash() and an equal
  /// future, for any number of threads. The bytes do not hold data of the last step or of the past:
  /// sums of measure(), Metrics, plan and applied_acceleration of fleet(). The last two are
  /// value-initialized until the next step. Throws Error where a step ended in the midst.
  [[nodiscard]] std::vector<std::byte> save() const;
  /// Goes back, or forth, to a state that this simulation or another one of the same settings has
  /// saved: a rollback, which keeps the threads. Robots, goals, obstacles and ids become those that
  /// were saved; ids that were given since may come again.
  /// Static obstacles that differ from the present ones cost as much as an edit. Throws Error on
  /// bytes that are cut off, changed, of another version of the library or of another scene;
  /// changes nothing where it throws. It repairs a simulation in which a step ended in the midst.
  void restore(std::span<const std::byte> saved);

  /// Returns the columns that are wanted; the others are empty. Use robot() to look at few robots.
  [[nodiscard]] FleetView fleet(Columns wanted = Columns::all) const;
  [[nodiscard]] std::size_t size() const;  ///< robots
  /// Changes whenever robots come, go or are restored, and is unique among simulations. As long as
  /// it stays, the ids stay and, except states and goals, the setups.
  [[nodiscard]] std::uint64_t roster() const;
  /// The state of one robot. The call takes no longer in a large fleet.
  [[nodiscard]] RobotState robot(RobotId robot) const;
  [[nodiscard]] RobotSetup setup(RobotId robot) const;  ///< see FleetView::setup
  /// The robot's row in the columns of fleet(). The row differs from the value of the id once
  /// another robot has been removed or has left. It is none if the robot itself is gone.
  [[nodiscard]] std::optional<std::size_t> index_of(RobotId robot) const;
  /// Robots with discs within `radius`, m, of the point, the nearest disc first. This query and the
  /// next three find what is near in a grid, which the first one after a change makes. A query then
  /// takes as long as it has to look at.
  [[nodiscard]] std::vector<RobotId> robots_within(Vec2 center, double radius) const;
  /// The robots with the discs nearest to the point, at most `count`, nearest first.
  [[nodiscard]] std::vector<RobotId> nearest_robots(Vec2 position, std::size_t count) const;
  /// Returns whether a disc of that radius, m, > 0, would touch no robot, no moving obstacle and no
  /// wall there. It must not be inside a solid or outside of bounds either. layers, here and below:
  /// only robots that are in one of them count, and static obstacles that a robot in them heeds.
  /// All moving obstacles and parked robots count.
  [[nodiscard]] bool is_free(Vec2 position, double radius, LayerSet layers = kAllLayers) const;
  /// What a ray, or a moving disc, touches first: one of the three is set.
  struct Hit {
    double distance = 0.0;  ///< m, from the start; 0 where it touches from the start
    Vec2 center = {};       ///< m, of the disc then
    std::optional<RobotId> robot = {};
    std::optional<MovingObstacleId> moving_obstacle = {};
    std::optional<ObstacleId> obstacle = {};
  };
  /// None where a disc of that radius, m, >= 0, touches nothing that stands now between the points.
  [[nodiscard]] std::optional<Hit> cast_ray(Vec2 from, Vec2 to, double radius = 0.0,
                                            LayerSet layers = kAllLayers) const;
  /// Returns whether no static obstacle stops a disc of that radius, m, >= 0, on the straight line
  /// between the points. Robots and moving obstacles do not count.
  [[nodiscard]] bool is_in_sight(Vec2 from, Vec2 to, double radius = 0.0,
                                 LayerSet layers = kAllLayers) const;
  [[nodiscard]] StaticObstacleView obstacles() const;  ///< the static obstacles
  [[nodiscard]] MovingObstacleView moving_obstacles() const;
  [[nodiscard]] double time() const;  ///< s: steps() * time_step, or the instant of free clocks
  [[nodiscard]] std::int64_t steps() const;
  /// m: how far robots sense. Where the scene gives no sensing_radius, an added robot that needs
  /// more makes it grow; it does not shrink while there are robots.
  [[nodiscard]] double sensing_radius() const;
  /// Returns whether the next step ends by that time, s.
  [[nodiscard]] bool can_step_by(double time) const;
  /// s: when the robot decides next. It is now, where the clock is common; it is infinite if the
  /// robot is parked or the host moves it.
  [[nodiscard]] double next_decision(RobotId robot) const;
  /// Returns whether the robot decided in the last step; all robots that were present then count.
  [[nodiscard]] bool decided(RobotId robot) const;
  /// Returns whether the robot is within arrival_distance now, with no wall between it and its
  /// goal. For a goal that it cannot reach, no wall may be between it and the nearest place. A
  /// robot also counts if it rests as near as others at rest leave room. Their goals are then too
  /// close together for all of them (docs/arrival.md, rule 4).
  [[nodiscard]] bool is_at_goal(RobotId robot) const;
  [[nodiscard]] bool all_at_goal() const;
  /// The rest of a robot's route.
  struct Route {
    double length = 0.0;  ///< m; infinite for robots that unreachable() names
    Vec2 next = {};       ///< m: the first point on the route, a corner of a wall or its end
    /// m, from its end to the goal: 0, unless walls keep the robot from its goal. Then the route
    /// ends at the nearest place that the robot can reach.
    double distance_left = 0.0;
  };
  /// The shortest route to its goal that the robot knows: around walls with navigation
  /// (docs/navigation.md), else straight. The call takes no longer where there are many walls.
  [[nodiscard]] Route route(RobotId robot) const;
  /// Robots that could reach neither their goals nor a place within arrival_distance of them, even
  /// alone. The time of the goals, or of the last edit of obstacles, counts. Either walls leave no
  /// route that is wide enough, or the goal is nearer to a wall than the radius. With navigation
  /// they go to the nearest place, see Route::distance_left, and go on when a door opens.
  /// By ascending id.
  [[nodiscard]] std::vector<RobotId> unreachable() const;
  /// The robot for which another robot waits at a passage of one lane (docs/arrival.md, rules 7 to
  /// 9).
  struct Wait {
    Vec2 passage = {};    ///< m: the middle of its axis
    RobotId robot;        ///< the robot that comes towards it, or stands in its path
    bool inside = false;  ///< whether that robot is in the passage
    Vec2 a = {}, b = {};  ///< m: the two sides of the passage where it is narrowest
  };
  /// None where the robot waits at no passage.
  [[nodiscard]] std::optional<Wait> wait(RobotId robot) const;
  /// Equal for equal states, bit by bit: the determinism contract, which any user can test.
  [[nodiscard]] std::uint64_t state_hash() const;

  /// What a robot would see and decide now: itself with its preferred velocity, and its neighbors
  /// as sensed. The neighbors have the order in which it plans with them.
  struct Perception {
    Robot robot;
    std::vector<Neighbor> neighbors;  ///< empty for a parked robot
    /// The value of each neighbor's RobotId, or -1 - k with the value k of a MovingObstacleId
    std::vector<std::int64_t> source;
    Detour detour = {};         ///< what it remembers
    bool among_movers = false;  ///< no other decides: planned by plan_among_movers (§III-C)
    /// All walls that matter to it, and more. They are where the robot sees them, which depends on
    /// the error of its own place.
    std::vector<Wall> walls = {};
    /// The value of each wall's ObstacleId. For the disc of a parked robot, -1 - k with the value k
    /// of its RobotId
    std::vector<std::int64_t> wall_source = {};
    /// For a robot that brakes until it stands, near a goal that others share (docs/arrival.md,
    /// rule 4). This is its decision, whatever it would plan, unless that is `overlapping`.
    std::optional<Plan> stop = {};
    /// The trajectories that neighbors have: copies of this object share them.
    std::vector<std::shared_ptr<const Trajectory>> trajectories = {};
    std::optional<Wait> wait = {};  ///< the robot that it waits for at a passage, if at one
    Guide guide = Guide::route;     ///< what its preferred velocity leads to
  };
  [[nodiscard]] Perception perceive(RobotId robot) const;
  /// The decision that the robot would make now, with its reasons (avo/explanation.h). Throws Error
  /// if it is parked. The function of an external method is asked about this robot alone.
  [[nodiscard]] Explanation explain(RobotId robot) const;
  [[nodiscard]] const Planner& planner() const;               ///< of the scene's method
  [[nodiscard]] const Planner& planner(RobotId robot) const;  ///< that this robot plans with

  /// Starts or stops the measurement of steps; the sums begin anew.
  void measure(bool on);
  [[nodiscard]] StepProfile profile() const;
  [[nodiscard]] int threads() const;  ///< that a step may use

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
