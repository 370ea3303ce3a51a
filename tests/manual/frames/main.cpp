// SPDX-License-Identifier: Apache-2.0
#include <avo/avo.h>

#include <cstdio>
#include <vector>

#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"

int main() {
  // the block
}
