// SPDX-License-Identifier: Apache-2.0
#include "core/executor.h"

namespace avo {

Executor::~Executor() = default;

}  // namespace avo
