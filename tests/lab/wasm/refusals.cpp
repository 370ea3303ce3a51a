// SPDX-License-Identifier: Apache-2.0
// The bad scenes of the tests: refusals FOLDER writes FOLDER/NAME.yaml, and FOLDER/NAME.txt with
// what is said of it behind the name of the file.
#include <fstream>
#include <string>
#include <vector>

#include "support/bad_scenes.h"

int main(int count, char** words) {
  if (count != 2) return 2;
  const auto write = [&](const avo_test::BadScene& scene, const char* ending,
                         const std::string& text) {
    std::ofstream file(std::string(words[1]) + "/" + scene.name + ending, std::ios::binary);
    file << text;
    return static_cast<bool>(file.flush());
  };
  for (const auto* scenes : {&avo_test::bad_scenes(), &avo_test::bad_texts()})
    for (const avo_test::BadScene& scene : *scenes)
      if (!write(scene, ".yaml", scene.yaml) || !write(scene, ".txt", scene.message)) return 1;
  return 0;
}
