// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there at all.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "avo/export.h"
#include "avo_io/errors.h"

namespace avo_io {

/// Written under a temporary name beside its target, with the target's permissions where that
/// exists; commit() gives it its name, else it goes away. Links are followed. Devices, pipes and
/// the standard output are written directly.
class AVO_API OutputFile {
 public:
  /// "-" is the standard output. Throws FileError if the place cannot be written.
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  /// Buffered. Throws FileError, e.g. where the disk is full.
  void write(std::string_view bytes);
  /// The same as commit_all() of this one.
  void commit();
  /// Where its bytes are until then, for who writes them by other means than write(); empty where
  /// they are written directly, and once it has its name.
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

  std::string name_;                // what messages call it
  std::string target_;              // behind all links; empty: written directly
  std::string temporary_, backup_;  // empty: none
  std::string buffer_;
  int descriptor_ = -1;
  bool closes_ = true;  // not the standard output
  Old old_ = Old::none;
};

/// Gives all of them their names, or none: first all bytes go to the disk, then the files are
/// renamed; where that fails for one, those before it get their old content back. Throws FileError,
/// which names those that could not get it back. Files that have their names already are left
/// alone.
AVO_API void commit_all(std::span<OutputFile* const> files);

/// For a program that is about to end: removes what is not committed. Whoever writes on from
/// another thread waits for ever; none is caught between two renames.
AVO_API void abandon_outputs();

}  // namespace avo_io
