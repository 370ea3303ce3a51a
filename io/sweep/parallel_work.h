// SPDX-License-Identifier: Apache-2.0
// Parts of work that have nothing to do with each other, on several threads.
#pragma once
#include <cstddef>
#include <functional>

namespace avo_io {

/// As many as the machine has processors for 0, else itself.
int jobs_for(int jobs);

/// Calls work(0), work(1), ... up to `count`, each begun in this order, `jobs` at a time on threads
/// of their own. Ten times a second, and at the end, it calls tick() on the calling thread. No
/// further part begins once stops() is true (asked from any thread; empty: never), or one has
/// thrown: then it throws what the first of them in this order threw, when all that were begun have
/// ended.
void work_through(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                  const std::function<bool()>& stops, const std::function<void()>& tick);

}  // namespace avo_io
