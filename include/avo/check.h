// SPDX-License-Identifier: Apache-2.0
// A judge of recorded motion that shares no formula with the planner. It judges the separation of
// every pair in continuous time, separation from walls, limits on acceleration and speed, limits of
// wheels and wings, and arrival.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "avo/error.h"
#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

// How a recorded robot can move. All but the first have headings. Infinite limits are not checked.

/// Moves in any direction. Between two rows it is on the cubic with their positions and velocities.
struct CheckedHolonomic {};

/// Its position is the middle of its rear axle, and it moves along its heading. From row to row it
/// moves on an arc with constant curvature and constant change of speed, or it turns about its
/// position at rest.
struct CheckedCar {
  /// m, > 0: a car turns at rest only if max_curvature is infinite, and its front axle then moves
  /// at max_speed at most
  double wheelbase = 1.0;
  double max_curvature = std::numeric_limits<double>::infinity();  ///< 1/m, > 0
  double body_offset = 0.0;  ///< m, from the position forward to the disc's center
  bool reverse = false;      ///< may drive backwards
  /// Its accelerations along and across the heading keep max_acceleration each; if false, both
  /// together do.
  bool exact_set = false;
};

/// Two wheels on an axle; the middle of the axle is its position. The velocities of its rows are
/// those of the point `offset` ahead. This point accelerates in any direction, evenly from row to
/// row, so max_speed and max_acceleration are limits of this point.
struct CheckedDrive {
  double track = 0.5;                                            ///< m, > 0, from wheel to wheel
  double offset = 0.2;                                           ///< m, > 0
  double wheel_speed = std::numeric_limits<double>::infinity();  ///< m/s, > 0
  double wheel_acceleration = std::numeric_limits<double>::infinity();  ///< m/s^2, > 0
};

/// Flies along its heading on arcs, as cars drive.
struct CheckedAirplane {
  double min_speed = 0.0;                                                 ///< m/s, >= 0
  double lateral_acceleration = std::numeric_limits<double>::infinity();  ///< m/s^2, > 0
};

/// How a body moves between two rows.
using CheckedKinematics = std::variant<CheckedHolonomic, CheckedCar, CheckedDrive, CheckedAirplane>;

inline bool is_holonomic(const CheckedKinematics& kinematics) {
  return std::holds_alternative<CheckedHolonomic>(kinematics);
}

/// The limits that a recorded robot must keep. Infinite limits are not checked.
struct CheckedRobot {
  double radius = 0.5;            ///< m, > 0, of its disc
  double max_acceleration = 1.0;  ///< m/s^2, > 0
  double max_speed = 2.0;         ///< m/s, > 0
  std::optional<Vec2> goal = {};  ///< m
  /// m, > 0; unset: CheckOptions::arrival_distance
  std::optional<double> arrival_distance = {};
  /// m, >= 0: how far the robot may have been from the judged path between two rows. It is 0 for
  /// accelerations held from row to row, because the path is then the cubic.
  double interpolation_error = 0.0;
  /// The robot changes its velocity at once at every row: straight lines are judged instead of
  /// cubics.
  bool straight = false;
  /// Rows of a car or an airplane without a heading give its velocities alone. Then only the
  /// velocities are judged. The distance of the cubic from the arc is computed from the rows and
  /// granted.
  CheckedKinematics kinematics = {};
  /// The robot may not move at all and must stay at its first row. Two parked robots are not judged
  /// as a pair.
  bool parked = false;
  /// Bits: the robot avoids every robot that is in one of the layers `avoids`. Pairs in which
  /// neither avoids the other are not judged. See also one_sided_contacts_moving.
  std::uint32_t layers = 1, avoids = 0xffffffff;
  /// s, > 0: the robot decides by its own clock. It changes its acceleration (a car the change of
  /// its speed, and its curvature) at no other times. Rows must exist at all of these times; the
  /// first change gives their phase.
  std::optional<double> time_step = {};
  /// m/s^2, > 0: where it is more than max_acceleration, a step may also slow the robot down
  /// straight by that much. It may also combine a part of that with a part of what max_acceleration
  /// allows.
  std::optional<double> max_braking = {};
  /// m, >= 0: where max_acceleration is infinite, how far the positions of two rows may differ from
  /// what their velocities and the change between them explain. Unset: no jump is judged then.
  std::optional<double> largest_jump = {};
  /// m, from the position of a robot with a heading forward: the centers of its discs, each of
  /// `radius`. At most 5, and 1 of a holonomic robot, which has the velocities of the disc. Empty:
  /// the robot is one disc.
  std::vector<double> discs = {};
};

/// A moving obstacle, a disc with a motion that is known in full: p + t v + t²/2 a; or see
/// Check::place_mover().
struct CheckedMover {
  Vec2 position = {}, velocity = {}, acceleration = {};  ///< at time 0
  double radius = 0.5;                                   ///< m, > 0
  bool straight = false;  ///< once placed, it moves straight and evenly from place to place
};

