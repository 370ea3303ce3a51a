// SPDX-License-Identifier: Apache-2.0
// How far robots must see for their certificate, and how fast they may be for their sensing radius
// (docs/certificate.md, "Statement", assumption 3).
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "avo/assumptions.h"
#include "certificate/certificate.h"
#include "core/elementary.h"
#include "core/plane.h"
#include "core/timed_places.h"
#include "planner/stages/certify.h"
#include "robots/model.h"
#include "sim/columns/fleet.h"
#include "sim/scene/assumptions.h"
#include "sim/scene/scene_checks.h"
#include "sim/sensing/senses.h"

namespace avo::inline sim {
namespace {

// 5.4 m as a sum of decimal fractions may exceed 5.4 m by its rounding.
constexpr double kSumRounding = 1e-12;

// A quarter of a circle, in diameters.
constexpr double kQuarterTurn = 0.25 * std::numbers::pi;

// What a robot at its highest speed needs, if it is unseen until the next step.
struct UnseenPart {
  RobotId robot;
  double length = 0.0;   // m, radius and distance
  double seconds = 0.0;  // until rest, or until it has turned aside on its circle
};

UnseenPart part_of(const Scenario& scenario, std::size_t i, const CertificateLaw& law) {
  const RobotSetup& robot = scenario.robots[i];
  const StepLaw own = step_law(scenario, robot, law);
  const double v = robot.max_speed, step = own.time_step,
               late = time_unseen(scenario, law.step.longest_step);
  const double u = decrement_of(robot, own);
  const double fastest = model_traits(robot.model).speed_ratio * v;
  const double circle = room_to_turn(robot.model, v);
  const bool flies = !can_rest(robot.model);
  // a robot that flies turns aside by half of its circle
  const double seconds =
      flies ? step + kQuarterTurn * circle / v : step * (1.0 + braking_steps(v, u));
  return {RobotId{i},
          disc_radius(robot) +
              ((step + late) * fastest + (flies ? circle : stopping_length(v, u, own))),
          seconds + late};
}

// m/s
double fastest_on_trajectory(const MovingObstacle& obstacle) {
  double fastest = 0.0;
  const std::vector<TimedPlace>& places = obstacle.trajectory;
  for (std::size_t k = 1; k < places.size(); ++k)
    fastest = std::max(fastest, leg_speed(places[k - 1], places[k]));
  return fastest;
}

double part_of(const MovingObstacle& obstacle, double seconds, double duration,
               const CertificateLaw& law) {
  // |v + t a| is largest at one of the ends
  const double speed = std::max(
      {norm(obstacle.velocity), norm(obstacle.velocity + duration * obstacle.acceleration),
       obstacle.path.empty() ? 0.0 : *obstacle.max_speed, fastest_on_trajectory(obstacle)});
  const double change = norm(obstacle.acceleration) + obstacle.max_deviation;
  const double length = seconds * speed + 0.5 * seconds * seconds * change;
  const double most = obstacle.max_speed ? seconds * *obstacle.max_speed : length;
  return obstacle.radius + std::min(length, most) + parabola_error(obstacle.acceleration, law.step);
}

// The robots that need more time or more length than all others: only they can be the worst for an
// obstacle.
std::vector<UnseenPart> worst_for_movers(std::vector<UnseenPart> parts) {
  std::stable_sort(parts.begin(), parts.end(), [](const UnseenPart& a, const UnseenPart& b) {
    return a.seconds != b.seconds ? a.seconds > b.seconds : a.length > b.length;
  });
  std::vector<UnseenPart> front;
  for (const UnseenPart& part : parts) {
    if (front.empty() || part.length > front.back().length) front.push_back(part);
  }
  return front;
}

// The part of a robot that is not counted on to brake, towards another robot that needs so many
// seconds until rest.
double part_of_mover(const RobotSetup& robot, double seconds) {
  return disc_radius(robot) + seconds * (model_traits(robot.model).speed_ratio * robot.max_speed);
}

// Robots of the same layers and behavior that all keep the certificate, or all do not, longest
// first.
using Kinds =
    std::map<std::tuple<std::uint32_t, std::uint32_t, Behavior, bool>, std::vector<UnseenPart>>;

// Takes pairs in which at least one robot avoids the other, and keeps the certificate.
template <typename Take>
void take_by_kind(const Scenario& scenario, const CertificateLaw& law,
                  const std::vector<UnseenPart>& parts, const Take& take) {
  Kinds kinds;
  const auto robot = [&](const UnseenPart& part) -> const RobotSetup& {
    return listed_as(part.robot, scenario.robots);
  };
  for (const UnseenPart& part : parts)
    kinds[{robot(part).layers.bits, robot(part).avoids.bits, robot(part).behavior,
           keeps(scenario, robot(part), law)}]
        .push_back(part);
  for (auto& [key, kind] : kinds) {
    std::stable_sort(kind.begin(), kind.end(),
                     [](const UnseenPart& a, const UnseenPart& b) { return a.length > b.length; });
  }
  const UsualMethod usual = usual_method(scenario);
  for (const auto& [key_a, of_a] : kinds) {
    const RobotSetup& a = robot(of_a.front());
    if (!keeps(scenario, a, law)) continue;
    const std::vector<UnseenPart> front = worst_for_movers(of_a);
    for (const auto& [key_b, of_b] : kinds) {
      const RobotSetup& b = robot(of_b.front());
      const auto expected = expected_of(conduct_of(b, usual), conduct_of(a, usual));
      if (!expected) continue;
      if (*expected == Expectation::decides) {
        const std::size_t second = key_a == key_b ? 1 : 0;
        if (second < of_b.size()) take(of_a.front(), of_b[second].robot, of_b[second].length);
        continue;
      }
      for (const UnseenPart& avoiding : front) {
        for (const UnseenPart& mover : of_b)
          take(avoiding, mover.robot, part_of_mover(robot(mover), avoiding.seconds));
      }
    }
  }
}

}  // namespace

std::optional<SensingNeed> sensing_need(const Scenario& scenario, const CertificateLaw& law) {
  std::optional<SensingNeed> worst;
  const auto take = [&](const UnseenPart& part, BodyId other, double other_part) {
    const double range = part.length + other_part;
    if (!worst || range > worst->range) {
      worst = SensingNeed{range, part.robot, other, part.length, other_part};
    }
  };
  std::vector<UnseenPart> parts;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    if (!is_parked(scenario.robots[i])) parts.push_back(part_of(scenario, i, law));
  }
  if (is_mixed(scenario)) {
    take_by_kind(scenario, law, parts, take);
  } else if (parts.size() > 1) {
    UnseenPart first = parts[0],
               second = parts[1];  // the longest two, in the order of their numbers
    for (std::size_t i = 2; i < parts.size(); ++i) {
      UnseenPart& shorter = first.length < second.length ? first : second;
      if (parts[i].length <= shorter.length) continue;
      if (&shorter == &first) first = second;
      second = parts[i];
    }
    take(first, second.robot, second.length);
  }
  if (scenario.moving_obstacles.empty()) return worst;
  std::erase_if(parts, [&](const UnseenPart& part) {
    return !keeps(scenario, listed_as(part.robot, scenario.robots), law);
  });
  const std::vector<UnseenPart> front = worst_for_movers(parts);
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k) {
    for (const UnseenPart& part : front) {
      take(part, MovingObstacleId{k},
           part_of(scenario.moving_obstacles[k], part.seconds, scenario.duration, law));
    }
  }
  return worst;
}

