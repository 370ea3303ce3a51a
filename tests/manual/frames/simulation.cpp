// SPDX-License-Identifier: Apache-2.0
#include <avo/avo.h>

[[maybe_unused]] static void part(avo::Simulation& simulation, [[maybe_unused]] int threads) {
  // the block
}

int main() {}
