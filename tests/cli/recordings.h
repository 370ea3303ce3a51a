// SPDX-License-Identifier: Apache-2.0
// Recordings by hand for avo check.
#pragma once
#include <string>

#include "run_avo.h"

namespace avo_test {

using Strings = std::vector<std::string>;

const Strings kLimits{"--radius", "0.5", "--max-acceleration", "1", "--max-speed", "2"};
const std::string kHeader = "time,robot,x,y,vx,vy\n";

// Robot 0 speeds up at 1 m/s^2 towards robot 7, which stands 3 m ahead.
const std::string kGoodRun = kHeader +
                             "0,0,0,0,0,0\n0,7,3,0,0,0\n"
                             "0.5,0,0.125,0,0.5,0\n0.5,7,3,0,0,0\n"
                             "1.5,0,1.125,0,1.5,0\n1.5,7,3,0,0,0\n";

inline std::string recording(const std::string& text, const std::string& name = "in.csv") {
  write_file(path_of(name), text);
  return path_of(name);
}

inline ProcessResult check(const std::string& text, Strings more = kLimits) {
  more.insert(more.begin(), {"check", recording(text)});
  return run_avo(more);
}

}  // namespace avo_test
