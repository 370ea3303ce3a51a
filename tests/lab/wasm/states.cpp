// SPDX-License-Identifier: Apache-2.0
// Saves the first state of scenes, and prints where the native library comes to from there:
//   states FOLDER STEPS SCENE...
// A line a scene: its name, the time, and the hash of the last state. FOLDER/SCENE is the state.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/scene.h"

int main(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (arguments.size() < 3) return 2;
  std::vector<std::string> scenes(arguments.begin() + 2, arguments.end());
  if (scenes.front() == "all") {
    scenes.clear();
    for (const avo_io::BuiltinScene& scene : avo_io::builtin_scenes())
      scenes.push_back(scene.name.ends_with("-N")
                           ? scene.name.substr(0, scene.name.size() - 1) + "100"
                           : scene.name);
  }
  for (const std::string& name : scenes) {
    avo::Simulation simulation(avo_io::load_scenario(name), 1);
    const std::vector<std::byte> saved = simulation.save();
    std::ofstream file(arguments[0] + "/" + name, std::ios::binary);
    file.write(reinterpret_cast<const char*>(saved.data()),
               static_cast<std::streamsize>(saved.size()));
    if (!file.flush()) return 1;
    const double duration = avo_io::load_scenario(name).duration;
    for (int k = std::atoi(arguments[1].c_str()); k > 0 && simulation.can_step_by(duration); --k)
      simulation.step();
    std::cout << name << ' ' << simulation.time() << ' ' << simulation.state_hash() << '\n';
  }
}
