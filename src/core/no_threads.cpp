// SPDX-License-Identifier: Apache-2.0
// Replaces thread_pool.cpp where there are no threads (AVO_THREADS=OFF).
#include "core/executor.h"

namespace avo::inline core {

std::shared_ptr<Executor> make_executor(std::size_t) {
  return std::make_shared<SerialExecutor>();
}

}  // namespace avo::inline core
