// SPDX-License-Identifier: Apache-2.0
// Who does the parts of a step at the same time. A host's own job system can take the place of the
// library's threads: see Simulation.
#pragma once
#include <cstddef>

#include "avo/export.h"

namespace avo {

/// Threads of a host, or the library's own.
class AVO_API Executor {
 public:
  /// Throws nothing.
  using Task = void (*)(void* context, std::size_t index, std::size_t worker);

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor();

  /// Tasks that run at the same time, at most; 1 to 1024, and always as many. With one worker run()
  /// is called as well, so that a host decides which thread that is.
  [[nodiscard]] virtual std::size_t workers() const = 0;
  /// task(context, index, worker) once for every index in [0, count), in any order; worker is in
  /// [0, workers()), and no two tasks at the same time have the same. Returns when all are done.
  /// count is at least 2: a single task is done by the thread that steps.
  /// The library counts the tasks: where one was left out or called again, or had a wrong worker,
  /// the step throws Error. That, and what run() throws, ends the step. Where robots have moved by
  /// then, every later step throws Error until a state is restored.
  virtual void run(std::size_t count, Task task, void* context) = 0;
};

}  // namespace avo
