// SPDX-License-Identifier: Apache-2.0
// Random numbers that are the same on every machine and with every standard library.
#pragma once
#include <cstdint>

namespace avo_io {

/// SplitMix64 (Steele, Lea, Flood 2014): a counter and a mixing function, with period 2^64.
class Random {
 public:
  /// Different streams of one seed are independent enough for all purposes of scenes.
  Random(std::uint64_t seed, std::uint64_t stream) : state_(mixed(seed) + mixed(~stream)) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    return mixed(state_);
  }
  /// Returns a number uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
  /// Returns a number uniform in [min, max).
  double between(double min, double max) { return min + (max - min) * unit(); }
  /// Returns a number uniform in 0 ... count - 1, count > 0; biased by less than count / 2^53.
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(unit() * static_cast<double>(count));
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }
  std::uint64_t state_;
};

}  // namespace avo_io
