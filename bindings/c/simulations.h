// SPDX-License-Identifier: Apache-2.0
// The object behind a simulation's id.
#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "avo/events.h"
#include "avo/executor.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "convert.h"
#include "handles.h"
#include "ids.h"
#include "watch.h"

namespace avo_c {

struct Simulation {
  explicit Simulation(avo::Simulation made) : simulation(std::move(made)) {}

  avo::Simulation simulation;
  std::optional<avo::Scenario> judged;  // where there are metrics
  std::unique_ptr<avo::Metrics> metrics;
  Watch<avo::Events> watch;

  std::mutex looking;
  std::atomic<bool> has_ids = false;
  std::vector<avo_robot_id> ids;                           // of the columns; made on demand
  std::map<std::uint64_t, std::vector<avo_chain>> chains;  // of definitions that are lent
};

inline AVO_C_CONSTINIT Handles<avo_simulation_id, Simulation> simulations("simulation");

/// The id in C++ of a robot that is present. Throws Failure if the id is null or the robot is gone.
avo::RobotId present(const avo::Simulation& simulation, avo_robot_id robot);

/// Begins the metrics anew, if there are any.
void restart_metrics(Simulation& simulation);

/// Ends the metrics, because they missed a change of the simulation. Throws Failure that says so.
[[noreturn]] void lose_metrics(Simulation& simulation);

/// Makes a simulation on the host's threads, or on as many threads as the definition says.
avo::Simulation make(const avo::Scenario& scenario, const avo_simulation_def& def);
avo::Simulation make(std::span<const std::byte> saved, const avo_simulation_def& def);

/// value = of(simulation) for the simulation with that id.
template <typename Value, typename Of>
avo_result get(avo_simulation_id id, Value* value, const Of& of) {
  return guarded([&] {
    const Simulation& own = simulations.at(id);
    at(value, "result") = of(own.simulation);
  });
}

}  // namespace avo_c
