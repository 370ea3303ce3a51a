// SPDX-License-Identifier: Apache-2.0
// Who does the parts of a step at the same time: the seam between the simulation and threads. A
// host's own job system can take the place of ThreadPool behind it.
#pragma once
#include <atomic>
#include <cstddef>
#include <exception>

namespace avo {

class Executor {
 public:
  /// Throws nothing.
  using Task = void (*)(void* context, std::size_t index, std::size_t worker);

  Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;
  virtual ~Executor() = default;

  /// Tasks that run at the same time, at most; >= 1.
  [[nodiscard]] virtual std::size_t workers() const = 0;
  /// task(context, index, worker) once for every index in [0, count), in any order; worker is in
  /// [0, workers()), and no two tasks at the same time have the same. Returns when all are done.
  virtual void run(std::size_t count, Task task, void* context) = 0;
};

/// One after the other, on the thread that asks for it.
class SerialExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const override { return 1; }
  void run(std::size_t count, Task task, void* context) override {
    for (std::size_t i = 0; i < count; ++i) task(context, i, 0);
  }
};

/// Below so many robots threads cost more than they save, and on a busy machine far more.
inline constexpr std::size_t kFewestParallel = 256;

/// body(index, worker) for every index in [0, count), see Executor::run(): what body does must not
/// depend on the order or on the worker. Throws what a body threw, the first one of them; some
/// others have not been called then.
template <typename Body>
void parallel_for(Executor& executor, std::size_t count, const Body& body) {
  if (count <= 1 || executor.workers() <= 1) {
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

}  // namespace avo
