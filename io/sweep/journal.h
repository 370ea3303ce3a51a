// SPDX-License-Identifier: Apache-2.0
// The file that a sweep's finished runs are added to, so that they outlive whatever ends it.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace avo_io {

/// A head, and one line a run that ends with a hash of the others of its fields: a line that was
/// torn is found, and cut off with all behind it.
class SweepJournal {
 public:
  /// Opens `path`, or makes it, and keeps others from writing there meanwhile. `sweep` and `shard`
  /// have to be those that it was begun with, and rows have `fields`. Throws FileError, and
  /// SceneError where it is another one's.
  SweepJournal(const std::string& path, const std::string& sweep, const std::string& shard,
               std::size_t fields);
  ~SweepJournal();
  SweepJournal(const SweepJournal&) = delete;
  SweepJournal& operator=(const SweepJournal&) = delete;

  /// The runs that were there.
  [[nodiscard]] const std::vector<std::vector<std::string>>& rows() const { return rows_; }
  /// In one piece, to the kernel: only an end of the whole machine can tear it. Throws FileError.
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
