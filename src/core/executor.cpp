// SPDX-License-Identifier: Apache-2.0
// Checks whether a host's executor has done its tasks.
#include "core/executor.h"

#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"

namespace avo {

Executor::~Executor() = default;

}  // namespace avo

namespace avo::inline core {
namespace {

// The thread that sets the bit of a task begins the task. Between two runs all bits are set, so
// that a host that comes back too late finds nothing to do.
class CountedExecutor final : public Executor {
 public:
  explicit CountedExecutor(std::shared_ptr<Executor> host)
      : host_(std::move(host)), workers_(host_->workers()), is_busy_(workers_) {}

  [[nodiscard]] std::size_t workers() const override { return workers_; }
  void run(std::size_t count, Task task, void* context) override {
    open(count, task, context);
    try {
      host_->run(count, do_task, this);
    } catch (...) {
      close();
      throw;
    }
    const std::size_t done = close();
    if (done == count && !is_wrong_) return;
    throw Error(
        "executor: found " + std::to_string(done) + " of " + std::to_string(count) +
        " tasks done when run() returned" +
        (is_wrong_ ? ", and one called again, or with a wrong index or a busy worker" : "") +
        ", must do each once, with an idle worker less than " + std::to_string(workers_));
  }

 private:
  static constexpr std::size_t kBits = 64;

  void open(std::size_t count, Task task, void* context) {
    count_ = count, task_ = task, context_ = context;
    done_.store(0, std::memory_order_relaxed);
    is_wrong_.store(false, std::memory_order_relaxed);
    const std::size_t words = (count + kBits - 1) / kBits;
    if (begun_.size() < words) begun_ = std::vector<std::atomic<std::uint64_t>>(words);
    for (std::size_t k = 0; k < words; ++k) begun_[k].store(0, std::memory_order_release);
  }

  // Returns the number of begun tasks, once they are done.
  std::size_t close() {
    std::size_t begun = 0;
    for (std::size_t first = 0; first < count_; first += kBits) {
      const std::uint64_t all = ~std::uint64_t{0};
      begun += static_cast<std::size_t>(std::popcount(begun_[first / kBits].exchange(all)));
    }
    while (done_.load(std::memory_order_acquire) < begun) continue;  // for a host that did not wait
    return begun;
  }

  static void do_task(void* pointer, std::size_t index, std::size_t worker) {
    CountedExecutor& own = *static_cast<CountedExecutor*>(pointer);
    if (index < own.count_ && worker < own.workers_ && own.do_once(index, worker)) return;
    own.is_wrong_.store(true, std::memory_order_relaxed);
  }

  // Returns whether it has run the task: only one thread at a time may write a worker's data.
  bool do_once(std::size_t index, std::size_t worker) {
    if (is_busy_[worker].exchange(true, std::memory_order_acquire)) return false;
    const bool is_first = begins(index);
    if (is_first) task_(context_, index, worker);
    is_busy_[worker].store(false, std::memory_order_release);
    if (is_first) done_.fetch_add(1, std::memory_order_release);
    return is_first;
  }

  bool begins(std::size_t index) {
    const std::uint64_t bit = std::uint64_t{1} << index % kBits;
    return (begun_[index / kBits].fetch_or(bit, std::memory_order_acq_rel) & bit) == 0;
  }

  std::shared_ptr<Executor> host_;
  std::size_t workers_;
  std::vector<std::atomic<bool>> is_busy_;  // by worker
  Task task_ = nullptr;
  void* context_ = nullptr;
  std::size_t count_ = 0;
  std::vector<std::atomic<std::uint64_t>> begun_;  // by bit; allocates only while it grows
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> is_wrong_ = false;
};

}  // namespace

std::shared_ptr<Executor> counted(std::shared_ptr<Executor> host) {
  return std::make_shared<CountedExecutor>(std::move(host));
}

}  // namespace avo::inline core
