// SPDX-License-Identifier: Apache-2.0
// A judge of recorded motion that shares no formula with the planner: separation of every pair in
// continuous time, from walls too, limits on acceleration and speed, of wheels and wings, arrival.
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

/// In any direction. Between two rows it is on the cubic with their positions and velocities.
struct CheckedHolonomic {};

/// Its position is the middle of its rear axle, and it moves along its heading: from row to row on
/// an arc, its curvature held and its change of speed, or at rest, turning about its position.
struct CheckedCar {
  double wheelbase = 1.0;  ///< m, > 0: at rest it turns no faster than moves its front axle, at
                           ///< max_speed; and only where max_curvature is infinite
  double max_curvature = std::numeric_limits<double>::infinity();  ///< 1/m, > 0
  double body_offset = 0.0;  ///< m, of the disc's center ahead of the position
  bool reverse = false;      ///< may drive backwards
  /// Its accelerations along and across the heading keep max_acceleration each, else together.
  bool exact_set = false;
};

/// Two wheels on an axle, whose middle is its position. The velocities of its rows are those of the
/// point `offset` ahead, which accelerates as it likes and evenly from row to row; so max_speed and
/// max_acceleration are that point's.
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

/// What a recorded robot is held to. Infinite limits are not checked.
struct CheckedRobot {
  double radius = 0.5;            ///< m, > 0, of its disc
  double max_acceleration = 1.0;  ///< m/s^2, > 0
  double max_speed = 2.0;         ///< m/s, > 0
  std::optional<Vec2> goal = {};  ///< m
  /// m, >= 0: how far the robot may have been from the judged path between two rows. 0 for
  /// accelerations held from row to row: their path is the cubic.
  double interpolation_error = 0.0;
  /// Changes its velocity at once at every row: straight lines are judged instead of cubics.
  bool straight = false;
  /// Rows without a heading tell of a car, or an airplane, its velocities alone: then only those
  /// are judged, and what the cubic may be off its arc is reckoned from the rows, and granted.
  CheckedKinematics kinematics = {};
  /// May not move at all, and is held to its first row. Two of them are not judged as a pair.
  bool parked = false;
  /// Bits: it avoids whoever is in one of the layers `avoids`. Pairs of which nobody avoids the
  /// other are not judged, see also one_sided_contacts_moving.
  std::uint32_t layers = 1, avoids = 0xffffffff;
  /// s, > 0: it decides by a clock of its own, and changes its acceleration (a car the change of
  /// its speed, and its curvature) at no other times. Rows have to stand at all of these; their
  /// phase is that of the first change.
  std::optional<double> time_step = {};
  /// m/s^2, > 0: where it is more than max_acceleration, a step may also slow the robot down
  /// straight by that much, or do a part of that and a part of what max_acceleration allows.
  std::optional<double> max_braking = {};
  /// m, >= 0: where max_acceleration is infinite, how far the positions of two rows may be off what
  /// their velocities and the change between these explain. Unset: no jump is judged then.
  std::optional<double> largest_jump = {};
};

/// A disc whose whole motion is known: p + t v + t²/2 a; or see Check::place_obstacle().
struct CheckedObstacle {
  Vec2 position = {}, velocity = {}, acceleration = {};  ///< at time 0
  double radius = 0.5;                                   ///< m, > 0
  bool straight = false;  ///< where it is placed, it goes straight and evenly from place to place
};

/// A static obstacle: all that is within `radius` of the segment from a to b; a disc where a == b.
struct CheckedWall {
  Vec2 a = {};          ///< m
  Vec2 b = {};          ///< m
  double radius = 0.0;  ///< m, >= 0
};

/// How strictly is judged.
struct CheckOptions {
  double relative_tolerance = 1e-9;  ///< of the sum of radii, of a_max, of v_max; in [0, 1)
  double arrival_distance = 0.5;     ///< m, > 0
  /// Whoever does not avoid a robot may touch it while it rests: what passive safety promises.
  bool movers_at_rest = false;
};

/// Which way a robot faces, and how fast it goes that way.
struct CheckedHeading {
  double angle = 0.0;  ///< rad, counter-clockwise from +x
  double speed = 0.0;  ///< m/s along it, < 0: backwards
};

