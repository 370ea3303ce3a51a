// SPDX-License-Identifier: Apache-2.0
// avo_starts FOLDER: the state in which each pinned run begins, as FOLDER/NAME.saved, and a line
// for it, NAME STEPS HASH. Programs without scene files can run them, as scripts/windows does.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "hashes/pinned_runs.h"

namespace {

void write_start(const avo_test::PinnedRun& run, const std::string& folder) {
  const avo::Scenario scenario = avo_io::load_scenario(run.scene, run.overrides);
  avo::Simulation simulation(scenario, 1);
  const auto saved = simulation.save();
  std::ofstream file(folder + "/" + run.name + ".saved", std::ios::binary);
  file.write(reinterpret_cast<const char*>(saved.data()),
             static_cast<std::streamsize>(saved.size()));
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.close();
  const auto steps = static_cast<long long>(avo_test::steps_of(run, scenario));
  std::printf("%s %lld 0x%016llx\n", run.name.c_str(), steps,
              static_cast<unsigned long long>(run.hash));
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::fprintf(stderr, "usage: avo_starts FOLDER\n");
    return 2;
  }
  for (const avo_test::PinnedRun& run : avo_test::pinned_runs()) write_start(run, arguments[1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "avo_starts: %s\n", error.what());
  return 1;
}
