// SPDX-License-Identifier: Apache-2.0
// The output of a run: a table of all states, and one object of results; and a reader of such
// tables of any origin.
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

/// Returns whether a recording of the scene has columns for headings: a robot is not holonomic.
AVO_API bool has_headings(const avo::Scenario& scenario);

/// Options of a recording.
struct RecordingOptions {
  std::int64_t every = 1;      ///< only every n-th step is added, and the last one
  bool until_arrived = false;  ///< the run ends once all robots have arrived
};

/// The description in a recording: enough to simulate it again.
struct RecordingHeader {
  std::string version;  ///< of avo
  std::string build;    ///< compiler, processor, instructions
  std::uint64_t seed = 0;
  std::int64_t robots = 0;
  std::int64_t every = 1;      ///< only every n-th step has rows, and the last one
  bool headings = false;       ///< there are columns for headings
  bool space = false;          ///< the scene is one of space, and so are the columns
  bool until_arrived = false;  ///< the run was to end once all robots had arrived
  SceneSource scene;
  std::optional<std::uint64_t> state_hash =
      {};  ///< after the last step, if the run ended by itself
};

/// A file for a run's states.
class AVO_API Recording {
 public:
  virtual ~Recording() = default;
  /// Adds the present state: a row of each robot. Throws FileError.
  virtual void add(const avo::Simulation& simulation) = 0;
  /// Call it once after the last add(), before commit().
  virtual void finish(const avo::Simulation& simulation) = 0;
  void commit() { file_.commit(); }
  /// The file, for commit_all().
  OutputFile& file() { return file_; }

 protected:
  explicit Recording(const std::string& path) : file_(path) {}
  OutputFile file_;
};

/// CSV with header "time,robot,x,y,vx,vy", the shortest digits that read back to the same bits,
/// rows by time then robot.
class AVO_API CsvRecording final : public Recording {
 public:
  /// With headings, the header continues with ",heading,speed", see avo::CheckedHeading; holonomic
  /// robots leave both empty. `every` > 1: only every n-th step is added. A last column "every"
  /// says so in all rows, which readers of the other columns can ignore; see RecordedTime::every.
  explicit CsvRecording(const std::string& path, bool headings = false, std::int64_t every = 1);
  void add(const avo::Simulation& simulation) override;
  void finish(const avo::Simulation& simulation) override;

 private:
  bool headings_;
  std::int64_t every_;
  std::string rows_;
};

struct RecordedTime;

/// HDF5 (docs/recordings.md). During the run, its rows are in a spool, "PATH.part", in blocks of 64
/// times, which a thread of its own compresses. Whatever ends the process, the written blocks can
/// be read. finish() makes an HDF5 file of them; the spool is removed once that is committed.
class AVO_API Hdf5Recording final : public Recording {
 public:
  /// Throws FileError, also where `path` is no regular file, and where there is such a spool.
  Hdf5Recording(const std::string& path, const avo::Scenario& scenario, const SceneSource& source,
                const RecordingOptions& options = {});
  ~Hdf5Recording() override;
  void add(const avo::Simulation& simulation) override;
  void finish(const avo::Simulation& simulation) override;
  /// Adds rows that another program made of the scene's robots. How they were decided is unknown,
  /// so their status is `optimal`. Throws RecordingError where the time is not in the scene, and
  /// where a robot that is not holonomic has no heading.
  void add(const RecordedTime& moment);
  /// Call it after the last of such rows: there is no state of a simulation.
  void finish();

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

/// Whether a recording of that name is HDF5: it ends with ".h5", in any case of letters.
AVO_API bool is_hdf5_path(std::string_view path);

/// Opens HDF5 where is_hdf5_path(), else CSV.
AVO_API std::unique_ptr<Recording> open_recording(const std::string& path,
                                                  const avo::Scenario& scenario,
                                                  const SceneSource& source,
                                                  const RecordingOptions& options = {});

/// Returns the description in an HDF5 recording or a spool; none for any other file. Throws
/// FileError and RecordingError.
AVO_API std::optional<RecordingHeader> read_recording_header(const std::string& path);

/// A recording's own scene, and its description.
struct RecordedScene {
  RecordingHeader header;  ///< `scene` with the overrides
  avo::Scenario scenario;
};
/// Reads the scene of an HDF5 recording or a spool, with the overrides applied; none for any other
/// file. Throws FileError. Throws RecordingError, also where its scene cannot be used, or has
/// another number of robots. Throws OverrideError and SceneError on the overrides.
AVO_API std::optional<RecordedScene> read_recorded_scene(
    const std::string& path, const std::vector<std::string>& overrides = {});

/// The result of recover().
struct Recovered {
  std::int64_t times = 0;        ///< times in the new recording
  double last_time = 0.0;        ///< s
  std::uint64_t lost_bytes = 0;  ///< of the spool, behind its last whole block
  bool complete = false;         ///< the run had ended by itself: nothing is lost
};
/// Makes a recording at `path` of the spool that a run has left; the spool stays. Throws FileError
/// and RecordingError.
AVO_API Recovered recover(const std::string& spool, const std::string& path);

/// Returns an HDF5 recording, or the whole part of a spool, as the bytes of an HDF5 file. It has
/// `most_times` >= 2 times at most: every K-th with the least K for it, and the last one. Throws
/// FileError and RecordingError.
AVO_API std::string recording_bytes(
    const std::string& recording, std::size_t most_times = std::numeric_limits<std::size_t>::max());

/// All rows of one time, by ascending robot.
struct RecordedTime {
  double time = 0.0;  ///< s
  std::vector<avo::CheckedState> rows;
  /// More than 1: the recording has the rows of every n-th step only, and those of its last step.
  /// It is the largest value of the column "every", where that column exists.
  std::int64_t every = 1;
  /// The velocities are estimated, because a measurement of positions has none. The column
  /// "estimated" of CSV says so.
  bool estimated = false;
};

class RowSource;

/// Reads the output of a Recording, also the whole part of a spool. A CSV may have columns in any
/// order by the names of the first line; other columns are ignored. It reads heading and speed
/// where both exist, and "every" where it exists. Times are grouped and ascending, robots of one
/// time in any order. It never holds more than one time, of HDF5 64. Trajectories of pedestrians
/// are also read, and are held whole (docs/recordings.md, "Trajectories of others").
class AVO_API RecordingReader {
 public:
  /// "-" is the standard input. `robots`: numbers must be lower. Throws FileError, and
  /// RecordingError where the first line does not name the columns, or the file is damaged.
  explicit RecordingReader(const std::string& path, std::optional<std::int64_t> robots = {});
  ~RecordingReader();
  RecordingReader(const RecordingReader&) = delete;
  RecordingReader& operator=(const RecordingReader&) = delete;

  /// Reads the next time; false where there is none. Throws FileError or RecordingError, also where
  /// the recording ends with less than two times.
  bool next(RecordedTime& moment);
  /// Returns "file:line" of the last row of the last time, or of the row of a robot. Where there
  /// are no lines, it returns "file: time T", or "file: time T, robot I".
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot = {}) const;
  /// Returns the frames in a second, for recordings that have frames.
  [[nodiscard]] std::optional<double> frame_rate() const;

 private:
  std::unique_ptr<RowSource> source_;
};

/// Returns one JSON object, keys in a fixed order; missing values are null.
AVO_API std::string to_json(const avo::RunSummary& summary);

}  // namespace avo_io
