// SPDX-License-Identifier: Apache-2.0
// The one place that knows about threads.
#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "core/executor.h"

namespace avo::inline core {

/// Processors that this process may use: those of its affinity mask, where the system has one.
std::size_t usable_processors();

/// How long to look again and again before one falls asleep. Another processor answers within
/// microseconds, sooner than a thread falls asleep and wakes up; where others want the processor,
/// looking does not pay, and soon costs next to nothing.
struct Patience {
  static constexpr std::chrono::nanoseconds kMost{40'000};
  std::chrono::nanoseconds time = kMost;
};

/// Threads that help the one that calls run(). Nobody waits for a helper that has not begun, and a
/// wait that lasts gives the processor away. Where the machine is busy with other work a helper may
/// lose its processor in the midst of a task: where waiting for it took longer than its tasks would
/// have, the caller goes on without help, for ever more calls the more often that happens.
///
/// Each worker begins with a share of the tasks, the same one in each call with as many tasks. So
/// what a task reads and writes stays in the cache of one processor from step to step. A worker
/// that has finished its share takes tasks of the next workers' shares.
///
/// The gate tells the helpers of work, in one number: how many are inside, whether it is open, and
/// how many times it has been opened. A helper enters an open gate once; the caller closes it when
/// no task is left, and waits for those inside.
class ThreadPool final : public Executor {
 public:
  /// The caller counts as one worker; 1 to kMostWorkers. Threads start with the first run(). One
  /// that the system refuses to start costs time, nothing else.
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
  long process_ = 0;            // that started the threads; a child of a fork goes on without
  Patience patience_;           // of the caller
  std::size_t alone_ = 0;       // calls for which it goes on without help
  std::size_t next_alone_ = 0;  // as many after the next wait that does not pay
  std::vector<std::thread> helpers_;

  // Tasks in [next, end) are still to be taken; next may pass the end.
  struct alignas(64) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  // set while the gate is closed and nobody inside
  Task task_ = nullptr;
  void* context_ = nullptr;
  std::vector<Share> shares_;  // by worker

  alignas(64) std::atomic<std::uint32_t> gate_ = 0;
  alignas(64) std::atomic<std::uint32_t> left_ = 0;  // changes when the last one leaves
};

}  // namespace avo::inline core
