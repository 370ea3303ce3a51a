// SPDX-License-Identifier: Apache-2.0
// The file to which a sweep appends its finished runs, so that they survive any end of the sweep.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace avo_io {

/// A head, and one line per run. Each line ends with a hash of its other fields: a torn line is
/// found, and is cut off with everything behind it.
class SweepJournal {
 public:
  /// Opens `path`, or creates it, and locks it against other writers meanwhile. `sweep` and `shard`
  /// must be those that the journal began with, and rows have `fields`. Throws FileError, and
  /// SceneError if the journal is another sweep's.
  SweepJournal(const std::string& path, const std::string& sweep, const std::string& shard,
               std::size_t fields);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// Returns the runs that the file had when it was opened.
  [[nodiscard]] const std::vector<std::vector<std::string>>& rows() const { return rows_; }
  /// Passes the row to the kernel in one piece: only a crash of the whole machine can tear it.
  /// Throws FileError.
  void add(const std::vector<std::string>& row);

 private:
  void open_locked();
  void begin(const std::string& head, std::size_t fields);
  void write(const std::string& text);

  std::string path_;
  int descriptor_ = -1;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace avo_io
