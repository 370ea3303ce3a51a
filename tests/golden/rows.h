// SPDX-License-Identifier: Apache-2.0
// What the slow references have written.
#pragma once
#include <fstream>
#include <string>

#include "avo/vec.h"
#include "support/json.h"

namespace avo {

using json = nlohmann::ordered_json;

inline json cases(const std::string& name) {
  std::ifstream file(std::string(AVO_TEST_DATA) + "/" + name);
  return json::parse(file).at("cases");
}

inline Vec2 vec(const json& row) {
  return {row.at(0).get<double>(), row.at(1).get<double>()};
}

}  // namespace avo
