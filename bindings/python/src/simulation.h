// SPDX-License-Identifier: Apache-2.0
// A simulation that several Python threads may use: one at a time, the others wait.
#pragma once
#include <mutex>
#include <string>
#include <utility>

#include "avo/simulation.h"
#include "bind.h"

namespace avo_python {

class SharedSimulation {
 public:
  SharedSimulation(avo::Simulation simulation, std::string name)
      : name_(std::move(name)), simulation_(std::move(simulation)) {}

  [[nodiscard]] const std::string& name() const { return name_; }

  /// f(simulation), without Python's lock; f must not touch Python. Nobody who holds the mutex ever
  /// waits for Python's lock, so that these two cannot wait for each other.
  template <typename F>
  auto alone(F f) {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return f(simulation_);
  }

  /// The same for what takes less time than giving up Python's lock.
  template <typename F>
  auto briefly(F f) {
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock.owns_lock())
      return f(std::as_const(simulation_));
    return alone([&f](const avo::Simulation& simulation) { return f(simulation); });
  }

 private:
  std::string name_;  // of the scene
  std::mutex mutex_;
  avo::Simulation simulation_;
};

using SimulationClass = py::class_<SharedSimulation>;
void bind_columns(SimulationClass& simulation);

}  // namespace avo_python