/// A row that cannot be judged.
class AVO_API RowError : public Error {
 public:
  RowError(std::int64_t number, const std::string& message) : Error(message), robot(number) {}
  std::int64_t robot;  ///< whose row it is: its index
};

/// One row of a recording.
struct CheckedState {
  std::int64_t robot = 0;  ///< index into the robots given
  Vec2 position, velocity;
  /// Not read of holonomic robots. A car whose body_offset is not zero has to have one, and a
  /// drive.
  std::optional<CheckedHeading> heading = {};
};

/// One case of it.
struct CheckViolation {
  double time = 0.0;       ///< s; of what is judged from row to row, where its step began
  std::int64_t robot = 0;  ///< the lower number of a pair of robots
  std::optional<std::int64_t> other = {};  ///< the other robot of a pair, the obstacle, the wall
  double amount = 0.0;  ///< beyond the limit: m/s^2, m/s, rad, m (of overlap: the most in the step)
};

/// A robot that touched what does not avoid it; a pair counts once.
struct CheckedHit {
  double time = 0.0;       ///< s, when the two first touched
  std::int64_t robot = 0;  ///< that was touched
  std::int64_t other = 0;  ///< index of the moving obstacle, or of the other robot
  double depth = 0.0;      ///< m, the deepest
  bool moved = false;      ///< whether the robot moved itself at any time while the two overlapped
};

/// How often a rule was broken.
struct CheckCount {
  std::int64_t count = 0;  ///< of pairs, robots, robot-steps or robot-rows
  std::optional<CheckViolation> first = {};
  double worst = 0.0;  ///< largest amount
};

/// What was found in all rows up to now.
struct CheckReport {
  std::int64_t robots = 0;       ///< that were ever there
  std::int64_t rows = 0;         ///< robot-rows
  std::int64_t steps = 0;        ///< between successive times
  std::int64_t robot_steps = 0;  ///< of robots that are there at both ends: what is judged
  std::int64_t gaps = 0;         ///< returns of a robot that was missing at some time: not judged
  std::int64_t unjudged_steps =
      0;                        ///< of them: whose rows in between are missing, see Check::skip()
  double from = 0.0, to = 0.0;  ///< s
  double interpolation_error = 0.0;  ///< m, the largest of a robot-step
  CheckCount overlaps;               ///< pairs of robots that avoid each other and ever overlapped
  CheckCount obstacle_contacts_moving;  ///< pairs: the robot moved itself while they overlapped
  std::int64_t obstacle_contacts_at_rest = 0;  ///< pairs, all others
  std::vector<CheckedHit> obstacle_hits;       ///< all of both, by time, robot and obstacle
  /// Pairs of robots of which one only avoids the other: that one moved itself while they
  /// overlapped.
  CheckCount one_sided_contacts_moving;
  std::int64_t one_sided_contacts_at_rest = 0;  ///< pairs, all others
  std::vector<CheckedHit> one_sided_hits;       ///< all of both, likewise
  CheckCount static_contacts;                   ///< robots that ever touched a wall
  /// Robot-steps with |Δv|/Δt > a_max, or beyond what max_braking allows. With headings, |Δs|/Δt,
  /// of the speed s; of a car that has to keep a_max in both directions together, with the lateral
  /// acceleration.
  CheckCount accelerations;
  CheckCount speeds;  ///< robot-rows with |v| > v_max
  /// Robot-steps with |Δp - Δt (v_0 + v_1)/2| > a_max Δt²/2: positions that do not follow the
  /// velocities. A motion within a_max stays below half of it, one whose velocity changes at once,
  /// by a_max Δt at most, just within it. Where a_max is infinite, > Δt |v_1 - v_0|/2 +
  /// largest_jump: whenever the velocity changes in the step, the first of these covers it. With
  /// headings, those that are off their arc, or what the motion of a drive makes of the velocities.
  CheckCount jumps;
  /// With headings, robot-rows whose velocity is not the speed along the heading.
  CheckCount headings;
  /// Robot-steps in which a car turns by more than max_curvature times its way; or at rest, by more
  /// than it can.
  CheckCount turns;
  CheckCount lateral_accelerations;  ///< robot-steps of cars and airplanes, at their higher speed
  /// Robot-steps in which a car drives backwards that may not, or backwards and forwards.
  CheckCount reversals;
  CheckCount slow_flights;           ///< robot-rows of airplanes with s < min_speed
  CheckCount wheel_speeds;           ///< robot-steps of drives, at any instant
  CheckCount wheel_accelerations;    ///< likewise
  std::int64_t with_heading = 0;     ///< robot-steps that were judged by headings
  std::int64_t without_heading = 0;  ///< robot-steps of those that have one, which the rows lack
  /// Robot-rows at which an acceleration changed that a robot with a time_step had to hold; amounts
  /// in m/s^2.
  CheckCount changes;
  std::optional<double> least_clearance;  ///< m, over such pairs and all times; none without any
  std::optional<double> least_static_clearance;  ///< m, over all robots, walls and times
  double largest_acceleration = 0.0;             ///< m/s^2
  double largest_speed = 0.0;                    ///< m/s
  std::int64_t with_goal = 0;                    ///< of the robots given
  /// In a row within arrival_distance of the goal, in sight; airplanes, which fly through it, at
  /// any time of a step, whatever is in between. Also whoever rests at the end, where another one
  /// rests so near the goal that both could not be there, and has its own goal as near.
  std::int64_t arrived = 0;
  std::int64_t at_goal_at_end = 0;        ///< in their last row
  std::optional<double> last_arrival;     ///< s; none unless all arrived
  std::vector<std::int64_t> not_arrived;  ///< ascending
  bool movers_at_rest = false;            ///< of CheckOptions

