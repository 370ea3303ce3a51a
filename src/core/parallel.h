// SPDX-License-Identifier: Apache-2.0
// The one place that knows about threads.
#pragma once
#include <cstddef>
#ifdef _OPENMP
#include <omp.h>
#endif

namespace avo {

inline int default_threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

/// Below so many robots the threads cost more than they save, and on a busy machine far more.
inline constexpr std::size_t kFewestParallel = 256;

/// body(index, worker) for every index in [0, count), worker in [0, threads). The order and the
/// division among the workers are not promised: body must not depend on them.
template <typename Body>
void parallel_for(std::size_t count, std::size_t threads, const Body& body) {
#ifdef _OPENMP
  if (threads > 1 && count > 1) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(static_cast <int>(threads))
    for (std::size_t i = 0; i < count; ++i) body(i, static_cast<std::size_t>(omp_get_thread_num()));
    return;
  }
#endif
  static_cast<void>(threads);
  for (std::size_t i = 0; i < count; ++i) body(i, std::size_t{0});
}

}  // namespace avo
