// SPDX-License-Identifier: Apache-2.0
#include "certificate/inevitable.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "certificate/deepest.h"
#include "core/plane.h"
#include "walls/segment.h"

namespace avo::inline certificate {
namespace {

// m: the largest distance from a path at the time t, start + t speed + t²/2 acceleration.
struct Spread {
  double start = 0.0, speed = 0.0, acceleration = 0.0;

  double at(double t) const { return start + t * (speed + 0.5 * t * acceleration); }
  // s: a time by which it has reached `size`.
  double time_of(double size) const {
    const double left = std::max(size - start, 0.0);
    return std::min(speed > 0.0 ? left / speed : kLongest,
                    acceleration > 0.0 ? std::sqrt(2.0 * left / acceleration) : kLongest);
  }

 private:
  static constexpr double kLongest = 1e12;
};

// A time at which the function is negative, by golden sections of [0, end]. For a convex function
// it is found, unless the function is hardly negative.
template <typename Function>
std::optional<double> find_negative(const Function& f, double end) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSections = 48;
  if (f(0.0) < 0.0) return 0.0;
  double lower = 0.0, upper = end;
  double s = upper - kGolden * (upper - lower), t = lower + kGolden * (upper - lower);
  double f_s = f(s), f_t = f(t);
  for (int k = 0; k < kSections && !(f_s < 0.0) && !(f_t < 0.0); ++k) {
    if (f_s < f_t) {
      upper = t, t = s, f_t = f_s;
      s = upper - kGolden * (upper - lower), f_s = f(s);
    } else {
      lower = s, s = t, f_s = f_t;
      t = lower + kGolden * (upper - lower), f_t = f(t);
    }
  }
  if (f_s < 0.0) return s;
  if (f_t < 0.0) return t;
  return std::nullopt;
}

// The place of A relative to B, as far as that is known.
struct Closing {
  Vec2 position, velocity, acceleration;  // of the center of the possible places
  Spread spread;                          // of the possible places around it
  const Neighbor* followed = nullptr;  // B, where its trajectory is known; `velocity` is then A's

