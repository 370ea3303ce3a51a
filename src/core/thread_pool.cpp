// SPDX-License-Identifier: Apache-2.0
#include "core/thread_pool.h"

#include <algorithm>
#include <exception>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__)
#include <unistd.h>
#endif
#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64)
#include <immintrin.h>
#endif

namespace avo::inline core {
namespace {

// The bits of the gate. Counters of openings may wrap around: a helper that slept through all of
// them sleeps on.
constexpr std::uint32_t kInside = (1U << 16U) - 1, kOpen = 1U << 16U, kOpening = 1U << 17U;
constexpr std::uint32_t kStop = 0xffffffff;

// Calls: after these help is tried again, which costs at most a time slice of a busy machine.
constexpr std::size_t kMostAlone = 255;
// A shorter wait does not count.
constexpr std::chrono::nanoseconds kTrifle{10'000};

using Clock = std::chrono::steady_clock;

void pause() {
#if defined(__x86_64__) || defined(__i386__) || defined(_M_X64)
  _mm_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

// Spins for as long as the patience lasts. A wait that paid makes it longer.
template <typename Done>
bool spin_until(const Done& done, Patience& patience) {
  constexpr std::chrono::nanoseconds kLeast{1'000};
  const Clock::time_point start = Clock::now();
  do {
    for (int k = 0; k < 16; ++k) {
      if (done()) {
        patience.time = std::min(2 * patience.time + kLeast, Patience::kMost);
        return true;
      }
      pause();
    }
  } while (Clock::now() - start < patience.time);
  patience.time /= 2;
  return false;
}

}  // namespace

std::size_t usable_processors() {
#if defined(__linux__)
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) == 0) {
    return static_cast<std::size_t>(std::max(CPU_COUNT(&set), 1));
  }
#endif
  return std::max(std::thread::hardware_concurrency(), 1U);
}

void ThreadPool::start() {
  started_ = true;
#if defined(__unix__)
  process_ = getpid();
#endif
  try {
    helpers_.reserve(workers_ - 1);
    while (helpers_.size() + 1 < workers_) {
      helpers_.emplace_back(&ThreadPool::help, this, helpers_.size() + 1);
    }
  } catch (const std::exception&) {
    return;  // the system or memory is exhausted: use the threads that exist
  }
}

ThreadPool::~ThreadPool() {
#if defined(__unix__)
  // In a child of a fork the threads stay behind, and their handles are leaked on purpose.
  if (started_ && process_ != getpid()) {
    // NOLINTNEXTLINE(bugprone-unhandled-exception-at-new): a child without memory ends here
    static_cast<void>(new std::vector<std::thread>(std::move(helpers_)));
    return;
  }
#endif
  gate_.store(kStop);  // sequentially consistent: a helper that is about to sleep sees it, too
  gate_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

// Returns the number of tasks.
std::size_t ThreadPool::take_tasks(std::size_t worker) {
  std::size_t taken = 0;
  for (std::size_t k = 0; k < workers_; ++k) {
    Share& share = shares_[(worker + k) % workers_];
    while (share.next.load(std::memory_order_relaxed) < share.end) {
      const std::size_t index = share.next.fetch_add(1, std::memory_order_relaxed);
      if (index >= share.end) break;
      task_(context_, index, worker);
      ++taken;
    }
  }
  return taken;
}

void ThreadPool::share_out(std::size_t count) {
  for (std::size_t worker = 0; worker < workers_; ++worker) {
    shares_[worker].next.store(count * worker / workers_, std::memory_order_relaxed);
    shares_[worker].end = count * (worker + 1) / workers_;
  }
}

void ThreadPool::help(std::size_t worker) {
  Patience patience;
  std::uint32_t last_opening = 0;
  for (;;) {
    std::uint32_t gate = gate_.load(std::memory_order_acquire);
    if (gate == kStop) return;
    if ((gate & kOpen) == 0 || gate / kOpening == last_opening) {
      const auto has_changed = [&] { return gate_.load(std::memory_order_relaxed) != gate; };
      if (!spin_until(has_changed, patience)) gate_.wait(gate, std::memory_order_relaxed);
      continue;
    }
    if (!gate_.compare_exchange_weak(gate, gate + 1, std::memory_order_acq_rel)) continue;
    last_opening = gate / kOpening;
    take_tasks(worker);
    const std::uint32_t before = gate_.fetch_sub(1, std::memory_order_acq_rel);
    if ((before & kOpen) == 0 && (before & kInside) == 1) {
      left_.fetch_add(1, std::memory_order_acq_rel);
      left_.notify_one();
    }
  }
}

void ThreadPool::await_helpers() {
  const auto all_left = [&] { return (gate_.load(std::memory_order_acquire) & kInside) == 0; };
  if (spin_until(all_left, patience_)) return;
  for (;;) {
    const std::uint32_t left = left_.load(std::memory_order_acquire);
    if (all_left()) return;
    left_.wait(left, std::memory_order_acquire);
  }
}

void ThreadPool::run(std::size_t count, Task task, void* context) {
  if (alone_ > 0) {
    --alone_;
    for (std::size_t i = 0; i < count; ++i) task(context, i, 0);
    return;
  }
  if (!started_) start();
  task_ = task, context_ = context;
  share_out(count);
  const std::uint32_t gate = gate_.load(std::memory_order_relaxed);
  gate_.store((gate / kOpening + 1) * kOpening | kOpen);
  gate_.notify_all();
  const Clock::time_point start = Clock::now();
  const std::size_t own = take_tasks(0);
  const Clock::time_point end = Clock::now();
  if ((gate_.fetch_and(~kOpen, std::memory_order_acq_rel) & kInside) == 0) return;
  await_helpers();
  const std::chrono::duration<double> worked = end - start, waited = Clock::now() - end - kTrifle;
  const bool paid = waited * static_cast<double>(own) <= worked * static_cast<double>(count - own);
  next_alone_ = paid ? next_alone_ / 2 : std::min(2 * next_alone_ + 1, kMostAlone);
  if (!paid) alone_ = next_alone_;
}

std::shared_ptr<Executor> make_executor(std::size_t workers) {
  if (workers == 0) workers = std::min(usable_processors(), kMostWorkers);
  if (workers == 1) return std::make_shared<SerialExecutor>();
  return std::make_shared<ThreadPool>(workers);
}

}  // namespace avo::inline core
