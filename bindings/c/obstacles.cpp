// SPDX-License-Identifier: Apache-2.0
// The obstacles that are in a simulation.
#include <algorithm>
#include <mutex>
#include <vector>

#include "layouts.h"
#include "simulations.h"

namespace avo_c {
namespace {

// The entry of an obstacle in a column of its view.
template <typename Column, typename View>
const auto& entry(const Column& column, const View& view, std::uint64_t number) {
  const auto id = among(view.id, number);
  return column[static_cast<std::size_t>(std::ranges::find(view.id, id) - view.id.begin())];
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_moving_obstacle_ids(avo_simulation_id simulation,
                                              avo_moving_obstacle_id* buffer, size_t capacity,
                                              size_t* count) {
  return guarded([&] {
    list(simulations.at(simulation).simulation.moving_obstacles().id, buffer, capacity, count);
  });
}

avo_result avo_simulation_obstacles(avo_simulation_id simulation, avo_obstacle_id* buffer,
                                    size_t capacity, size_t* count) {
  return guarded(
      [&] { list(simulations.at(simulation).simulation.obstacles().id, buffer, capacity, count); });
}

avo_result avo_simulation_get_moving_obstacle_def(avo_simulation_id simulation,
                                                  avo_moving_obstacle_id obstacle,
                                                  avo_moving_obstacle_def* def) {
  return guarded([&] {
    const avo::MovingObstacleView view = simulations.at(simulation).simulation.moving_obstacles();
    avo_moving_obstacle_def present = def_of(entry(view.setup, view, obstacle.value));
    present.position = to_c(entry(view.position, view, obstacle.value));
    present.velocity = to_c(entry(view.velocity, view, obstacle.value));
    write(def, present, {"def"});
  });
}

avo_result avo_simulation_get_obstacle_def(avo_simulation_id simulation, avo_obstacle_id obstacle,
                                           avo_obstacle_def* def) {
  return guarded([&] {
    Simulation& own = simulations.at(simulation);
    const avo::StaticObstacleView view = own.simulation.obstacles();
    const avo::StaticObstacle& setup = entry(view.setup, view, obstacle.value);
    const std::lock_guard lock(own.looking);
    std::vector<avo_chain>& chains = own.chains[obstacle.value];
    write(def, def_of(setup, chains), {"def"});
  });
}
