// SPDX-License-Identifier: Apache-2.0
// Scenes and recordings as a user would: a built-in scene is run, recorded, read again; a bad scene
// is refused by an exception that is caught as what it is. usage: io RECORDING
#include <avo_io/recording.h>
#include <avo_io/scene.h>
#include <cstdio>
#include <string>

#include <avo/avo.h>

namespace {

bool refuses_bad_scenes() {
  try {
    avo_io::parse_scenario("version: 1\nrobotz: []\n", "bad.yaml");
  } catch (const avo_io::SceneError& error) {
    return std::string(error.what()).find("robotz") != std::string::npos;
  }
  return false;
}

bool refuses_missing_files() {
  try {
    avo_io::load_scenario("/no/such/scene.yaml");
  } catch (const avo::Error&) {
    return true;
  }
  return false;
}

}  // namespace

int main(int, char** arguments) {
  const avo::Scenario scene = avo_io::load_scenario("circle-10", {"time_step=0.1"});
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  {
    avo_io::CsvRecording recording(arguments[1]);
    for (int step = 0; step < 10; ++step) {
      metrics.observe(simulation);
      recording.add(simulation);
      simulation.step();
    }
    recording.commit();
  }
  avo_io::RecordingReader reader(arguments[1]);
  avo_io::RecordedTime moment;
  std::size_t rows = 0;
  while (reader.next(moment)) rows += moment.rows.size();
  const std::string summary = avo_io::to_json(metrics.summary());
  std::printf("%zu rows, a summary of %zu bytes\n", rows, summary.size());
  return rows == 100 && refuses_bad_scenes() && refuses_missing_files() ? 0 : 1;
}
