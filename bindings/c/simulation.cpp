// SPDX-License-Identifier: Apache-2.0
// Simulations: made, stepped, edited.
#include "avo/simulation.h"

#include "external.h"
#include "simulations.h"

namespace avo_c {

void restart_metrics(Simulation& simulation) {
  if (!simulation.judged) return;
  auto metrics = std::make_unique<avo::Metrics>(*simulation.judged);
  metrics->observe(simulation.simulation);
  simulation.metrics = std::move(metrics);
}

void lose_metrics(Simulation& simulation) {
  simulation.metrics.reset();
  simulation.judged.reset();
  fail(AVO_ERROR_OUT_OF_MEMORY, "metrics: memory ran out, what was called for is done, they end");
}

namespace {

void observe(Simulation& simulation) {
  if (!simulation.metrics) return;
  try {
    simulation.metrics->observe(simulation.simulation);
  } catch (...) {
    lose_metrics(simulation);
  }
}

// change(simulation) of the simulation with that id; columns lent before are no longer valid.
template <typename Change>
avo_result changed(avo_simulation_id id, const Change& change) {
  return guarded([&] {
    Simulation& own = simulations.at(id);
    change(own);
    own.chains.clear();  // not before: what is changed may be a definition that was lent
  });
}

// The same for a change after which the simulation may have other robots.
template <typename Change>
avo_result repopulated(avo_simulation_id id, const Change& change) {
  return changed(id, [&](Simulation& own) {
    own.has_ids.store(false, std::memory_order_relaxed);
    change(own);
  });
}

avo::RobotId number_of(const Simulation& simulation, avo_robot_id robot) {
  return present(simulation.simulation, robot);
}

std::vector<avo::RobotId> numbers_of(const Simulation& simulation, const avo_robot_id* robots,
                                     std::size_t count) {
  if (count > 0) at(robots, "robots");
  std::vector<avo::RobotId> numbers;
  for (std::size_t k = 0; k < count; ++k) numbers.push_back(number_of(simulation, robots[k]));
  return numbers;
}

avo::ObstacleId number_of(const Simulation& simulation, avo_obstacle_id obstacle) {
  return among(simulation.simulation.obstacles().id, obstacle.value);
}

avo::MovingObstacleId number_of(const Simulation& simulation, avo_moving_obstacle_id obstacle) {
  return among(simulation.simulation.moving_obstacles().id, obstacle.value);
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_needed_sensing_radius(const avo_simulation_def* def, double* radius) {
  return guarded([&] {
    double& needed = at(radius, "radius");
    const avo::Scenario scenario = scenario_of(read(def, {"def"}, avo_default_simulation_def()));
    avo::validate(scenario);
    needed = avo::needed_sensing_radius(scenario);
  });
}

avo_result avo_create_simulation(const avo_simulation_def* def, avo_simulation_id* simulation) {
  return guarded([&] {
    avo_simulation_id& id = at(simulation, "simulation");
    const avo_simulation_def known = read(def, {"def"}, avo_default_simulation_def());
    avo::Scenario scenario = scenario_of(known);
    auto made = std::make_unique<Simulation>(make(scenario, known));
    if (known.metrics) made->judged = std::move(scenario);
    restart_metrics(*made);
    id = simulations.add(std::move(made));
  });
}

avo_result avo_destroy_simulation(avo_simulation_id simulation) {
  return guarded([&] { simulations.take(simulation); });
}

bool avo_simulation_is_valid(avo_simulation_id simulation) {
  return simulations.find(simulation) != nullptr;
}

avo_result avo_simulation_step(avo_simulation_id simulation) {
  return repopulated(simulation, [](Simulation& own) {
    own.simulation.step();
    const bool has_events = own.watch.observe(own.simulation);
    observe(own);
    require_events(has_events);
  });
}

avo_result avo_simulation_set_external(avo_simulation_id simulation, avo_external_method* external,
                                       void* context) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_external(external_of(external, context));
  });
}

avo_result avo_simulation_add_robot(avo_simulation_id simulation, const avo_robot_def* def,
                                    avo_robot_id* robot) {
  return repopulated(simulation, [&](Simulation& own) {
    avo_robot_id& id = at(robot, "robot");
    const avo_robot_def known = read(def, {"def"}, avo_default_robot_def());
    id = to_c(own.simulation.add_robot(setup_of(known, {"robot"})));
  });
}

avo_result avo_simulation_remove_robot(avo_simulation_id simulation, avo_robot_id robot) {
  return repopulated(simulation,
                     [&](Simulation& own) { own.simulation.remove_robot(number_of(own, robot)); });
}