namespace {

// m/s: a robot that flies cannot be slower than its least speed.
double limited_speed(const RobotSetup& robot, double limit) {
  return std::min(robot.max_speed, std::max(limit, model_traits(robot.model).least_speed));
}

double scene_top_speed(const Scenario& scenario, const CertificateLaw& law) {
  double top = 0.0;
  for (const RobotSetup& robot : scenario.robots) {
    if (keeps(scenario, robot, law)) top = std::max(top, robot.max_speed);
  }
  return top;
}

}  // namespace

CertificateLaw certificate_law(const Scenario& scenario) {
  return certificate_law(Planner(certified_options(scenario)));
}

bool suffices(double sensing_radius, const std::optional<SensingNeed>& needed) {
  return !needed || sensing_radius >= (1.0 - kSumRounding) * needed->range;
}

}  // namespace avo::inline sim

namespace avo {

std::optional<SensingNeed> sensing_need(const Scenario& scenario) {
  const CertificateLaw law = certificate_law(scenario);
  if (law.kind == Certificate::none) return {};
  return sensing_need(scenario, law);
}

double admissible_speed(const Scenario& scenario) {
  const CertificateLaw law = certificate_law(scenario);
  if (law.kind == Certificate::none) return kInfinity;
  const double sensing_radius = sensing_radius_of(scenario);
  Scenario limited = scenario;
  const auto is_seen = [&](double limit) {  // if no robot is faster than the limit
    for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
      const RobotSetup& robot = scenario.robots[i];
      if (keeps(scenario, robot, law)) limited.robots[i].max_speed = limited_speed(robot, limit);
    }
    return suffices(sensing_radius, sensing_need(limited, law));
  };
  const double top = scene_top_speed(scenario, law);
  if (is_seen(top)) return kInfinity;
  const double least = std::numeric_limits<double>::min();
  if (!is_seen(least)) return 0.0;
  // positive doubles have the order of their bits
  auto seen = std::bit_cast<std::uint64_t>(least), unseen = std::bit_cast<std::uint64_t>(top);
  while (unseen - seen > 1) {
    const std::uint64_t middle = seen + (unseen - seen) / 2;
    (is_seen(std::bit_cast<double>(middle)) ? seen : unseen) = middle;
  }
  return std::bit_cast<double>(seen);
}

std::int64_t start_at_rest(Scenario& scenario) {
  std::int64_t moved = 0;
  for (RobotSetup& robot : scenario.robots) {
    const double least = model_traits(robot.model).least_speed;
    if (exceeds(norm(start_velocity(robot)), least)) ++moved;
    robot.velocity = least > 0.0 ? least * elementary::direction(robot.heading) : Vec2{};
  }
  return moved;
}

LimitedSpeeds limit_speed(Scenario& scenario) {
  LimitedSpeeds result{0, admissible_speed(scenario), 0};
  const CertificateLaw law = certificate_law(scenario);
  if (law.kind == Certificate::none) return result;
  for (RobotSetup& robot : scenario.robots) {
    if (!keeps(scenario, robot, law)) continue;
    const double limited = limited_speed(robot, result.limit);
    if (result.limit > 0.0 && robot.max_speed > limited) {
      robot.max_speed = limited;
      robot.preferred_speed = std::min(robot.preferred_speed, limited);
      ++result.robots;
    }
    const double speed = norm(robot.velocity);
    if (!exceeds(speed, robot.max_speed)) continue;
    robot.velocity = (robot.max_speed / speed) * robot.velocity;
    ++result.starts;
  }
  return result;
}

}  // namespace avo
