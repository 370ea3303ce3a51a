// SPDX-License-Identifier: Apache-2.0
// Recordings by `avo run`, for tests to read, to damage and to replay.
#pragma once
#include <gtest/gtest.h>
#include <string>

#include "recordings.h"

namespace avo_test {

/// The file, of a run with these words.
inline std::string recorded(const Strings& words, const std::string& name = "run.h5") {
  const std::string h5 = path_of(name);
  Strings command{"run", "--record", h5, "-q"};
  command.insert(command.end(), words.begin(), words.end());
  EXPECT_EQ(run_avo(command).exit_code, 0);
  return h5;
}

/// The recording is of six robots on a circle, for 9 s.
inline std::string recorded_circle(const Strings& more = {}, const std::string& name = "run.h5") {
  Strings words{"circle-6", "--duration", "9"};
  words.insert(words.end(), more.begin(), more.end());
  return recorded(words, name);
}

}  // namespace avo_test
