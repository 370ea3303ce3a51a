// SPDX-License-Identifier: Apache-2.0
// Every operator new of the program is counted, and may be made to fail.
#pragma once
#include <atomic>

namespace avo::test {

extern std::atomic<long> allocations;
extern std::atomic<long> bytes;  ///< held now
/// Allocations that succeed before memory is out; never, where it is negative.
extern std::atomic<long> left;

}  // namespace avo::test