/// A static obstacle: all points within `radius` of the segment from a to b; a disc where a == b.
struct CheckedWall {
  Vec2 a = {};          ///< m
  Vec2 b = {};          ///< m
  double radius = 0.0;  ///< m, >= 0
  /// Bits: robots that are in one of these layers must keep clear of it. All bits: every robot
  /// must.
  std::uint32_t layers = 0xffffffff;
};

/// How strictly the rows are judged.
struct CheckOptions {
  double relative_tolerance = 1e-9;  ///< of the sum of radii, of a_max, of v_max; in [0, 1)
  double arrival_distance = 0.5;     ///< m, > 0
  /// A mover that does not avoid a robot may touch the robot at rest: passive safety promises no
  /// more.
  bool movers_at_rest = false;
};

/// The direction that a robot faces, and its speed along it.
struct CheckedHeading {
  double angle = 0.0;  ///< rad, counter-clockwise from +x
  double speed = 0.0;  ///< m/s along it, < 0: backwards
};

/// A row that cannot be judged.
class AVO_API RowError : public Error {
 public:
  RowError(std::int64_t number, const std::string& message) : Error(message), robot(number) {}
  std::int64_t robot;  ///< position in the list of robots given
};

/// One row of a recording.
struct CheckedState {
  std::int64_t robot = 0;  ///< position in the list of robots given
  Vec2 position, velocity;
  /// Not read for holonomic robots. A drive, and a car with a body_offset that is not zero, must
  /// have one.
  std::optional<CheckedHeading> heading = {};
};

/// One case in which a rule is broken.
struct CheckViolation {
  double time = 0.0;       ///< s; for a rule judged from row to row, the start of the step
  std::int64_t robot = 0;  ///< the lower number of a pair of robots
  std::optional<std::int64_t> other = {};  ///< the other robot of a pair, the obstacle, the wall
  double amount = 0.0;  ///< beyond the limit: m/s^2, m/s, rad, m (of overlap: the most in the step)
};

/// A robot that touched another body that does not avoid it; a pair counts once.
struct CheckedHit {
  double time = 0.0;       ///< s, when the two first touched
  std::int64_t robot = 0;  ///< the robot that was touched
  std::int64_t other = 0;  ///< the moving obstacle, or the other robot: its position in the list
  double depth = 0.0;      ///< m, the deepest
  bool moved = false;      ///< whether the robot itself moved at any time while the two overlapped
};

/// How often a rule was broken.
struct CheckCount {
  std::int64_t count = 0;  ///< of pairs, robots, robot-steps or robot-rows
  std::optional<CheckViolation> first = {};
  double worst = 0.0;  ///< largest amount
};

