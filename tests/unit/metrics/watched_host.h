// SPDX-License-Identifier: Apache-2.0
// A simulation with its events, in words.
#pragma once
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "avo/events.h"
#include "unit/sim/scenes.h"

namespace avo::test {

/// "arrived 3 contact 3/0 rest": the events in their order.
inline std::string told(std::span<const Event> events) {
  std::string text;
  for (const Event& event : events) {
    text += (text.empty() ? "" : " ") + std::string(to_string(event.kind)) + " " +
            std::to_string(event.robot.value);
    if (event.kind == EventKind::contact)
      text += (event.moved_robot ? "/robot " + std::to_string(event.moved_robot->value)
                                 : "/" + std::to_string(event.moving_obstacle.value)) +
              (event.at_rest ? " rest" : "");
    EXPECT_EQ(event.sentence.empty(), event.kind != EventKind::stuck);
  }
  return text;
}

/// A simulation with its events, of the plane or of space.
template <class Scenario, class Simulation, class Events>
struct WatchedHostOf {
  explicit WatchedHostOf(const Scenario& scene, double stuck_after = 3.0, int threads = 1)
      : simulation(scene, threads), events(simulation, {.stuck_after = stuck_after}) {}

  Simulation simulation;
  Events events;

  std::string look() { return told(events.observe(simulation)); }
  std::string step() {
    simulation.step();
    return look();
  }
  /// The events of that many steps.
  std::string run(int steps) {
    std::string text;
    for (int k = 0; k < steps; ++k)
      if (const std::string now = step(); !now.empty()) text += (text.empty() ? "" : " ") + now;
    return text;
  }
};
using WatchedHost = WatchedHostOf<Scenario, Simulation, Events>;

inline Scenario watched_scene(std::vector<RobotSetup> robots) {
  Scenario scene;
  scene.sensing_radius = 40.0;
  scene.robots = std::move(robots);
  return scene;
}

}  // namespace avo::test
