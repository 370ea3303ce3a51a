// SPDX-License-Identifier: Apache-2.0
// What avo check says of recordings by hand, and of those of avo run.
#pragma once
#include <gtest/gtest.h>
#include <string>

#include "recordings.h"
#include "support/json.h"

namespace avo_test {

using Json = nlohmann::ordered_json;

inline Json verdict(const std::string& text, Strings more = kLimits) {
  more.push_back("--json");
  const ProcessResult result = check(text, more);
  EXPECT_LE(result.exit_code, 1) << result.err;
  return Json::parse(result.out);
}

/// What `avo run` records, and its summary.
struct Recorded {
  std::string csv = path_of("run.csv");
  Json summary;
};

inline Recorded record(Strings arguments) {
  Recorded result;
  arguments.insert(arguments.begin(), "run");
  arguments.insert(arguments.end(), {"--record", result.csv, "--summary", path_of("run.json")});
  EXPECT_EQ(run_avo(arguments).exit_code, 0);
  result.summary = Json::parse(read_file(path_of("run.json")));
  return result;
}

}  // namespace avo_test
