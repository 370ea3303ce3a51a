// SPDX-License-Identifier: Apache-2.0
// How a car that cannot turn in place goes about it beside walls: by one move and then another one,
// forward or backwards. A move is an arc at full lock, or straight; the second one ends with the
// straight way to where the car would go. Of all such ways that are clear the shortest is begun,
// and the next decision chooses anew. What the car does already may come nearer to walls, and turn
// on a narrower circle, than what it would have to begin. So it does not change its mind over and
// over, and its velocity is all that it has to remember.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/car.h"

namespace avo {
namespace {

// All of them times the radius of the turning circle.
constexpr double kGearChange = 1.0;  // m of way, that standing still and starting anew is worth
constexpr double kStraight = 2.0;    // of the straight way, that has to be clear
constexpr double kLongest = 3.2;     // of the first move: hardly more than half a circle
constexpr double kShortest = 1.0 / 32.0;  // likewise, and twice as long again and again
constexpr double kSample = 1.0 / 8.0;
constexpr double kWider = 1.25;     // the circle of what is not begun yet: it starts straight
constexpr double kFarGoal = 100.0;  // goals are not farther than that
constexpr double kMostRoom = 5.0;
constexpr double kSharpTurn = 1.5;         // longer ones are driven at full lock
constexpr double kTurnAcceleration = 0.8;  // of a_max, that turning asks for

// The middle of the axle.
struct Pose {
  Vec2 axle, heading;
};

struct Move {
  double gear = 1.0;    // 1 forward, -1 backwards
  double side = 0.0;    // 1 to the left of where it drives, -1 to the right, 0 straight
  double radius = 0.0;  // m, of its circle
};

// From a pose to a place: an arc, and straight on.
struct Leg {
  double arc = 0.0, straight = 0.0;  // m
};

struct Way {
  double cost = 0.0;  // m
  int number = 0;     // in the order in which they are offered
  Move first;
  double length = 0.0;  // m, of the first move; 0: none
  Move second;
  Leg rest;
};

Pose after(const Pose& pose, const Move& move, double length) {
  const Vec2 ahead = move.gear * pose.heading;
  if (move.side == 0.0) return {pose.axle + length * ahead, pose.heading};
  const Vec2 turn = elementary::direction(move.side * length / move.radius);
  const Vec2 to_center = (move.side * move.radius) * perpendicular(ahead);
  return {pose.axle + to_center - turned(to_center, turn), turned(pose.heading, turn)};
}

// None to places inside the circle.
std::optional<Leg> leg_to(const Pose& pose, const Move& move, Vec2 place) {
  const Vec2 ahead = move.gear * pose.heading;
  const Vec2 from_center = place - pose.axle - (move.side * move.radius) * perpendicular(ahead);
  const double squared = norm_squared(from_center) - move.radius * move.radius;
  if (squared < 0.0) return std::nullopt;
  const double straight = std::sqrt(squared);
  // in the frame of the straight way the place lies at (straight, -side radius) from the center
  const Vec2 out = turned(from_center, {straight, move.side * move.radius});
  double turn = move.side * elementary::atan2(cross(ahead, out), dot(ahead, out));
  constexpr double kRounding = 1e-3, kCircle = 2.0 * std::numbers::pi;
  if (turn < 0.0) turn += kCircle;
  return Leg{turn > kCircle - kRounding ? 0.0 : turn * move.radius, straight};
}

// One car's looking for a way.
struct Search {
  static constexpr std::size_t kMostWays = 256;
  const Car& car;
  const Robot& robot;
  const ClearPlaces& is_clear;
  double turning;  // m, the radius of the turning circle
  Vec2 goal;
  Pose pose;
  double speed;  // m/s, along the heading
  std::array<Way, kMostWays> ways{};
  std::size_t count = 0;

  bool goes_on(const Move& move) const { return move.gear * speed > 0.0; }
  double stopping_way() const { return 0.5 * speed * speed / robot.max_acceleration; }
  double radius(double gear) const { return gear * speed > 0.0 ? turning : kWider * turning; }
  int gears() const { return car.reverse ? 2 : 1; }

  // m, that the car can drive before it comes too near to something
  double clear_length(const Pose& from, const Move& move, double most, bool goes_on) const {
    for (double length = 0.0; length < most;) {
      const double next = std::min(length + kSample * turning, most);
      const Pose there = after(from, move, next);
      if (!is_clear(there.axle + offset_of(car) * there.heading, goes_on)) return length;
      length = next;
    }
    return most;
  }

