// SPDX-License-Identifier: Apache-2.0
// A simulation's state, and decisions in words, as bytes in the caller's memory.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "avo/explanation.h"
#include "simulations.h"

namespace avo_c {
namespace {

std::span<const std::byte> bytes_of(const void* saved, std::size_t size) {
  const auto* bytes = static_cast<const std::byte*>(saved);
  require_array(bytes, size, "saved");
  return {bytes, size};
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_save(avo_simulation_id simulation, void* buffer, size_t capacity,
                               size_t* size) {
  return guarded([&] {
    std::size_t& written = at(size, "size");
    const std::vector<std::byte> saved = simulations.at(simulation).simulation.save();
    write_bytes(saved.data(), saved.size(), buffer, capacity, written);
  });
}

avo_result avo_simulation_explain(avo_simulation_id simulation, avo_robot_id robot, char* buffer,
                                  size_t capacity, size_t* size) {
  return guarded([&] {
    std::size_t& written = at(size, "size");
    const avo::Simulation& own = simulations.at(simulation).simulation;
    const std::string words = own.explain(present(own, robot)).sentence;
    write_bytes(words.c_str(), words.size() + 1, buffer, capacity, written);
  });
}

avo_result avo_simulation_restore(avo_simulation_id simulation, const void* saved, size_t size) {
  return guarded([&] {
    Simulation& own = simulations.at(simulation);
    own.simulation.restore(bytes_of(saved, size));
    own.has_ids.store(false, std::memory_order_relaxed);
    own.chains.clear();
    try {
      restart_metrics(own);
    } catch (...) {
      lose_metrics(own);
    }
  });
}

avo_result avo_create_simulation_from_saved(const void* saved, size_t size,
                                            const avo_simulation_def* def,
                                            avo_simulation_id* simulation) {
  return guarded([&] {
    avo_simulation_id& id = at(simulation, "simulation");
    avo_simulation_def known = avo_default_simulation_def();
    if (def != nullptr) known = read(def, {"def"}, known);
    if (known.metrics)
      fail(AVO_ERROR_UNSUPPORTED, "metrics: found true, must be false for a saved simulation");
    id = simulations.add(std::make_unique<Simulation>(make(bytes_of(saved, size), known)));
  });
}
