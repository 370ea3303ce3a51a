// SPDX-License-Identifier: Apache-2.0
// Messages of Protocol Buffers as bytes (https://protobuf.dev/programming-guides/encoding/).
#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace avo_io {

/// Fields in sequence. As in proto3, numbers that are 0 are left out.
class ProtoBytes {
 public:
  void whole(int field, std::uint64_t value) {
    if (value == 0) return;
    key(field, 0);
    varint(value);
  }
  void number(int field, double value) {
    std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    if (bits == 0) return;
    key(field, 1);
    for (int k = 0; k < 8; ++k, bits >>= 8U) bytes_ += static_cast<char>(bits & 0xffU);
  }
  /// Adds text, or a message.
  void text(int field, std::string_view value) {
    key(field, 2);
    varint(value.size());
    bytes_ += value;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void key(int field, unsigned type) { varint(static_cast<unsigned>(field) << 3U | type); }
  void varint(std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) bytes_ += static_cast<char>((value & 0x7fU) | 0x80U);
    bytes_ += static_cast<char>(value);
  }

  std::string bytes_;
};

}  // namespace avo_io
