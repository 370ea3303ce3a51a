// SPDX-License-Identifier: Apache-2.0
// Does independent parts of work on several threads.
#pragma once
#include <cstddef>
#include <functional>

namespace avo_io {

/// Returns the number of processors for 0, else `jobs`.
int jobs_for(int jobs);

/// Calls work(0), work(1), ... up to `count`, begun in this order, `jobs` at a time on separate
/// threads. Ten times a second, and at the end, it calls tick() on the calling thread. No further
/// part begins once stops() is true (called from any thread; empty: never), or a part has thrown.
/// In the latter case it waits until all begun parts have ended. It then throws the exception of
/// the first of them in this order.
void work_through(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stops, const std::function<void()>& tick);

}  // namespace avo_io
