// SPDX-License-Identifier: Apache-2.0
// Files that are whole or absent.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "avo/export.h"
#include "avo_io/errors.h"

namespace avo_io {

/// A file that is written under a temporary name beside its target. It has the target's permissions
/// if the target exists. commit() gives the file its name. Without commit() it is removed. Links
/// are followed. Devices, pipes and the standard output are written directly.
class AVO_API OutputFile {
 public:
  /// "-" is the standard output. Throws FileError if the place cannot be written.
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Writes to a buffer. Throws FileError, e.g. where the disk is full.
  void write(std::string_view bytes);
  /// Does what commit_all() does with this file alone.
  void commit();
  /// The name of its bytes before commit(), for callers that write them without write(). It is
  /// empty where they are written directly, and after commit().
  [[nodiscard]] const std::string& temporary() const { return temporary_; }

 private:
  enum class Old { none, kept, not_kept };

  friend void commit_all(std::span<OutputFile* const> files);
  AVO_LOCAL void open_temporary(unsigned mode);
  AVO_LOCAL void flush();
  AVO_LOCAL void settle();
  AVO_LOCAL void keep_old();
  AVO_LOCAL bool put_old_back();
  [[noreturn]] AVO_LOCAL void fail() const;

  std::string name_;                // the name in messages
  std::string target_;              // behind all links; empty: written directly
  std::string temporary_, backup_;  // empty: none
  std::string buffer_;
  int descriptor_ = -1;
  bool closes_ = true;  // not the standard output
  Old old_ = Old::none;
};

/// Gives all of them their names, or none. First all bytes go to the disk, then the files are
/// renamed. If renaming a file fails, the files before it get their old content back. Throws
/// FileError, which names the files that could not get it back. Files that have their names already
/// are left alone.
AVO_API void commit_all(std::span<OutputFile* const> files);

/// For a program that is about to end: removes all files without commit(). A thread that continues
/// to write waits for ever; no thread is stopped between two renames.
AVO_API void abandon_outputs();

}  // namespace avo_io
