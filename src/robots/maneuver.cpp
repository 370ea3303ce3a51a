// SPDX-License-Identifier: Apache-2.0
// The maneuvers of a car that cannot turn in place, beside walls. It makes a few moves, forward or
// backwards, on arcs or straight, and then drives straight to its target. It begins the shortest
// path that is found, and the next decision chooses again. Its present move may come nearer to
// walls than a move that it would have to begin. So it does not change its decision repeatedly, and
// it has to remember nothing but its velocity.
#include "robots/maneuver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"

namespace avo::inline robots {
namespace {

// All in radii of the turning circle.
constexpr double kNearGoal = 3.0;  // paths to nearer goals are examined to their end
// of the straight path to farther goals: the part that must be clear
constexpr double kStraight = 2.0;
constexpr double kLongest = 3.2;  // of a move: hardly more than half a circle
constexpr double kSample = 1.0 / 8.0;
constexpr double kFarGoal = 100.0;  // goals are not farther than that
constexpr double kMostRoom = 5.0;
constexpr double kPlanned = 1.1;           // the circles of planned paths: a car can correct itself
constexpr double kTurnAcceleration = 0.8;  // of a_max, used for turning
constexpr double kLeadSteps = 2.0;         // until a car that starts turns
// rad, wishes at this angle use the full lock
constexpr double kFullLock = 0.25 * std::numbers::pi;
// rad: for less the car steers towards its goal, as it does far from walls
constexpr double kSharpTurn = 0.3;

// m/s: a wish that makes the car do the move; length: m, until it changes gear.
Vec2 wish(const Maneuvering& car, const Move& move, double turn, double length) {
  const Vec2 ahead = move.gear * car.pose.heading;
  const double a_max = car.robot.max_acceleration;
  const double top =
      std::min(std::sqrt(kTurnAcceleration * a_max * car.turning), car.robot.max_speed);
  if (move.gear * car.speed < 0.0) return top * ahead;  // it brakes first
  if (car.speed != 0.0 && length <= car.stopping_vector()) return {};
  const double v = std::min(top, std::sqrt(a_max * length));
  if (turn < kFullLock) return v * turned(ahead, elementary::direction(move.side * turn));
  return v * (ahead + move.side * perpendicular(ahead));
}

// The longest clear move, where no path is found.
Vec2 wish_to_go_on(const Maneuvering& car) {
  Move farthest;
  double longest = 0.0;
  for (int k = 0; k < car.gears(); ++k) {
    for (const double side : {-1.0, 0.0, 1.0}) {
      const Move move{k == 0 ? 1.0 : -1.0, side, car.planned};
      const double clear =
          car.clear_length(car.pose, move, kLongest * car.turning,
                           car.goes_on(move.gear) ? Nearness::begun : Nearness::next);
      if (clear > longest) longest = clear, farthest = move;
    }
  }
  return wish(car, farthest, farthest.side == 0.0 ? 0.0 : longest / car.planned, longest);
}

}  // namespace

Vec2 KnownTurns::direction(double turn) {
  const auto bits = std::bit_cast<std::uint64_t>(turn);
  const std::size_t k = (bits * 0x9e3779b97f4a7c15U) >> 58U;
  static_assert(kKnown == 1U << 6U);
  if (turns[k] != turn) turns[k] = turn, directions[k] = elementary::direction(turn);
  return directions[k];
}

AxlePose after(const AxlePose& pose, const Move& move, double length, KnownTurns& turns) {
  const Vec2 ahead = move.gear * pose.heading;
  if (move.side == 0.0) return {pose.axle + length * ahead, pose.heading};
  const Vec2 turn = turns.direction(move.side * length / move.radius);
  const Vec2 to_center = (move.side * move.radius) * perpendicular(ahead);
  return {pose.axle + to_center - turned(to_center, turn), turned(pose.heading, turn)};
}

std::optional<ArcLeg> leg_to(const AxlePose& pose, const Move& move, Vec2 place) {
  const Vec2 ahead = move.gear * pose.heading;
  const Vec2 from_center = place - pose.axle - (move.side * move.radius) * perpendicular(ahead);
  const double squared = norm_squared(from_center) - move.radius * move.radius;
  if (squared < 0.0) return std::nullopt;
  const double straight = std::sqrt(squared);
  // in the frame of the straight path the place lies at (straight, -side radius) from the center
  const Vec2 out = turned(from_center, {straight, move.side * move.radius});
  double turn = move.side * elementary::atan2(cross(ahead, out), dot(ahead, out));
  constexpr double kRounding = 1e-3, kCircle = 2.0 * std::numbers::pi;
  if (turn < 0.0) turn += kCircle;
  return ArcLeg{turn > kCircle - kRounding ? 0.0 : turn * move.radius, straight};
}

double Maneuvering::lead_left(double gear) const {
  const double top = std::sqrt(kTurnAcceleration * robot.max_acceleration * turning);
  return goes_on(gear) ? lead * std::max(0.0, 1.0 - std::abs(speed) / top) : lead;
}

double Maneuvering::clear_length(const AxlePose& from, const Move& move, double most,
                                 Nearness nearness) const {
  for (double length = 0.0; length < most;) {
    const double next = std::min(length + kSample * turning, most);
    const AxlePose there = after(from, move, next, turns);
    if (!is_clear(there.axle + offset_of(car) * there.heading, there.heading, nearness))
      return length;
    length = next;
  }
  return most;
}

// Routes around walls touch them, and the part after the corner is not known here. Neither is the
// part behind the point at which a car with a footprint aims.
bool Maneuvering::is_clear_leg(const AxlePose& from, const Move& move, const ArcLeg& leg,
                               Nearness nearness) const {
  const bool is_near = norm(goal - pose.axle) <= kNearGoal * turning;
  const double most = std::min(kStraight * turning, std::max(robot.lookahead - leg.arc, 0.0));
  const double straight = is_near ? leg.straight : std::min(leg.straight, most);
  if (straight < leg.straight) nearness = Nearness::begun;
  const Move ahead{move.gear, 0.0, planned};
  const AxlePose turned = after(from, move, leg.arc, turns);
  const AxlePose end = after(turned, ahead, straight, turns);
  return is_clear(end.axle + offset_of(car) * end.heading, end.heading, nearness) &&
         clear_length(from, move, leg.arc, nearness) >= leg.arc &&
         clear_length(turned, ahead, straight, nearness) >= straight;
}

double room_for_maneuvers(const Car& car) {
  return turns_in_place(car) ? 0.0 : kMostRoom / sharpest(car);
}

std::optional<Vec2> maneuver(const Car& car, const Robot& robot, const Approach& approach,
                             bool is_beside, const ClearPlaces& is_clear, ManeuverMemory& memory) {
  const double speed = norm(robot.preferred_velocity), turning = 1.0 / sharpest(car);
  if (!(speed > 0.0) || is_there(car, robot, approach)) return std::nullopt;
  const Vec2 h = ahead_of(robot.heading);
  const Vec2 axle = robot.position - offset_of(car) * h;
  const double distance = std::min(robot.distance_to_goal, kFarGoal * turning);
  const double middling = std::sqrt(0.5 * kTurnAcceleration * robot.max_acceleration * turning);
  const double lead = kLeadSteps * approach.time_step * middling;
  const Maneuvering maneuvering{car,
                                robot,
                                is_clear,
                                turning,
                                kPlanned * turning,
                                lead,
                                axle + (distance / speed) * robot.preferred_velocity,
                                {axle, h},
                                dot(h, robot.velocity),
                                memory.turns};
  memory.turns.begin();
  const auto beginning = begin_maneuver(maneuvering, memory);
  if (!beginning) return wish_to_go_on(maneuvering);
  if (!beginning->is_direct)
    return wish(maneuvering, beginning->move, beginning->turn, beginning->length);
  if (!is_beside) return std::nullopt;
  if (beginning->turn > kSharpTurn)
    return wish(maneuvering, beginning->move, beginning->turn, beginning->length);
  return steered_along(car, robot, beginning->move.gear * h);
}

}  // namespace avo::inline robots
