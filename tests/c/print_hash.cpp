// SPDX-License-Identifier: Apache-2.0
// Prints the state hash of the whole Circle-100 in C++.
#include <cinttypes>
#include <cstdio>

#include "cpp_runs.h"

int main() {
  std::printf("0x%016" PRIx64, cpp_scene_hash("circle-100", nullptr, 0));
  return 0;
}
