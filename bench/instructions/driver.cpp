// SPDX-License-Identifier: Apache-2.0
// avo_bench_instructions SCENE FIRST STEPS [--goals | --metrics] [KEY=VALUE]...: it takes FIRST
// steps and then STEPS more. The latter run in measured_steps(), of a scene of space in
// measured_steps_in_space(); callgrind counts them by these names. With --goals, a host looks at
// every robot before each step and gives it another goal. With --metrics, the run is observed after
// each step. Scenes of space have neither. It runs on one thread. See check.py.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/metrics.h"
#include "avo/simd.h"
#include "avo/simulation.h"
#include "avo/space/simulation.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"

namespace {

// Counts are comparable only for the same compiler.
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

// The work besides the steps.
struct Host {
  bool gives_goals = false;
  std::optional<avo::Metrics> metrics = {};
};

namespace {

// Gives goals as a host would that knows ids.
void give_goals(avo::Simulation& simulation) {
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    const avo::RobotState state = simulation.robot({i});
    simulation.set_goal(state.id, -1.0 * state.goal);
  }
}

void take_steps(avo::Simulation& simulation, Host& host, long steps) {
  for (long k = 0; k < steps; ++k) {
    if (host.gives_goals) give_goals(simulation);
    simulation.step();
    if (host.metrics) host.metrics->observe(simulation);
  }
}

}  // namespace

extern "C" [[gnu::noinline]] void measured_steps(avo::Simulation& simulation, Host& host,
                                                 long steps) {
  take_steps(simulation, host, steps);
}

extern "C" [[gnu::noinline]] void measured_steps_in_space(avo::space::Simulation& simulation,
                                                          long steps) {
  for (long k = 0; k < steps; ++k) simulation.step();
}

namespace {

void print(double robot_steps, std::uint64_t hash) {
  std::printf("robot_steps %ld\nsimd %s\nhash %016llx\ncompiler %s\n", std::lround(robot_steps),
              avo::simd_target(), static_cast<unsigned long long>(hash), compiler().c_str());
}

void run_in_space(const avo::space::Scenario& scenario, long first, long steps) {
  avo::space::Simulation simulation(scenario, 1);
  for (long k = 0; k < first; ++k) simulation.step();
  measured_steps_in_space(simulation, steps);
  print(static_cast<double>(steps) * static_cast<double>(simulation.size()),
        simulation.state_hash());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "usage: avo_bench_instructions SCENE FIRST STEPS [KEY=VALUE]...\n");
    return 2;
  }
  try {
    avo::check_simd_target();
    std::vector<std::string> overrides(argv + 4, argv + argc);
    const bool is_observed = std::erase(overrides, "--metrics") > 0;
    Host host{.gives_goals = std::erase(overrides, "--goals") > 0};
    const long first = std::atol(argv[2]), steps = std::atol(argv[3]);
    if (const auto in_space = avo_io::load_space_scenario(argv[1], overrides)) {
      run_in_space(*in_space, first, steps);
      return 0;
    }
    const avo::Scenario scenario = avo_io::load_scenario(argv[1], overrides);
    avo::Simulation simulation(scenario, 1);
    if (is_observed) host.metrics.emplace(scenario).observe(simulation);
    take_steps(simulation, host, first);
    const double begin = simulation.time();
    measured_steps(simulation, host, steps);
    const double own_steps = (simulation.time() - begin) / scenario.time_step;  // of each robot
    print(own_steps * static_cast<double>(scenario.robots.size()), simulation.state_hash());
  } catch (const avo::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