avo_result avo_simulation_set_goal(avo_simulation_id simulation, avo_robot_id robot,
                                   avo_vec2 goal) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_goal(number_of(own, robot), from_c(goal));
  });
}

avo_result avo_simulation_move_robot(avo_simulation_id simulation, avo_robot_id robot,
                                     avo_vec2 position) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.move_robot(number_of(own, robot), from_c(position));
  });
}

avo_result avo_simulation_change_robot(avo_simulation_id simulation, avo_robot_id robot,
                                       const avo_robot_def* def) {
  return repopulated(simulation, [&](Simulation& own) {
    const avo_robot_def known = read(def, {"def"}, avo_default_robot_def());
    own.simulation.change_robot(number_of(own, robot), setup_of(known, {"robot"}));
  });
}

avo_result avo_simulation_set_preferred_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                                 const avo_vec2* velocity) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_preferred_velocity(
        number_of(own, robot),
        velocity != nullptr ? std::optional(from_c(*velocity)) : std::nullopt);
  });
}

avo_result avo_simulation_set_velocity(avo_simulation_id simulation, avo_robot_id robot,
                                       const avo_vec2* velocity) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_velocity(number_of(own, robot), velocity != nullptr
                                                           ? std::optional(from_c(*velocity))
                                                           : std::nullopt);
  });
}

avo_result avo_simulation_set_goals(avo_simulation_id simulation, const avo_robot_id* robots,
                                    const avo_vec2* goals, size_t count) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_goals(numbers_of(own, robots, count), points_of(goals, count, "values"));
  });
}

avo_result avo_simulation_set_preferred_velocities(avo_simulation_id simulation,
                                                   const avo_robot_id* robots,
                                                   const avo_vec2* velocities, size_t count) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.set_preferred_velocities(numbers_of(own, robots, count),
                                            points_of(velocities, count, "values"));
  });
}

avo_result avo_simulation_add_robots(avo_simulation_id simulation, const avo_robot_def* defs,
                                     size_t count, avo_robot_id* robots) {
  return repopulated(simulation, [&](Simulation& own) {
    if (count > 0) at(robots, "robots");
    std::vector<avo::RobotSetup> setups;
    for_each(defs, count, "defs", avo_default_robot_def(),
             [&](const avo_robot_def& def, const Where& where) {
               setups.push_back(setup_of(def, where));
             });
    for (const avo::RobotId id : own.simulation.add_robots(setups)) *robots++ = to_c(id);
  });
}

avo_result avo_simulation_remove_robots(avo_simulation_id simulation, const avo_robot_id* robots,
                                        size_t count) {
  return repopulated(simulation, [&](Simulation& own) {
    own.simulation.remove_robots(numbers_of(own, robots, count));
  });
}

avo_result avo_simulation_add_moving_obstacle(avo_simulation_id simulation,
                                              const avo_moving_obstacle_def* def,
                                              avo_moving_obstacle_id* obstacle) {
  return changed(simulation, [&](Simulation& own) {
    avo_moving_obstacle_id& id = at(obstacle, "obstacle");
    const avo_moving_obstacle_def known = read(def, {"def"}, avo_default_moving_obstacle_def());
    id = {own.simulation.add_moving_obstacle(obstacle_of(known, {"moving_obstacle"})).value + 1};
  });
}

avo_result avo_simulation_change_moving_obstacle(avo_simulation_id simulation,
                                                 avo_moving_obstacle_id obstacle,
                                                 const avo_moving_obstacle_def* def) {
  return changed(simulation, [&](Simulation& own) {
    const avo_moving_obstacle_def known = read(def, {"def"}, avo_default_moving_obstacle_def());
    own.simulation.change_moving_obstacle(number_of(own, obstacle),
                                          obstacle_of(known, {"moving_obstacle"}));
  });
}

avo_result avo_simulation_remove_moving_obstacle(avo_simulation_id simulation,
                                                 avo_moving_obstacle_id obstacle) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.remove_moving_obstacle(number_of(own, obstacle));
  });
}

avo_result avo_simulation_add_obstacle(avo_simulation_id simulation, const avo_obstacle_def* def,
                                       avo_obstacle_id* obstacle) {
  return changed(simulation, [&](Simulation& own) {
    avo_obstacle_id& id = at(obstacle, "obstacle");
    const avo_obstacle_def known = read(def, {"def"}, avo_default_obstacle_def());
    id = {own.simulation.add_obstacle(obstacle_of(known, {"obstacle"})).value + 1};
  });
}

avo_result avo_simulation_remove_obstacle(avo_simulation_id simulation, avo_obstacle_id obstacle) {
  return changed(simulation, [&](Simulation& own) {
    own.simulation.remove_obstacle(number_of(own, obstacle));
  });
}
