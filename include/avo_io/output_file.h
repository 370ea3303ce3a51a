// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there at all.
#pragma once
#include <string>
#include <string_view>

#include "avo_io/errors.h"

namespace avo_io {

/// Where something is written before it gets its name: beside it, with the same extension.
/// Opening fails early (FileError) if the place cannot be written; the temporary file goes away
/// unless commit() is called. Devices and pipes are written directly.
class OutputFile {
 public:
  /// "-" is the standard output.
  explicit OutputFile(std::string path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Buffered. Throws FileError, e.g. where the disk is full.
  void write(std::string_view bytes);
  /// Puts all bytes on the disk, under the temporary name. Throws FileError.
  void settle();
  /// The same, and gives the file its name. Throws FileError.
  void commit();

  /// The name to write to for those who open files by name; commit() afterwards.
  [[nodiscard]] const std::string& temporary_path() const { return temporary_; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  void flush();
  [[noreturn]] void fail() const;

  std::string path_, final_, temporary_;
  std::string buffer_;
  int descriptor_ = -1;
  bool renames_ = false;
};

}  // namespace avo_io
