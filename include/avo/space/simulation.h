// SPDX-License-Identifier: Apache-2.0
// A fleet in space, step by step (docs/space.md). SI units.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/export.h"
#include "avo/ids.h"
#include "avo/space/planner.h"
#include "avo/space/scenario.h"

namespace avo::space {

struct Explanation;

/// Simulates the robots of a scene. Each robot decides alone, from the positions and velocities of
/// those within the sensing radius. The same scene gives the same bits, whatever the number of
/// threads.
class AVO_API Simulation {
 public:
  /// threads: workers, 0: one for each processor. Throws Error as validate() does.
  explicit Simulation(const Scenario& scenario, int threads = 1);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// All robots decide, and move.
  void step();

  /// Returns whether the next step ends by that time, s.
  [[nodiscard]] bool can_step_by(double time) const;

  [[nodiscard]] double time() const;         ///< s
  [[nodiscard]] std::int64_t steps() const;  ///< taken so far
  [[nodiscard]] std::size_t size() const;    ///< number of robots
  [[nodiscard]] int threads() const;         ///< that a step may use
  /// The scene, with the present goals, boxes and moving obstacles.
  [[nodiscard]] const Scenario& scenario() const;
  /// The states of all robots, in the order of the scene: robot k has the id k. Valid until the
  /// next step.
  [[nodiscard]] std::span<const Robot> robots() const;
  /// The last decisions, in that order; those before the first step are empty. Their `neighbor`,
  /// `box` and `mover` are -1, because no lists are given: see touched().
  [[nodiscard]] std::span<const Plan> plans() const;
  /// What a robot touches, or will touch although it brakes: one of the three is set.
  struct Touched {
    std::optional<RobotId> robot = {};
    std::optional<ObstacleId> obstacle = {};
    std::optional<MovingObstacleId> moving_obstacle = {};
  };
  /// Set where the robot's last decision is `overlapping`; Plan::depth says how deep.
  [[nodiscard]] std::optional<Touched> touched(RobotId robot) const;
  /// The moving obstacles as they are now, exactly, by ascending id; valid until the next step or
  /// edit.
  [[nodiscard]] std::span<const Mover> movers() const;
  /// Their ids; those of the scene are 0, 1, ...
  [[nodiscard]] std::span<const MovingObstacleId> moving_obstacle_ids() const;
  /// Where each was at the start of the last step, or when it came or was changed since.
  [[nodiscard]] std::span<const MoverState> movers_before() const;
  /// m. Throws Error, as all questions about one robot do, for a robot that does not exist.
  [[nodiscard]] Vec3 goal(RobotId robot) const;
  /// Returns whether the robot is within the arrival distance of its goal. With `navigation`, no
  /// box may be between it and a goal that it can reach.
  [[nodiscard]] bool is_at_goal(RobotId robot) const;
  [[nodiscard]] bool all_at_goal() const;

  /// The rest of a robot's route.
  struct Route {
    double length = 0.0;  ///< m; infinite for robots that unreachable() names
    Vec3 next = {};       ///< m: the next point of the route, a bend or its end
    /// m, from its end to the goal: 0, unless boxes keep the robot from its goal
    double distance_left = 0.0;
  };
  /// The route that the robot knows: around boxes with `navigation`, else straight.
  [[nodiscard]] Route route(RobotId robot) const;
  /// Robots for which there is no route to their goals, whatever the others do: by ascending id.
  /// They go as near as they get.
  [[nodiscard]] std::vector<RobotId> unreachable() const;

  /// The robot for which another robot waits at a passage of one lane (docs/space.md, "Routes and
  /// passages").
  struct Wait {
    Vec3 passage = {};    ///< m: the middle of its axis
    RobotId robot;        ///< the robot that comes towards it, or stands in its path
    bool inside = false;  ///< whether that robot is in the passage
  };
  /// What a robot senses and wants now. What it senses comes in the order in which it plans:
  /// space::Planner::plan() makes the decision of the next step of it, bit for bit.
  struct Perception {
    Robot robot;                             ///< with its preferred velocity
    std::vector<Neighbor> neighbors = {};    ///< by ascending ids, as sensed
    std::vector<RobotId> neighbor_ids = {};  ///< of the neighbors
    std::vector<Box> boxes = {};             ///< all that matter to it
    std::vector<ObstacleId> box_ids = {};    ///< of the static obstacles that the boxes are of
    std::vector<Mover> movers = {};          ///< as sensed
    std::vector<MovingObstacleId> mover_ids = {};  ///< of the movers
    Detour detour = {};                            ///< what it remembers
    std::optional<Wait> wait = {};                 ///< at a passage, if it waits
    Guide guide = Guide::route;                    ///< what its preferred velocity leads to
  };
  /// Nothing moves. The call uses the scratch memory of the simulation, though it is const: no
  /// other call may run at the same time.
  [[nodiscard]] Perception perceive(RobotId robot) const;
  /// The decision that the robot makes in the next step, with its reasons
  /// (avo/space/explanation.h). Nothing moves. As perceive(), it excludes other calls.
  [[nodiscard]] Explanation explain(RobotId robot) const;

  /// Gives the robot another goal, m; the same goal again changes nothing. Throws Error for a robot
  /// that does not exist, and for a goal that is not finite.
  void set_goal(RobotId robot, Vec3 goal);
  /// A moving obstacle comes: a helicopter, a ball, or a player that the host moves. With a
  /// trajectory it is where the trajectory says at the present time. Throws Error on bad values.
  /// Under a certificate the obstacle may touch no robot, and all robots can brake before it. It
  /// has to be sensed from within the scene's sensing_radius. Throws Error otherwise, and changes
  /// nothing where it throws.
  MovingObstacleId add_moving_obstacle(const MovingObstacle& obstacle);
  /// Changes the moving obstacle: its place, velocity, radius, limits and trajectory are those of
  /// `obstacle` from now on. Robots count on no more than max_deviation and max_speed say. What the
  /// host changes faster they evade as well as they can, and nothing is promised of it. Throws
  /// Error on bad values, and if there is none of that id. Changes nothing where it throws.
  void change_moving_obstacle(MovingObstacleId id, const MovingObstacle& obstacle);
  void remove_moving_obstacle(MovingObstacleId id);  ///< throws Error if there is none of that id
  /// Replaces all boxes between two steps. Throws Error, and changes nothing, where a robot is in a
  /// box or cannot brake before it.
  void set_boxes(std::span<const Box> boxes);

  /// A hash of all positions and velocities, bit for bit.
  [[nodiscard]] std::uint64_t state_hash() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::space
