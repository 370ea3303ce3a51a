// SPDX-License-Identifier: Apache-2.0
// A hash of texts, to distinguish sweeps and to detect torn lines: FNV-1a with 64 bits (Fowler,
// Noll, Vo).
#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace avo_io {

class TextHash {
 public:
  void add(std::string_view text) {
    for (const char c : text) mix(static_cast<unsigned char>(c));
    mix(0x100);  // not a byte, so that "a", "b" differs from "ab"
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }
  /// Returns 16 digits.
  [[nodiscard]] std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  void mix(std::uint64_t part) { value_ = (value_ ^ part) * 0x100000001b3; }
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace avo_io