  /// An overlap, a contact with walls or with whoever does not avoid the robot, a limit exceeded.
  [[nodiscard]] AVO_API bool broken() const;
  /// None of these, and no step is unjudged: what lies between rows that are not there is never
  /// called safe.
  [[nodiscard]] bool safe() const { return !broken() && unjudged_steps == 0; }
};

/// Feed it the rows of one time after the other. Between two rows a robot is judged on the cubic
/// with their positions and velocities, one with a heading on its arc. Pairs overlap where their
/// distance is less than (r_A + r_B)(1 - relative_tolerance) less the interpolation errors of both;
/// a wall is touched likewise, with its radius for r_B.
class AVO_API Check {
 public:
  /// Throws Error on values out of range.
  explicit Check(const std::vector<CheckedRobot>& robots,
                 std::vector<CheckedObstacle> obstacles = {}, const CheckOptions& options = {});
  ~Check();
  Check(Check&&) noexcept;
  Check& operator=(Check&&) noexcept;

  /// One more robot, at any time; returns its index. Throws Error on values out of range.
  std::int64_t add_robot(const CheckedRobot& robot);

  /// The walls of the steps that follow, and of the rows at both their ends; none at first. May be
  /// called between any two times, for doors that open and close: what was counted stays. A contact
  /// names a wall by its index in the list of its step. Throws Error on values out of range.
  void set_walls(std::vector<CheckedWall> walls);

  /// Where an obstacle (an index into those given) is at the time of the next add(), and how fast,
  /// instead of what it was told to do: it is judged on the cubic from where it was, or on the
  /// straight line if it is CheckedObstacle::straight. Once placed, it stays there until it is
  /// placed again. Throws Error on values out of range.
  void place_obstacle(std::int64_t obstacle, Vec2 position, Vec2 velocity);

  /// All rows of one time, by ascending robot; times ascend, by 1e-12 s or more. Throws Error on
  /// anything else, and RowError on values that are not finite or beyond 1e12, and on headings that
  /// are missing; nothing has changed then. A
  /// robot may be missing: it is judged over the steps at both ends of which it is there. Throws
  /// Error where more pairs overlap than anyone wants to know (10 million); of no further use then.
  void add(double time, std::span<const CheckedState> rows);
  /// Between the last add() and the next one rows are missing, so that nobody knows the paths. What
  /// the rows themselves tell is judged, and of holonomic robots that a_max allows their change of
  /// velocity and their way; the step is one of CheckReport::unjudged_steps, and its robot-steps
  /// are not counted. Before the first add() it does nothing.
  void skip();
  [[nodiscard]] CheckReport report() const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
