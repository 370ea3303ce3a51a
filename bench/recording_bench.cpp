// SPDX-License-Identifier: Apache-2.0
// The cost of a recording. It measures the run itself (the step and add()) by the processor time of
// its thread, so that load on the machine does not count. It also measures bytes per robot-step,
// and the speed of writing CSV.
#include <benchmark/benchmark.h>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <unistd.h>

#include "avo/simulation.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"

namespace {

constexpr int kSteps = 2000;

// Returns s, of this thread.
double thread_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void record(benchmark::State& state, const std::string& name) {
  avo_io::SceneSource source;
  const avo::Scenario scenario = avo_io::load_scenario("circle-1000", {}, &source);
  const std::string path =
      (std::filesystem::temp_directory_path() / std::to_string(getpid())).string() + name;
  double stepping = 0.0, adding = 0.0;
  std::uintmax_t bytes = 0;
  for (auto _ : state) {
    avo::Simulation simulation(scenario, 1);
    const auto recording = avo_io::open_recording(path, scenario, source);
    for (int k = 0; k < kSteps; ++k) {
      const double start = thread_time();
      simulation.step();
      const double middle = thread_time();
      recording->add(simulation);
      stepping += middle - start;
      adding += thread_time() - middle;
    }
    recording->finish(simulation);
    recording->commit();
    bytes = std::filesystem::file_size(path);
    std::filesystem::remove(path);
  }
  const double robot_steps = 1000.0 * kSteps;
  state.counters["blocked_percent"] = 100.0 * adding / stepping;
  state.counters["bytes_a_robot_step"] = static_cast<double>(bytes) / robot_steps;
  state.counters["MB_per_s"] =
      1e-6 * static_cast<double>(bytes) * static_cast<double>(state.iterations()) / adding;
}

void hdf5(benchmark::State& state) {
  record(state, ".h5");
}
BENCHMARK(hdf5)->Iterations(3)->Unit(benchmark::kMillisecond)->UseRealTime();

void csv(benchmark::State& state) {
  record(state, ".csv");
}
BENCHMARK(csv)->Iterations(3)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
