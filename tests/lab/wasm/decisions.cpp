// SPDX-License-Identifier: Apache-2.0
// Decisions as `avo explain --json` says them, many at a time: decisions < LIST, where a line of
// LIST is a scene, the robot, the steps before, and overrides; of one scene and its overrides by
// ascending steps. A text ends with a line of its own, "--". Of a scene that is refused, or a robot
// that decides nothing, the text is what was said.
#include <cstdint>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo_io/decision.h"
#include "avo_io/scene.h"

namespace {

struct Asked {
  std::string scene;
  std::uint64_t robot = 0;
  int steps = 0;
  std::vector<std::string> overrides;
};

Asked asked_in(const std::string& line) {
  std::istringstream words(line);
  Asked asked;
  words >> asked.scene >> asked.robot >> asked.steps;
  for (std::string word; words >> word;) asked.overrides.push_back(word);
  return asked;
}

}  // namespace

int main() {
  std::string made;
  std::unique_ptr<avo::Simulation> simulation;
  avo::Scenario scenario;
  for (std::string line; std::getline(std::cin, line);) {
    const Asked asked = asked_in(line);
    try {
      std::string key = asked.scene;
      for (const std::string& override : asked.overrides) key += " " + override;
      if (key != made) {
        scenario = avo_io::load_scenario(asked.scene, asked.overrides);
        simulation = std::make_unique<avo::Simulation>(scenario, 1);
        made = key;
      }
      while (simulation->steps() < asked.steps) simulation->step();
      if (!simulation->index_of({asked.robot})) throw avo::Error("it is not there");
      avo_io::require_explainable(scenario, static_cast<std::int64_t>(asked.robot),
                                  simulation->time());
      std::cout << to_json(avo_io::explain(*simulation, scenario.name, {asked.robot}));
    } catch (const avo::Error& error) {
      std::cout << error.what() << "\n";
    }
    std::cout << "--\n";
  }
}
