// SPDX-License-Identifier: Apache-2.0
// What `avo validate` says of a bad scene file.
#pragma once
#include <gtest/gtest.h>
#include <ostream>

#include "run_avo.h"
#include "support/bad_scenes.h"

namespace avo_test {

inline void PrintTo(const BadScene& scene, std::ostream* out) {
  *out << scene.name;
}

/// By `avo validate`, with one line and nothing else.
inline void expect_refused(const BadScene& scene) {
  const std::string path = path_of("bad.yaml");
  write_file(path, scene.yaml);
  const ProcessResult result = run_avo({"validate", path});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path + ":" + scene.message + "\n");
  EXPECT_EQ(result.out, "");
}

}  // namespace avo_test
