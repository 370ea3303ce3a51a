// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: a table of all states, and one object of results; and reading the table
// again, whoever wrote it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "avo/check.h"
#include "avo/export.h"
#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo_io/output_file.h"
#include "avo_io/scene.h"

namespace avo_io {

/// Whether a recording of the scene has columns for headings: a robot is not holonomic.
AVO_API bool has_headings(const avo::Scenario& scenario);

/// How a run is recorded.
struct RecordingOptions {
  std::int64_t every = 1;      ///< only every so many steps are added, and the last one
  bool until_arrived = false;  ///< the run ends once all robots have arrived
};

/// What a recording says of itself: enough to simulate it again.
struct RecordingHeader {
  std::string version;  ///< of avo
  std::string build;    ///< compiler, processor, instructions
  std::uint64_t seed = 0;
  std::int64_t robots = 0;
  std::int64_t every = 1;      ///< only every so many steps have rows, and the last one
  bool headings = false;       ///< there are columns for headings
  bool until_arrived = false;  ///< the run was to end once all robots had arrived
  SceneSource scene;
  std::optional<std::uint64_t> state_hash =
      {};  ///< after the last step, if the run ended by itself
};

/// A file that a run's states go to.
class AVO_API Recording {
 public:
  virtual ~Recording() = default;
  /// The present state: a row of each robot. Throws FileError.
  virtual void add(const avo::Simulation& simulation) = 0;
  /// Once after the last add(), before commit().
  virtual void finish(const avo::Simulation& simulation) = 0;
  void commit() { file_.commit(); }
  /// For commit_all().
  OutputFile& file() { return file_; }

 protected:
  explicit Recording(const std::string& path) : file_(path) {}
  OutputFile file_;
};

/// CSV with header "time,robot,x,y,vx,vy", the shortest digits that read back to the same bits,
/// rows by time then robot.
class AVO_API CsvRecording final : public Recording {
 public:
  /// With headings, ",heading,speed" follow in the header, see avo::CheckedHeading; holonomic
  /// robots leave both empty. `every` > 1: only every so many steps are added; so says a last
  /// column "every" in all rows, which readers of the others need not know, and
  /// RecordedTime::every.
  explicit CsvRecording(const std::string& path, bool headings = false, std::int64_t every = 1);
  void add(const avo::Simulation& simulation) override;
  void finish(const avo::Simulation& simulation) override;

 private:
  bool headings_;
  std::int64_t every_;
  std::string rows_;
};

/// HDF5 (docs/recordings.md). While the run goes on, its rows are in a spool, "PATH.part", in
/// blocks of 64 times, compressed by a thread of its own: whatever ends the process, the blocks
/// that are there can be read. finish() makes an HDF5 file of them, and once that is committed the
/// spool goes.
class AVO_API Hdf5Recording final : public Recording {
 public:
  /// Throws FileError, also where `path` is no regular file, and where there is such a spool.
  Hdf5Recording(const std::string& path, const avo::Scenario& scenario, const SceneSource& source,
                const RecordingOptions& options = {});
  ~Hdf5Recording() override;
  void add(const avo::Simulation& simulation) override;
  void finish(const avo::Simulation& simulation) override;

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// Whether a recording of that name is HDF5: it ends with ".h5", in any case of letters.
AVO_API bool is_hdf5_path(std::string_view path);

/// HDF5 where is_hdf5_path(), else CSV.
AVO_API std::unique_ptr<Recording> open_recording(const std::string& path,
                                                  const avo::Scenario& scenario,
                                                  const SceneSource& source,
                                                  const RecordingOptions& options = {});

/// What an HDF5 recording or a spool says of itself; none of any other file. Throws FileError and
/// RecordingError.
AVO_API std::optional<RecordingHeader> read_recording_header(const std::string& path);

/// A recording's own scene, and what it says of itself.
struct RecordedScene {
  RecordingHeader header;  ///< `scene` with the overrides
  avo::Scenario scenario;
};
/// Of an HDF5 recording or a spool, whose scene the overrides change; none of any other file.
/// Throws FileError; RecordingError, also where the scene in it cannot be used, or has another
/// number of robots; OverrideError and SceneError on the overrides.
AVO_API std::optional<RecordedScene> read_recorded_scene(
    const std::string& path, const std::vector<std::string>& overrides = {});

/// What recover() has found.
struct Recovered {
  std::int64_t times = 0;        ///< that the recording now has
  double last_time = 0.0;        ///< s
  std::uint64_t lost_bytes = 0;  ///< of the spool, behind its last whole block
  bool complete = false;         ///< the run had ended by itself: nothing is lost
};
/// Makes a recording at `path` of the spool that a run has left, which stays. Throws FileError and
/// RecordingError.
AVO_API Recovered recover(const std::string& spool, const std::string& path);

/// An HDF5 recording, or a spool as far as it is whole, as the bytes of an HDF5 file. Of its times
/// there are `most_times` >= 2 at most: every K-th with the least K for it, and the last one.
/// Throws FileError and RecordingError.
AVO_API std::string recording_bytes(
    const std::string& recording, std::size_t most_times = std::numeric_limits<std::size_t>::max());

/// All rows of one time, by ascending robot.
struct RecordedTime {
  double time = 0.0;  ///< s
  std::vector<avo::CheckedState> rows;
  /// More than 1: the recording has the rows of every so many steps only, and those of its last
  /// step. The largest of the column "every", where that is there.
  std::int64_t every = 1;
  /// The velocities are estimated: a measurement of positions has none of its own. So says the
  /// column "estimated" of CSV.
  bool estimated = false;
};

class RowSource;

/// Reads what a Recording writes, a spool too as far as it is whole. Of CSV any like it: columns in
/// any order by the names of the first line, others ignored; heading and speed where both are
/// there, "every" where it is; times grouped and ascending, robots of one time in any order. Never
/// holds more than one time, of HDF5 64. Trajectories of pedestrians, which are read too, are held
/// whole (docs/recordings.md, "Trajectories of others").
class AVO_API RecordingReader {
 public:
  /// "-" is the standard input. `robots`: numbers have to be lower. Throws FileError, and
  /// RecordingError where the first line does not name the columns, or the file is damaged.
  explicit RecordingReader(const std::string& path, std::optional<std::int64_t> robots = {});
  ~RecordingReader();
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;

  /// The next time; false where there is none. Throws FileError or RecordingError, also where the
  /// recording ends with less than two times.
  bool next(RecordedTime& moment);
  /// "file:line" of the last row of the last time, or of that of a robot; where there are no lines
  /// "file: time T", or "file: time T, robot I".
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot = {}) const;
  /// Frames in a second, of recordings that have frames.
  [[nodiscard]] std::optional<double> frame_rate() const;

 private:
  std::unique_ptr<RowSource> source_;
};

/// One JSON object, keys in a fixed order; what there is not is null.
AVO_API std::string to_json(const avo::RunSummary& summary);

}  // namespace avo_io
