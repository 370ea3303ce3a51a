// SPDX-License-Identifier: Apache-2.0
// A mutex, where there are threads.
#pragma once
#ifndef AVO_NO_THREADS
#include <mutex>
#endif

namespace avo::inline core {

#ifdef AVO_NO_THREADS
struct Mutex {};
struct Lock {
  explicit Lock(Mutex&) {}
};
#else
using Mutex = std::mutex;
using Lock = std::lock_guard<std::mutex>;
#endif

}  // namespace avo::inline core
