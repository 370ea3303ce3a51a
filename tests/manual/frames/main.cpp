// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <vector>

#include <avo/avo.h>

#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"

int main() {
  // the block
}
