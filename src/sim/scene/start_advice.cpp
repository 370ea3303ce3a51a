// SPDX-License-Identifier: Apache-2.0
// Names the bodies that overlap at the start.
#include <algorithm>
#include <cstddef>
#include <utility>

#include "robots/model.h"
#include "sim/scene/advice.h"
#include "sim/scene/assumptions.h"

namespace avo::inline sim {
namespace {

struct StartDisc {
  Vec2 center;
  double radius;
  std::ptrdiff_t source;  // robot i, or -1 - k for moving obstacle k
};

std::string name(std::ptrdiff_t source) {
  if (source >= 0) return robot_name(static_cast<std::size_t>(source));
  return "moving obstacle " + std::to_string(-1 - source);
}

/// All discs, sorted along the axis of their wider spread.
std::vector<StartDisc> sorted_discs(const Scenario& scenario) {
  std::vector<StartDisc> discs;
  for (std::size_t i = 0; i < scenario.robots.size(); ++i)
    discs.push_back({disc_center(scenario.robots[i]), disc_radius(scenario.robots[i]),
                     static_cast<std::ptrdiff_t>(i)});
  for (std::size_t k = 0; k < scenario.moving_obstacles.size(); ++k)
    discs.push_back({scenario.moving_obstacles[k].position, scenario.moving_obstacles[k].radius,
                     -1 - static_cast<std::ptrdiff_t>(k)});
  const auto by_x = [](const StartDisc& a, const StartDisc& b) { return a.center.x < b.center.x; };
  const auto by_y = [](const StartDisc& a, const StartDisc& b) { return a.center.y < b.center.y; };
  const auto [left, right] = std::minmax_element(discs.begin(), discs.end(), by_x);
  const auto [low, high] = std::minmax_element(discs.begin(), discs.end(), by_y);
  if (high->center.y - low->center.y > right->center.x - left->center.x)
    for (StartDisc& disc : discs) disc.center = {disc.center.y, disc.center.x};
  std::stable_sort(discs.begin(), discs.end(), [](const StartDisc& a, const StartDisc& b) {
    return a.center.x - a.radius < b.center.x - b.radius;
  });
  return discs;
}

/// Returns whether the two may be in one place, or the certificate of one of them reports it.
bool may_overlap(const Scenario& scenario, const StartDisc& a, const StartDisc& b) {
  const auto robot = [&](const StartDisc& disc) {
    return disc.source < 0 ? nullptr : &scenario.robots[static_cast<std::size_t>(disc.source)];
  };
  const RobotSetup *first = robot(a), *second = robot(b);
  const auto is_told = [&](const RobotSetup* own) {
    return own != nullptr && keeps_certificate(scenario, *own);
  };
  if (is_told(first) || is_told(second)) return true;
  if (first == nullptr || second == nullptr) return first == second;
  return !keep_apart(*first, *second);
}

}  // namespace

std::string robot_name(std::size_t index) {
  return "robot " + std::to_string(index);
}

bool keeps_certificate(const Scenario& scenario, const RobotSetup& robot) {
  return certificate_of(scenario, robot) != Certificate::none;
}

void advise_overlaps(const Scenario& scenario, std::vector<std::string>& lines) {
  constexpr int kNamed = 3, kCounted = 1000;
  const bool all_told =
      std::all_of(scenario.robots.begin(), scenario.robots.end(),
                  [&](const RobotSetup& robot) { return keeps_certificate(scenario, robot); });
  if (all_told) return;
  const std::vector<StartDisc> discs = sorted_discs(scenario);
  int advised = 0;
  for (std::size_t i = 0; i < discs.size() && advised < kCounted; ++i) {
    const double end = discs[i].center.x + discs[i].radius;
    for (std::size_t j = i + 1; j < discs.size() && advised < kCounted; ++j) {
      if (discs[j].center.x - discs[j].radius > end) break;
      const StartDisc* a = &discs[i];
      const StartDisc* b = &discs[j];
      const double touching = a->radius + b->radius;
      const double distance = norm(a->center - b->center);
      if (distance >= (1.0 - 1e-9) * touching || may_overlap(scenario, *a, *b)) continue;
      if (++advised > kNamed) continue;
      if (b->source >= 0 && (a->source < 0 || b->source < a->source)) std::swap(a, b);
      lines.push_back(name(a->source) + " and " + name(b->source) + " overlap at the start: " +
                      in_short(distance) + " m between the centers, radii " + in_short(a->radius) +
                      " + " + in_short(b->radius) + " = " + in_short(touching) + " m");
    }
  }
  if (advised > kNamed)
    lines.push_back((advised == kCounted ? "at least " : "") + std::to_string(advised - kNamed) +
                    " further pairs overlap at the start");
}

}  // namespace avo::inline sim
