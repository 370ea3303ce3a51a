// SPDX-License-Identifier: Apache-2.0
// The bytes of a file of any length, one part after the other.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace avo_io {

class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Reads the next bytes, at most as many as there is room for. Returns their number, which is 0
  /// at the end. Throws FileError.
  virtual std::size_t read(std::span<char> bytes) = 0;
};

/// Opens a file; "-" is the standard input. Throws FileError. The lab's module has a definition of
/// its own, which asks the host.
std::unique_ptr<ByteSource> open_bytes(const std::string& path);

}  // namespace avo_io
