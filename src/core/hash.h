// SPDX-License-Identifier: Apache-2.0
// A 64-bit hash of a sequence of words, in their order.
#pragma once
#include <bit>
#include <cstdint>

namespace avo::inline core {

/// The hash with one more word: finalizer of a 64-bit mixing generator, in which every input bit
/// reaches every output bit. It is one-to-one in either argument. So sequences of one length that
/// differ in one word never have the same hash.
constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash += word + 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
  return hash ^ (hash >> 31);
}

/// The word of a number; numbers that compare equal may differ (zeros do).
inline std::uint64_t word_of(double number) {
  return std::bit_cast<std::uint64_t>(number);
}

}  // namespace avo::inline core
