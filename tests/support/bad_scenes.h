// SPDX-License-Identifier: Apache-2.0
// Bad scene files, and the messages about them from any reader.
#pragma once
#include <string>
#include <vector>

#include "fields/robot_fields.h"
#include "fields/scene_fields.h"

namespace avo_test {

/// Returns text that includes its NUL bytes.
template <std::size_t N>
std::string s(const char (&text)[N]) {
  return {text, N - 1};
}

inline const std::string kGood = "version: 1\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n";
/// The keys of a table of fields, as messages list them.
template <class Table>
std::string listed(const Table& table, bool has_places = true) {
  std::string keys;
  for (const auto& field : table) {
    if (!has_places && (field.key == "position" || field.key == "goal")) continue;
    keys.append(keys.empty() ? "" : ", ").append(field.key);
  }
  return keys;
}
inline const std::string kSceneKeys = listed(avo::kFields<avo::Scenario>);
inline const std::string kRobotKeys = listed(avo::kFields<avo::RobotSetup>);
inline const std::string kGroupRobotKeys = listed(avo::kFields<avo::RobotSetup>, false);

struct BadScene {
  const char* name;
  std::string yaml;
  std::string message;  ///< behind the name of the file
};

/// Returns scenes with values that scenes cannot have.
const std::vector<BadScene>& bad_scenes();
/// Returns texts that are no plain YAML, no text, or too deep.
const std::vector<BadScene>& bad_texts();

}  // namespace avo_test