/// The findings in all rows up to now.
struct CheckReport {
  std::int64_t robots = 0;       ///< robots that were ever present
  std::int64_t rows = 0;         ///< robot-rows
  std::int64_t steps = 0;        ///< between successive times
  std::int64_t robot_steps = 0;  ///< of robots present at both ends of the step: these are judged
  std::int64_t gaps = 0;         ///< returns of a robot that was missing at some time: not judged
  std::int64_t unjudged_steps =
      /// the steps among them with missing rows in between, see Check::skip()
      0;
  double from = 0.0, to = 0.0;       ///< s
  double interpolation_error = 0.0;  ///< m, the largest of a robot-step
  CheckCount overlaps;               ///< pairs of robots that avoid each other and ever overlapped
  CheckCount mover_contacts_moving;  ///< pairs: the robot itself moved while they overlapped
  std::int64_t mover_contacts_at_rest = 0;  ///< all other pairs
  /// all hits of both kinds, by time, robot and mover
  std::vector<CheckedHit> mover_hits;
  /// Pairs of robots in which only one avoids the other: this robot itself moved while they
  /// overlapped.
  CheckCount one_sided_contacts_moving;
  std::int64_t one_sided_contacts_at_rest = 0;  ///< all other pairs
  /// all hits of both kinds, by time, robot and other robot
  std::vector<CheckedHit> one_sided_hits;
  CheckCount static_contacts;  ///< robots that ever touched a wall
  /// Robot-steps with |Δv|/Δt > a_max, or beyond what max_braking allows. With headings, |Δs|/Δt of
  /// the speed s counts. For a car that must keep a_max in both directions together, the lateral
  /// acceleration counts too.
  CheckCount accelerations;
  CheckCount speeds;  ///< robot-rows with |v| > v_max
  /// Robot-steps with |Δp - Δt (v_0 + v_1)/2| > a_max Δt²/2: the positions do not follow the
  /// velocities. A motion within a_max stays below half of this bound. If the velocity changes at
  /// once, by a_max Δt at most, the motion stays just within the bound. Where a_max is infinite,
  /// the bound is Δt |v_1 - v_0|/2 + largest_jump; its first part covers any time of the change
  /// within the step. With headings, robot-steps count that leave their arc, or the motion that a
  /// drive makes of the velocities.
  CheckCount jumps;
  /// With headings, robot-rows in which the velocity is not the speed along the heading.
  CheckCount headings;
  /// Robot-steps in which a car turns by more than max_curvature times its distance, or at rest by
  /// more than it can.
  CheckCount turns;
  CheckCount lateral_accelerations;  ///< robot-steps of cars and airplanes, at their higher speed
  /// Robot-steps in which a car drives backwards although it may not, or backwards and forwards.
  CheckCount reversals;
  CheckCount slow_flights;           ///< robot-rows of airplanes with s < min_speed
  CheckCount wheel_speeds;           ///< robot-steps of drives, at any instant
  CheckCount wheel_accelerations;    ///< robot-steps of drives, at any instant
  std::int64_t with_heading = 0;     ///< robot-steps that were judged by headings
  std::int64_t without_heading = 0;  ///< robot-steps of robots with a heading that the rows lack
  /// Robot-rows at which an acceleration changed although a robot with a time_step had to hold it;
  /// amounts in m/s^2.
  CheckCount changes;
  /// m, over pairs that avoid each other and all times; none without any
  std::optional<double> least_clearance;
  std::optional<double> least_static_clearance;  ///< m, over all robots, walls and times
  double largest_acceleration = 0.0;             ///< m/s^2
  double largest_speed = 0.0;                    ///< m/s
  std::int64_t with_goal = 0;                    ///< of the robots given
  /// Robots that had a row within arrival_distance of the goal, in sight of it. Airplanes fly
  /// through the goal: they count at any time of a step, whatever is in between. A robot that rests
  /// at the end also counts, under three conditions. Another robot rests so near the goal that both
  /// could not be there. The other robot's own goal is as near. Robots at rest lead from one to the
  /// other.
  std::int64_t arrived = 0;
  std::int64_t at_goal_at_end = 0;        ///< in their last row
  std::optional<double> last_arrival;     ///< s; none unless all arrived
  std::vector<std::int64_t> not_arrived;  ///< ascending
  bool movers_at_rest = false;            ///< see CheckOptions

  /// Returns whether there is an overlap, a contact with walls or with a mover that does not avoid
  /// the robot, or an exceeded limit.
  [[nodiscard]] AVO_API bool broken() const;
  /// Returns whether nothing is broken and no step is unjudged: motion between missing rows is
  /// never called safe.
  [[nodiscard]] bool safe() const { return !broken() && unjudged_steps == 0; }
};

/// Takes the rows of one time after the other. Between two rows a robot is judged on the cubic with
/// their positions and velocities, a robot with a heading on its arc. Pairs overlap where their
/// distance is less than (r_A + r_B)(1 - relative_tolerance) less the interpolation errors of both.
/// The same bound holds for a wall, with its radius for r_B.
class AVO_API Check {
 public:
  /// Throws Error on values out of range.
  explicit Check(const std::vector<CheckedRobot>& robots, std::vector<CheckedMover> movers = {},
                 const CheckOptions& options = {});
  ~Check();
  Check(Check&&) noexcept;
  Check& operator=(Check&&) noexcept;

  /// Adds one more robot, at any time; returns its position in the list. Throws Error on values out
  /// of range.
  std::int64_t add_robot(const CheckedRobot& robot);

  /// Sets the walls of the steps that follow, and of the rows at both their ends; there are none at
  /// first. It may be called between any two times, for doors that open and close; counts made
  /// before stay. A contact names a wall by its position in the list of its step. Throws Error on
  /// values out of range.
  void set_walls(std::vector<CheckedWall> walls);

  /// Sets where a moving obstacle is at the time of the next add(), and its velocity, in place of
  /// its given motion. mover: its position in the list given. It is judged on the cubic from its
  /// last place, or on the straight line if CheckedMover::straight is set. Once placed, it stays
  /// there until it is placed again. Throws Error on values out of range.
  void place_mover(std::int64_t mover, Vec2 position, Vec2 velocity);

  /// Adds all rows of one time, by ascending robot; times ascend, by 1e-12 s or more. Throws Error
  /// on anything else. Throws RowError on values that are not finite or beyond 1e12, and on missing
  /// headings; nothing has changed then. A robot may be missing: it is judged over the steps that
  /// have it at both ends. Throws Error where more than 10 million pairs overlap; the object is of
  /// no further use then.
  void add(double time, std::span<const CheckedState> rows);
  /// Declares that rows are missing between the last add() and the next one, so that the paths are
  /// unknown. The rows themselves are judged. For holonomic robots, a_max must also allow their
  /// change of velocity and their displacement. The step is one of CheckReport::unjudged_steps, and
  /// its robot-steps are not counted. Before the first add() it does nothing.
  void skip();
  [[nodiscard]] CheckReport report() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
