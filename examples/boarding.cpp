// SPDX-License-Identifier: Apache-2.0
// Passengers queue at the closed door of a bus. The door opens, they board one after the other to
// their seats, and the door closes behind the last one.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

constexpr int kPassengers = 12;
constexpr avo::Vec2 kStop{0, -1.2};  // m, before the door

avo::StaticObstacle wall(std::vector<avo::Vec2> points) {
  return {{{std::move(points), false}}};
}

}  // namespace

int main() {
  avo::Scenario scene;
  // a bus of 14 m by 3 m, whose door is 1.2 m wide
  scene.obstacles = {wall({{-0.6, 0}, {-1, 0}, {-1, 3}, {13, 3}, {13, 0}, {0.6, 0}})};
  std::vector<avo::RobotId> passengers;
  for (int k = 0; k < kPassengers; ++k) {
    avo::RobotSetup passenger;
    passenger.radius = 0.25;
    passenger.max_speed = passenger.preferred_speed = 1.2;
    passenger.position = {-2.0 - 0.9 * (k % 6), -3.0 - 0.9 * (k / 6)};
    passenger.goal = {12.3 - 1.8 * (k / 2), k % 2 == 0 ? 0.5 : 2.5};  // the rear seats first
    passengers.push_back({scene.robots.size()});
    scene.robots.push_back(passenger);
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  avo::Team queue = avo::make_team(
      passengers, avo::Queue{.line = {kStop, {0, -2.5}, {-12, -2.5}}, .spacing = 0.8});
  const avo::StaticObstacle door = wall({{-0.6, 0}, {0.6, 0}});
  const avo::ObstacleId closed = simulation.add_obstacle(door);
  const auto go_on = [&] {
    lead(simulation, queue);
    simulation.step();
    metrics.observe(simulation);
  };
  while (simulation.can_step_by(12.0)) go_on();  // they line up
  const double opened = simulation.time();
  simulation.remove_obstacle(closed);
  double served = opened;
  while (!(queue.members.empty() && simulation.all_at_goal()) && simulation.can_step_by(180.0)) {
    go_on();
    const bool is_door_clear = simulation.robots_within({0, 0.3}, 0.5).empty();
    if (queue.members.empty() || !is_door_clear || simulation.time() - served < 2.0) continue;
    serve(simulation, queue);
    served = simulation.time();
  }
  const bool all_sit = simulation.all_at_goal();
  std::printf("%s sit %.1f s after the door opened, ", all_sit ? "all" : "not all",
              simulation.time() - opened);
  simulation.add_obstacle(door);  // refused if somebody stood in it
  const avo::RunSummary summary = metrics.summary();
  std::printf("%d pairs touched, %d touched the bus\n", int(summary.collision_pairs),
              int(summary.static_collisions));
  return all_sit && summary.collision_pairs == 0 && summary.static_collisions == 0 ? 0 : 1;
}
