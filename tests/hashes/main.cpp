// SPDX-License-Identifier: Apache-2.0
// avo_hashes [THREADS]: the state hash of each pinned run, one a line; THREADS 0, the default: all
// cores. AVO_SIMD chooses the instructions; exit status 2: this machine lacks them.
#include <cstdio>
#include <exception>
#include <string>

#include "avo/simd.h"
#include "hashes/pinned_runs.h"

namespace {

void print_hashes(int threads) {
  for (const avo_test::PinnedRun& run : avo_test::pinned_runs()) {
    const auto hash = static_cast<unsigned long long>(state_hash(run, threads));
    std::printf("%-28s 0x%016llx\n", run.name.c_str(), hash);
  }
}

}  // namespace

int main(int count, char** arguments) {
  int status = 2;
  try {
    avo::check_simd_target();
    status = 1;
    print_hashes(count > 1 ? std::stoi(arguments[1]) : 0);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "avo_hashes: %s\n", error.what());
    return status;
  }
}
