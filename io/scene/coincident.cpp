// SPDX-License-Identifier: Apache-2.0
#include "io/scene/coincident.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "avo/assumptions.h"

namespace avo_io {

std::optional<std::pair<std::size_t, std::size_t>> find_coincident(
    const std::vector<avo::RobotSetup>& robots) {
  std::vector<std::size_t> order(robots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    return std::tuple(robots[i].position.x, robots[i].position.y, i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  avo::RobotSetup all;  // at one point
  for (std::size_t i = 0, first = 0; i < order.size(); ++i) {
    const avo::RobotSetup& robot = robots[order[i]];
    if (!(robots[order[first]].position == robot.position)) first = i;
    if (first == i) all = robot;
    if (first != i && keep_apart(all, robot)) {
      const auto other =
          std::find_if(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
                       [&](std::size_t k) { return keep_apart(robots[k], robot); });
      return std::pair(*other, order[i]);
    }
    all.layers.bits |= robot.layers.bits, all.avoids.bits |= robot.avoids.bits;
    if (is_parked(robot)) all.behavior = avo::Behavior::parked;
  }
  return std::nullopt;
}

}  // namespace avo_io
