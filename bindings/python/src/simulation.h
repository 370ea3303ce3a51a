// SPDX-License-Identifier: Apache-2.0
// A simulation that several Python threads may use: one thread at a time, while the others wait.
#pragma once
#include <string>
#include <utility>

#include "avo/simulation.h"
#include "bind.h"
#include "shared.h"

namespace avo_python {

class SharedSimulation : public Shared<avo::Simulation> {
 public:
  SharedSimulation(avo::Simulation simulation, std::string name)
      : Shared(std::move(simulation)), name_(std::move(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;  // of the scene
};

using SimulationClass = py::class_<SharedSimulation>;
void bind_columns(SimulationClass& simulation);

}  // namespace avo_python
