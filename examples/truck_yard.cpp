// SPDX-License-Identifier: Apache-2.0
// A truck of 6 m by 2 m goes through a yard: a lane of 4 m between containers, forklifts that cross
// it, and a parked truck beside its bay. The one disc that covers the truck is 6.3 m wide, and fits
// into no lane. Its footprint of three discs does.
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

avo::StaticObstacle block(double left, double bottom, double right, double top) {
  const avo::Chain around{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, true};
  return {{around}, 0.0, avo::Fill::solid};
}

avo::RobotSetup truck(avo::Vec2 position, double heading, avo::Vec2 goal) {
  avo::RobotSetup setup;
  setup.position = position, setup.heading = heading, setup.goal = goal;
  avo::Car car{.wheelbase = 3.5, .max_curvature = 0.2, .reverse = true};
  car.footprint = avo::cover_rectangle(6.0, 2.0, 1.75, 0.5);
  setup.model = car;
  return setup;
}

avo::RobotSetup forklift(avo::Vec2 position, double heading, avo::Vec2 goal) {
  avo::RobotSetup setup;
  setup.position = position, setup.heading = heading, setup.goal = goal;
  avo::DifferentialDrive drive{.track = 1.0, .offset = 0.5, .wheel_speed = 1.5};
  drive.footprint = avo::cover_rectangle(2.4, 1.1, 0.3, 0.3);
  setup.model = drive;
  setup.max_speed = setup.preferred_speed = 1.5;
  setup.max_acceleration = 0.5 * avo::most_acceleration(drive);
  return setup;
}

avo::Scenario yard() {
  avo::Scenario scene;
  scene.duration = 90.0;
  scene.obstacles = {block(-14, 2, -2, 6), block(2, 2, 14, 6),  // above the lane
                     block(-14, -6, -2, -2), block(2, -6, 14, -2)};
  scene.robots = {truck({-26, 0}, 0.0, {20, 0}), forklift({0, -10}, 1.5708, {0, 12}),
                  forklift({0, 10}, -1.5708, {0, -12})};
  avo::RobotSetup parked = truck({16, -6}, 1.5708, {16, -6});
  parked.behavior = avo::Behavior::parked;
  scene.robots.push_back(parked);
  return scene;
}

}  // namespace

int main() {
  const avo::Scenario scene = yard();
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  while (!metrics.all_arrived() && simulation.can_step_by(scene.duration)) {
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary summary = metrics.summary();
  const auto& footprint = std::get<avo::Car>(scene.robots[0].model).footprint;
  std::printf("a truck of %d discs: %d of 3 arrived after %.1f s, %d pairs touched, %d walls\n",
              footprint.discs, int(summary.arrived - 1), simulation.time(),
              int(summary.collision_pairs), int(summary.static_collisions));
}
