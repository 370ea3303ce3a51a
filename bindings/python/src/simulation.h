// SPDX-License-Identifier: Apache-2.0
// A simulation that several Python threads may use: one thread at a time, while the others wait.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "avo/simulation.h"
#include "bind.h"
#include "shared.h"

namespace avo_python {

class SharedSimulation : public Shared<avo::Simulation> {
 public:
  SharedSimulation(avo::Simulation simulation, std::string name)
      : Shared(std::move(simulation)), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The function of its external method, for copies.
  avo::ExternalMethod external = {};

 private:
  std::string name_;  // of the scene
};

using SimulationClass = py::class_<SharedSimulation>;
void bind_columns(SimulationClass& simulation);
void bind_edits(SimulationClass& simulation);
void bind_perception(py::module_& module, SimulationClass& simulation);
void bind_queries(SimulationClass& simulation);
void bind_routes(py::module_& module, SimulationClass& simulation);
void bind_team_edits(SimulationClass& simulation);

/// Ids are not negative; Error as for a robot that is not there.
avo::RobotId robot_id(std::int64_t id);
std::vector<avo::RobotId> robot_ids(const std::vector<std::int64_t>& ids);

template <typename F>
auto told(F f) {
  return [f](SharedSimulation& self) { return self.briefly(f); };
}

}  // namespace avo_python
