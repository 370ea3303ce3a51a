// SPDX-License-Identifier: Apache-2.0
// The interface that runs the parts of a step at the same time. A host's own job system can take
// the place of the library's threads: see Simulation.
#pragma once
#include <cstddef>

#include "avo/export.h"

namespace avo {

/// Threads of a host, or the library's own.
class AVO_API Executor {
 public:
  /// A task must not throw.
  using Task = void (*)(void* context, std::size_t index, std::size_t worker);

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor();

  /// The largest number of tasks that run at the same time, 1 to 1024; it never changes. With one
  /// worker run() is called as well, so that the host decides which thread runs the task.
  [[nodiscard]] virtual std::size_t workers() const = 0;
  /// Calls task(context, index, worker) once for every index in [0, count), in any order. worker is
  /// in [0, workers()). No two tasks at the same time have the same worker. Returns when all tasks
  /// are done. count is at least 2: the thread that steps does a single task itself. The library
  /// counts the tasks. The step throws Error where a task was left out or called again, or had a
  /// wrong worker. This error, and any exception of run(), ends the step. Where robots have moved
  /// by then, every later step throws Error until a state is restored.
  virtual void run(std::size_t count, Task task, void* context) = 0;
};

}  // namespace avo
