// SPDX-License-Identifier: Apache-2.0
// The seam between the simulation and threads, behind which a host's own job system, or none, can
// take the place of ThreadPool.
#pragma once
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>

#include "avo/executor.h"

namespace avo::inline core {

/// One after the other, on the thread that asks for it.
class SerialExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const override { return 1; }
  void run(std::size_t count, Task task, void* context) override {
    for (std::size_t i = 0; i < count; ++i) task(context, i, 0);
  }
};

inline constexpr std::size_t kMostWorkers = 1024;
/// The library's own: so many workers, at most kMostWorkers, or for 0 one a processor. Where it is
/// built without threads there is one.
std::shared_ptr<Executor> make_executor(std::size_t workers);

/// The host's executor, which is not trusted: run() throws Error unless each task was called once,
/// by one of the workers that the host had at first. A task that is called again does nothing.
std::shared_ptr<Executor> counted(std::shared_ptr<Executor> host);

/// Below so many robots threads cost more than they save, and on a busy machine far more.
inline constexpr std::size_t kFewestParallel = 256;

/// body(index, worker) for every index in [0, count), see Executor::run(); a single one is done by
/// the caller. What body does must not depend on the order or on the worker. Throws what a body
/// threw, the first one of them; some others have not been called then.
template <typename Body>
void parallel_for(Executor& executor, std::size_t count, const Body& body) {
  if (count <= 1) {
    for (std::size_t i = 0; i < count; ++i) body(i, std::size_t{0});
    return;
  }
  struct Context {
    const Body& body;
    std::atomic<bool> failed = false;
    std::exception_ptr reason = nullptr;  // written by whoever sets failed
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
