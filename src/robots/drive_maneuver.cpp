// SPDX-License-Identifier: Apache-2.0
// The maneuvers of a differential drive with a footprint, beside obstacles. It turns on the spot,
// and its rear swings out. Where that is not clear, it turns in the other sense, or first drives
// straight, ahead or back, to where it is clear. As q it means the point L ahead of the axle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/plane.h"
#include "robots/ahead.h"
#include "robots/drive.h"
#include "robots/footprint.h"

namespace avo::inline robots {
namespace {

constexpr double kSmallTurn = 0.1;     // rad: less is never tested
constexpr double kOfDisc = 0.25;       // radii of a disc, of its motion between two tested places
constexpr double kFarthestMove = 2.0;  // of the radius that covers it: the longest straight move
constexpr double kTractrix = 3.0;      // [L]: then it has nearly turned
constexpr double kLargestPart = 0.25 * std::numbers::pi;  // rad, of a turn
constexpr double kSmallestPart = 0.02;                    // rad
constexpr double kStraightSpeed = 0.5;  // of the preferred speed, on straight moves

struct StraightMove {
  double gear;            // 1: ahead; -1: back
  double length = 0.0;    // m
  bool has_room = false;  // to turn, behind it
};

// Ahead, where both are equally good.
StraightMove better(const StraightMove& ahead, const StraightMove& back) {
  if (ahead.has_room != back.has_room) return ahead.has_room ? ahead : back;
  const bool is_back_better =
      ahead.has_room ? back.length < ahead.length : back.length > ahead.length;
  return is_back_better ? back : ahead;
}

// One drive that looks for room to turn.
struct TurningRoom {
  const DifferentialDrive& drive;
  const Robot& robot;
  const ClearPlaces& is_clear;
  Vec2 heading;    // unit
  double angle;    // rad, to its wish; > 0: to the left
  double piece;    // m, between tested places
  double lever;    // m, of the farthest center about the axle
  double longest;  // m, of a tractrix

  [[nodiscard]] Vec2 axle(double along) const {
    return robot.position + (along - drive.offset) * heading;
  }
  // Returns whether q may go round the axle by that angle, after a straight move.
  [[nodiscard]] bool is_clear_circle(double along, double turn) const {
    const int pieces = static_cast<int>(std::ceil(std::abs(turn) * lever / piece));
    for (int k = 1; k <= pieces; ++k) {
      const Vec2 h = turned(heading, elementary::direction(turn * k / pieces));
      if (!is_clear(axle(along) + drive.offset * h, h, Nearness::later)) return false;
    }
    return true;
  }
  // Returns whether q may then go straight on at that angle, while the heading follows on a
  // tractrix: dφ/ds = -sin φ/L.
  [[nodiscard]] bool is_clear_tractrix(double along, double turn, double rest) const {
    const Vec2 h = turned(heading, elementary::direction(turn));
    const Vec2 to = turned(h, elementary::direction(rest));
    Vec2 q = axle(along) + drive.offset * h;
    for (double length = 0.0; length < longest; length += piece) {
      rest -= elementary::direction(rest).y * std::min(piece / drive.offset, 1.0);
      q = q + piece * to;
      if (!is_clear(q, turned(to, elementary::direction(-rest)), Nearness::later)) return false;
    }
    return true;
  }
  // Returns whether it can turn by that angle as steered() does, after a straight move.
  [[nodiscard]] bool is_clear_turn(double along, double turn) const {
    constexpr double kAcross = 0.5 * std::numbers::pi;
    const double rest = std::clamp(turn, -kAcross, kAcross);
    return is_clear_circle(along, turn - rest) && is_clear_tractrix(along, turn - rest, rest);
  }
  // rad: the largest part of its turn that is clear while q drives on; the near side comes first.
  // Beside a wall, along which straight moves find no room, many small parts lead away from it.
  [[nodiscard]] double clear_part() const {
    for (const double side : {1.0, -1.0}) {
      for (double part = kLargestPart; part > kSmallestPart; part *= 0.5) {
        const double turn = std::copysign(part, side * angle);
        if (is_clear_tractrix(0.0, 0.0, turn)) return turn;
      }
    }
    return 0.0;
  }
  // The shortest straight move in that direction behind which the turn is clear, or else the
  // longest piece that is clear.
  [[nodiscard]] StraightMove straight_move(double gear) const {
    StraightMove move{gear};
    const double most = kFarthestMove * robot.radius;
    while (move.length + piece <= most) {
      const double next = move.length + piece;
      if (!is_clear(robot.position + gear * next * heading, heading, Nearness::next)) break;
      move.length = next;
      if (is_clear_turn(gear * next, angle)) return move.has_room = true, move;
    }
    return move;
  }
};

// rad, > 0 to the left
double angle_between(Vec2 from, Vec2 to) {
  return elementary::atan2(cross(from, to), dot(from, to));
}

}  // namespace

double room_for_maneuvers(const DifferentialDrive& drive) {
  return drive.footprint ? kFarthestMove * bounding_radius(drive.footprint) : 0.0;
}

std::optional<Vec2> maneuver(const DifferentialDrive& drive, const Robot& robot,
                             const Approach& approach, const ClearPlaces& is_clear) {
  const double speed = norm(robot.preferred_velocity);
  if (!drive.footprint || !(speed > 0.0) || robot.distance_to_goal <= approach.near_enough)
    return std::nullopt;
  const Vec2 h = ahead_of(robot.heading);
  const double angle = angle_between(h, robot.preferred_velocity);
  if (std::abs(angle) < kSmallTurn) return std::nullopt;
  const TurningRoom turning{
      drive,
      robot,
      is_clear,
      h,
      angle,
      kOfDisc * drive.footprint.radius,
      farthest_center(drive.footprint),
      std::min({kTractrix * drive.offset, robot.distance_to_goal, robot.lookahead})};
  if (turning.is_clear_turn(0.0, angle)) return std::nullopt;
  const double other = angle - std::copysign(2.0 * std::numbers::pi, angle);
  if (turning.is_clear_turn(0.0, other))
    return within_steering(drive, robot, std::copysign(speed, other) * perpendicular(h));
  const StraightMove move = better(turning.straight_move(1.0), turning.straight_move(-1.0));
  const double part = move.has_room ? 0.0 : turning.clear_part();
  if (part != 0.0)
    return within_steering(drive, robot, speed * turned(h, elementary::direction(part)));
  if (move.length == 0.0) return std::nullopt;
  return within_steering(drive, robot, kStraightSpeed * move.gear * speed * h);
}

}  // namespace avo::inline robots