  bool is_free(const Way& way) const {
    const bool begun = goes_on(way.length > 0.0 ? way.first : way.second);
    const Pose from = after(pose, way.first, way.length);
    if (clear_length(from, way.second, way.rest.arc, begun) < way.rest.arc) return false;
    const double straight = std::min(way.rest.straight, kStraight * turning);
    const Move ahead{way.second.gear, 0.0, turning};
    return clear_length(after(from, way.second, way.rest.arc), ahead, straight, begun) >= straight;
  }

  // m: to stop, to come back as far, and to start anew
  double change_from_now(const Move& move) const {
    return move.gear * speed < 0.0 ? 2.0 * stopping_way() + kGearChange * turning : 0.0;
  }

  void offer(const Move& first, double length) {
    const Pose next = after(pose, first, length);
    for (int k = 0; k < gears(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        Move second{k == 0 ? 1.0 : -1.0, side};
        const bool changes = length > 0.0 && second.gear != first.gear;
        second.radius = changes ? kWider * turning : radius(second.gear);
        const auto rest = leg_to(next, second, goal);
        if (!rest || count == kMostWays) continue;
        const double cost = length + rest->arc + rest->straight +
                            change_from_now(length > 0.0 ? first : second) +
                            (changes ? kGearChange * turning : 0.0);
        const int number = static_cast<int>(count);
        ways[count++] = {cost, number, first, length, second, *rest};
      }
    }
  }

  // Lengths that double, from where it can stop; and as far as it is clear.
  void offer_lengths(const Move& first, double clear) {
    const double least = goes_on(first) ? stopping_way() : 0.0;
    if (least > 0.0 && least < clear) offer(first, least);
    for (double more = kShortest * turning; least + more < clear; more *= 2.0)
      offer(first, least + more);
    if (clear > 0.0) offer(first, clear);
  }

  // The shortest that is free.
  const Way* best() {
    std::sort(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Way& a, const Way& b) {
                return a.cost < b.cost || (a.cost == b.cost && a.number < b.number);
              });
    for (std::size_t k = 0; k < count; ++k) {
      if (is_free(ways[k])) return &ways[k];
    }
    return nullptr;
  }

  // m/s: a wish that makes the car do it; stops: at its end.
  Vec2 wish(const Move& move, double length, bool stops) const {
    const Vec2 ahead = move.gear * pose.heading;
    const double top =
        std::min(std::sqrt(kTurnAcceleration * robot.max_acceleration * turning), robot.max_speed);
    if (move.gear * speed < 0.0) return top * ahead;  // it brakes first
    if (stops && speed != 0.0 && length <= stopping_way()) return {};
    const double v = stops ? std::min(top, std::sqrt(robot.max_acceleration * length)) : top;
    return v * (ahead + move.side * perpendicular(ahead));
  }

  Vec2 wish(const Way& way) const {
    if (way.length > 0.0) return wish(way.first, way.length, way.first.gear != way.second.gear);
    if (way.rest.arc > kSharpTurn * turning) return wish(way.second, way.rest.arc, false);
    return steered_along(car, robot, way.second.gear * pose.heading);
  }
};

}  // namespace

double room_for_maneuvers(const Car& car) {
  return turns_in_place(car) ? 0.0 : kMostRoom / sharpest(car);
}

std::optional<Vec2> maneuver(const Car& car, const Robot& robot, const Approach& approach,
                             const ClearPlaces& is_clear) {
  const double speed = norm(robot.preferred_velocity), turning = 1.0 / sharpest(car);
  if (!(speed > 0.0) || is_there(car, robot, approach)) return std::nullopt;
  const Vec2 h = elementary::direction(robot.heading);
  const double distance = std::min(robot.distance_to_goal, kFarGoal * turning);
  Search search{car,
                robot,
                is_clear,
                turning,
                robot.position + (distance / speed) * robot.preferred_velocity,
                {robot.position - offset_of(car) * h, h},
                dot(h, robot.velocity)};
  search.offer({}, 0.0);
  if (const Way* way = search.best()) return search.wish(*way);
  Move farthest;
  double longest = 0.0;
  for (int k = 0; k < search.gears(); ++k) {
    for (const double side : {-1.0, 0.0, 1.0}) {
      Move first{k == 0 ? 1.0 : -1.0, side};
      first.radius = search.radius(first.gear);
      const double clear =
          search.clear_length(search.pose, first, kLongest * turning, search.goes_on(first));
      if (clear > longest) longest = clear, farthest = first;
      search.offer_lengths(first, clear);
    }
  }
  if (const Way* way = search.best()) return search.wish(*way);
  return search.wish(farthest, longest, true);
}

}  // namespace avo
