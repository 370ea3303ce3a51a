// SPDX-License-Identifier: Apache-2.0
// The only place that uses threads.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/executor.h"

namespace avo::inline core {

/// The number of processors that this process may use: those of its affinity mask, where the system
/// has one.
std::size_t usable_processors();

/// How long a thread spins before it sleeps. Another processor answers within microseconds, sooner
/// than a thread falls asleep and wakes up. Where others want the processor, spinning does not pay,
/// and soon costs almost nothing.
struct Patience {
  static constexpr std::chrono::nanoseconds kMost{40'000};
  std::chrono::nanoseconds time = kMost;
};

/// Threads that help the thread that calls run(). The caller never waits for a helper that has not
/// begun, and a long wait yields the processor. On a busy machine a helper may lose its processor
/// during a task. Where waiting for it took longer than its tasks would have, the caller continues
/// without help. The more often that happens, the more calls it makes without help.
///
/// Each worker begins with a share of the tasks, the same one in each call with as many tasks. So
/// the data of a task stay in the cache of one processor from step to step. A worker that has
/// finished its share takes tasks of the next workers' shares.
///
/// The gate tells the helpers about work, in one number. This number has how many helpers are
/// inside, whether the gate is open, and how many times it has been opened. A helper enters an open
/// gate once. The caller closes it when no task is left, and waits for the helpers inside.
class ThreadPool final : public Executor {
 public:
  /// The caller counts as one worker; 1 to kMostWorkers. Threads start with the first run(). If the
  /// system refuses to start one, that only costs time.
  explicit ThreadPool(std::size_t workers) : workers_(workers), shares_(workers) {}
  ~ThreadPool() override;

  [[nodiscard]] std::size_t workers() const override { return workers_; }
  void run(std::size_t count, Task task, void* context) override;

 private:
  void start();
  void help(std::size_t worker);
  void share_out(std::size_t count);
  std::size_t take_tasks(std::size_t worker);
  void await_helpers();

  std::size_t workers_;
  bool started_ = false;
  // the process that started the threads; a child of a fork continues without them
  long process_ = 0;
  Patience patience_;           // of the caller
  std::size_t alone_ = 0;       // calls for which it continues without help
  std::size_t next_alone_ = 0;  // the same number after the next wait that does not pay
  std::vector<std::thread> helpers_;

  // Tasks in [next, end) are still to be taken; next may pass the end.
  struct alignas(64) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  // set while the gate is closed and no helper is inside
  Task task_ = nullptr;
  void* context_ = nullptr;
  std::vector<Share> shares_;  // by worker

  alignas(64) std::atomic<std::uint32_t> gate_ = 0;
  alignas(64) std::atomic<std::uint32_t> left_ = 0;  // changes when the last helper leaves
};

}  // namespace avo::inline core
