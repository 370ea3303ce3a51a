// SPDX-License-Identifier: Apache-2.0
// The interface between the simulation and threads: a host's own job system, or none, can take the
// place of ThreadPool.
#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>

#include "avo/executor.h"

namespace avo::inline core {

/// Runs tasks one after the other, on the calling thread.
class SerialExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const override { return 1; }
  void run(std::size_t count, Task task, void* context) override {
    for (std::size_t i = 0; i < count; ++i) task(context, i, 0);
  }
};

inline constexpr std::size_t kMostWorkers = 1024;
/// The library's own executor: so many workers, at most kMostWorkers, or for 0 one for each
/// processor. Without threads it has one worker.
std::shared_ptr<Executor> make_executor(std::size_t workers);

/// Wraps the host's executor, which is not trusted. run() throws Error unless each task was called
/// once, by a worker that the host had at first. A task does nothing in its second call.
std::shared_ptr<Executor> counted(std::shared_ptr<Executor> host);

/// With fewer robots threads cost more than they save, and on a busy machine far more.
inline constexpr std::size_t kFewestParallel = 256;

/// Calls body(index, worker) for every index in [0, count), see Executor::run(); the caller runs a
/// single one itself. The effect of body must not depend on the order or on the worker. Throws the
/// first exception of a body; some other bodies have not been called then.
template <typename Body>
void parallel_for(Executor& executor, std::size_t count, const Body& body) {
  if (count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i, std::size_t{0});
    return;
  }
  struct Context {
    const Body& body;
    std::atomic<bool> failed = false;
    std::exception_ptr reason = nullptr;  // written by the thread that sets failed
  } context{body};
  executor.run(
      count,
      [](void* pointer, std::size_t index, std::size_t worker) {
        Context& shared = *static_cast<Context*>(pointer);
        if (shared.failed.load(std::memory_order_relaxed)) return;
        try {
          shared.body(index, worker);
        } catch (...) {
          if (!shared.failed.exchange(true)) shared.reason = std::current_exception();
        }
      },
      &context);
  if (context.failed) std::rethrow_exception(context.reason);
}

}  // namespace avo::inline core
