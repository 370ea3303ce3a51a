// SPDX-License-Identifier: Apache-2.0
// Decisions in space in words.
#include <string>

#include "avo/space/explanation.h"
#include "space_simulations.h"

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_space_simulation_explain(avo_space_simulation_id simulation, avo_robot_id robot,
                                        char* buffer, size_t capacity, size_t* size) {
  return guarded([&] {
    std::size_t& written = at(size, "size");
    const avo::space::Simulation& fleet = fleets.at(simulation);
    const std::string words = fleet.explain(present(fleet, robot)).sentence;
    write_bytes(words.c_str(), words.size() + 1, buffer, capacity, written);
  });
}