  Vec2 at(double t) const {
    const Vec2 place = position + t * (velocity + (0.5 * t) * acceleration);
    if (followed == nullptr) return place;
    return place - (followed->trajectory->at(followed->trajectory_time + t) - followed->position);
  }
  // s: after that time B's place is not known.
  double known_until() const {
    if (followed == nullptr || !followed->trajectory->repeats_from()) return kInfinity;
    return std::max(followed->trajectory->places().back().time - followed->trajectory_time, 0.0);
  }
  // m, an upper bound of the distance by which the two approach until then.
  double length_until(double t) const {
    const double of_trajectory =
        followed != nullptr ? followed->trajectory->max_speed(followed->trajectory_time) : 0.0;
    return t * (norm(velocity) + of_trajectory + 0.5 * t * norm(acceleration));
  }
};

// Finds a time at which all places that A can reach are within contact.
std::optional<double> find_contact(const Closing& closing, double contact) {
  const double end = std::min(closing.spread.time_of(contact), closing.known_until());
  if (!(norm(closing.at(0.0)) < contact + closing.length_until(end))) return std::nullopt;
  const auto depth = [&](double t) { return norm(closing.at(t)) + closing.spread.at(t) - contact; };
  return find_negative(depth, end);
}

double top_speed(const Robot& robot) {
  return std::max(robot.max_speed, norm(robot.velocity));
}

// A straight line beside a wall that no robot reaches without contact.
struct WallLine {
  double gap = 0.0;      // m, to the line
  double closing = 0.0;  // m/s, towards it
  double place = 0.0;    // m, from one end of the line to the foot
  double sliding = 0.0;  // m/s, along it
  double length = 0.0;   // m, of the line
};
constexpr int kLines = 17;

// The time by which A has reached the line for any change of its velocity by `most` m/s². The
// latest time is that of full braking, if the foot has not left the line by then.
std::optional<double> find_crossing(const WallLine& front, double most) {
  const auto& [gap, closing, place, sliding, length] = front;
  const double left = closing * closing - 2.0 * most * gap;
  if (!(closing > 0.0) || !(left > 0.0)) return std::nullopt;
  const double latest = 2.0 * gap / (closing + std::sqrt(left));
  const double drift = sliding * latest, aside = 0.5 * most * latest * latest;
  const bool stays =
      place + std::min(0.0, drift - aside) >= 0.0 && place + std::max(0.0, drift + aside) <= length;
  return stays ? std::optional(latest) : std::nullopt;
}

// lost: m, the part of the two radii that rounding may have lost.
std::optional<double> find_contact_of(const Robot& robot, const Neighbor& neighbor,
                                      const StepLaw& law, double lost) {
  const bool decides = neighbor.behavior == Behavior::decides;
  const double a_A = change_limit(robot), a_B = top_acceleration(neighbor);
  const auto [position, velocity] = error_against(neighbor, law);
  const Vec2 p = robot.position - neighbor.position;
  const bool is_followed = !decides && neighbor.trajectory != nullptr;
  const Vec2 kept = decides || is_followed ? Vec2{} : neighbor.acceleration;
  const Vec2 v_B = is_followed ? Vec2{} : neighbor.velocity;
  const Neighbor* followed = is_followed ? &neighbor : nullptr;
  double contact = robot.radius + neighbor.radius - lost;
  if (is_followed) contact -= neighbor.trajectory->error();
  // A may leave its present course by the effect of its acceleration, and its present place by the
  // effect of its speed
  const std::array closings{
      Closing{p, robot.velocity - v_B, -kept, {position, velocity, a_A + a_B}, followed},
      Closing{p, -v_B, -kept, {position, velocity + top_speed(robot), a_B}, followed}};
  for (const Closing& closing : closings) {
    if (const auto time = find_contact(closing, contact)) return time;
  }
  return std::nullopt;
}

std::optional<double> find_contact_of(const Robot& robot, const Wall& wall, double lost) {
  const Segment segment{wall.a - robot.position, wall.b - robot.position};
  const double contact = robot.radius + wall.radius - lost;
  const double most = change_limit(robot);
  const Spread spread{0.0, 0.0, most};
  const double end = spread.time_of(contact);
  const double away = distance(Vec2{}, segment);
  if (away < contact + end * norm(robot.velocity)) {
    const auto depth = [&](double t) {
      return distance(t * robot.velocity, segment) + spread.at(t) - contact;
    };
    if (const auto time = find_negative(depth, end)) return time;
  }
  const double length = norm(segment.b - segment.a);
  if (!(length > 0.0)) return std::nullopt;
  const Vec2 along = (segment.b - segment.a) / length;
  const double side = cross(along, -segment.a);  // of A
  const Vec2 normal = side < 0.0 ? Vec2{along.y, -along.x} : Vec2{-along.y, along.x};
  // each of these lines beside the wall is within contact, and a little beyond the wall's ends
  for (int k = 0; k < kLines; ++k) {
    const double off = contact * (kLines - 1 - k) / (kLines - 1);
    const double beyond = std::sqrt(contact * contact - off * off) - lost;
    const WallLine front{std::max(std::abs(side) - off, 0.0), -dot(normal, robot.velocity),
                         dot(along, -segment.a) + beyond, dot(along, robot.velocity),
                         length + 2.0 * beyond};
    if (const auto time = find_crossing(front, most)) return time;
  }
  return std::nullopt;
}

// A contact that rounding may cause does not count as doomed. Otherwise only the rounding error of
// these sums is subtracted.
template <typename Find>
std::optional<double> find_certain(double coordinates, double radii, const Find& find) {
  constexpr double kRounding = 0x1p-40;
  const std::optional<double> certain = find(feigned_depth(radii, 0.0));
  if (!certain) return std::nullopt;
  const std::optional<double> earlier = find(kRounding * (coordinates + radii));
  return earlier ? earlier : certain;
}

}  // namespace

std::optional<double> inevitable_contact(const Robot& robot, const Neighbor& neighbor,
                                         const StepLaw& law) {
  // a neighbor that cooperates may also do its best
  if (neighbor.behavior == Behavior::cooperates) {
    Neighbor best = neighbor;
    best.behavior = Behavior::decides;
    return inevitable_contact(robot, best, law);
  }
  return find_certain(length_1(robot.position) + length_1(neighbor.position),
                      robot.radius + neighbor.radius,
                      [&](double lost) { return find_contact_of(robot, neighbor, law, lost); });
}

std::optional<double> inevitable_contact(const Robot& robot, const Wall& wall) {
  return find_certain(length_1(robot.position) + length_1(wall.a) + length_1(wall.b),
                      robot.radius + wall.radius,
                      [&](double lost) { return find_contact_of(robot, wall, lost); });
}

}  // namespace avo::inline certificate
