// SPDX-License-Identifier: Apache-2.0
// avo_bench_instructions SCENE FIRST STEPS [KEY=VALUE]...: takes FIRST steps and then STEPS more,
// the latter in measured_steps(), by whose name callgrind counts them. One thread. See check.py.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/simd.h"
#include "avo/simulation.h"
#include "avo_io/scene.h"

namespace {

// Counts are comparable for one of these only.
std::string compiler() {
#if defined(__clang__)
  const std::string name = "clang++ ";
#else
  const std::string name = "g++ ";
#endif
#if defined(__x86_64__)
  return name + __VERSION__ + " x86_64";
#else
  return name + __VERSION__;
#endif
}

}  // namespace

extern "C" [[gnu::noinline]] void measured_steps(avo::Simulation& simulation, long steps) {
  for (long k = 0; k < steps; ++k) simulation.step();
}

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: avo_bench_instructions SCENE FIRST STEPS [KEY=VALUE]...\n");
    return 2;
  }
  try {
    avo::check_simd_target();
    const std::vector<std::string> overrides(argv + 4, argv + argc);
    const avo::Scenario scenario = avo_io::load_scenario(argv[1], overrides);
    avo::Simulation simulation(scenario, 1);
    const long first = std::atol(argv[2]), steps = std::atol(argv[3]);
    for (long k = 0; k < first; ++k) simulation.step();
    measured_steps(simulation, steps);
    std::printf("robot_steps %ld\nsimd %s\nhash %016llx\ncompiler %s\n",
                steps * static_cast<long>(scenario.robots.size()), avo::simd_target(),
                static_cast<unsigned long long>(simulation.state_hash()), compiler().c_str());
  } catch (const avo::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
