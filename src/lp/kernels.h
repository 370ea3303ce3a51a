// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the program's kernels.
#pragma once
#include "lp/program_kernel.h"

namespace avo {

struct ProgramKernels {
  void (*solve)(Programs&, ProgramRow<kProgramLanes>*, bool);
};

}  // namespace avo
