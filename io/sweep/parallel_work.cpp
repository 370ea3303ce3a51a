// SPDX-License-Identifier: Apache-2.0
// Does independent parts of work on several threads.
#include "io/sweep/parallel_work.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace avo_io {
namespace {

struct WorkQueue {
  std::size_t count;
  const std::function<void(std::size_t)>& work;
  const std::function<bool()>& stops;
  std::mutex guard = {};  // protects all members below
  std::condition_variable has_ended = {};
  std::size_t next = 0;
  int workers = 0;  // number of workers that have not ended
  std::size_t failed = 0;
  std::exception_ptr failure = nullptr;  // of part `failed`, the first part that threw

  void run() {
    for (std::unique_lock lock(guard); next < count && !failure && !(stops && stops());) {
      const std::size_t part = next++;
      lock.unlock();
      std::exception_ptr thrown;
      try {
        work(part);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      if (!thrown || (failure && failed < part)) continue;
      failure = thrown;
      failed = part;
    }
    const std::lock_guard lock(guard);
    --workers;
    has_ended.notify_one();
  }
};

}  // namespace

int jobs_for(int jobs) {
  return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void work_through(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stops, const std::function<void()>& tick) {
  WorkQueue queue{.count = count, .work = work, .stops = stops};
  std::vector<std::jthread> threads;
  const std::size_t most = std::min(count, static_cast<std::size_t>(jobs));
  threads.reserve(most);
  try {
    for (std::size_t k = 0; k < most; ++k) {
      {
        const std::lock_guard lock(queue.guard);
        ++queue.workers;
      }
      threads.emplace_back([&queue] { queue.run(); });
    }
  } catch (const std::system_error&) {  // from the thread that did not start
    const std::lock_guard lock(queue.guard);
    --queue.workers;
    if (threads.empty()) throw;
  }
  for (std::unique_lock lock(queue.guard); queue.workers > 0;) {
    queue.has_ended.wait_for(lock, std::chrono::milliseconds(100));
    lock.unlock();
    tick();
    lock.lock();
  }
  threads.clear();
  if (queue.failure) std::rethrow_exception(queue.failure);
  tick();
}

}  // namespace avo_io
