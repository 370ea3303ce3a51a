// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: a table of all states, and one object of results; and reading the table
// again, whoever wrote it.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/output_file.h"

namespace avo_io {

/// Whether a recording of the scene has columns for headings: a robot is not holonomic.
AVO_API bool has_headings(const avo::Scenario& scenario);

/// CSV with header "time,robot,x,y,vx,vy", 17 significant digits, rows by time then robot.
class AVO_API CsvRecording {
 public:
  /// With headings, ",heading,speed" follow in the header, see avo::CheckedHeading, in the shortest
  /// form that reads back to the same bits; holonomic robots leave both empty. `every` > 1: only
  /// every so many steps are added; so says a last column "every" in all rows, which readers of the
  /// others need not know, and RecordedTime::every.
  explicit CsvRecording(const std::string& path, bool headings = false, std::int64_t every = 1);
  /// One row a robot. Throws FileError.
  void add(const avo::Simulation& simulation);
  void commit() { file_.commit(); }
  /// For commit_all().
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
  bool headings_;
  std::int64_t every_;
};

/// All rows of one time, by ascending robot.
struct RecordedTime {
  double time = 0.0;  ///< s
  std::vector<avo::CheckedState> rows;
  /// More than 1: the recording has the rows of every so many steps only, and those of its last
  /// step. The largest of the column "every", where that is there.
  std::int64_t every = 1;
};

/// Reads what CsvRecording writes, and its like: columns in any order by the names of the first
/// line, others ignored; heading and speed where both are there, "every" where it is; times grouped
/// and ascending, robots of one time in any order. Never holds more than one time.
class AVO_API RecordingReader {
 public:
  /// "-" is the standard input. `robots`: numbers have to be lower. Throws FileError, and
  /// RecordingError where the first line does not name the columns.
  explicit RecordingReader(const std::string& path, std::optional<std::int64_t> robots = {});
  ~RecordingReader();
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;

  /// The next time; false where there is none. Throws FileError or RecordingError, also where the
  /// recording ends with less than two times.
  bool next(RecordedTime& moment);
  /// "file:line" of the last row of the last time, or of that of a robot.
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot = {}) const;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// One JSON object, keys in a fixed order; what there is not is null.
AVO_API std::string to_json(const avo::RunSummary& summary);

}  // namespace avo_io
