// SPDX-License-Identifier: Apache-2.0
// The blocks of a recording, and the rows in them.
#include "io/recording/block_source.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <system_error>
#include <unistd.h>

#include "avo_io/errors.h"
#include "io/files/regular_file.h"
#include "io/recording/recorded_scene.h"
#include "io/recording/recorded_states.h"
#include "io/recording/row_source.h"
#include "io/recording/tracks.h"

namespace avo_io {
namespace {

/// The rows of blocks, one time after the other.
class BlockRows final : public RowSource {
 public:
  BlockRows(const std::string& path, std::optional<std::int64_t> robots)
      : path_(path), source_(path) {
    require_plane(path, source_.header());
    if (robots && source_.header().robots > *robots)
      throw RecordingError(
          fmt::format("{}: found {} robots, must be {} at most, those of the scene", path,
                      source_.header().robots, *robots));
  }

  bool next(RecordedTime& moment) override;
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot) const override {
    return robot ? fmt::format("{}: time {} s, robot {}", path_, time_, *robot)
                 : fmt::format("{}: time {} s", path_, time_);
  }

 private:
  std::string path_;
  BlockSource source_;
  std::size_t next_ = 0, count_ = 0;  // in the block: the next time, and the number of times
  std::int64_t times_ = 0;
  double time_ = 0.0;
};

bool BlockRows::next(RecordedTime& moment) {
  if (next_ == count_) {
    if (!source_.next()) {
      if (times_ > 1) return false;
      throw RecordingError(
          fmt::format("{}: found rows of {} times, must be of two or more", path_, times_));
    }
    next_ = 0;
    count_ = source_.block().times;
  }
  time_ = source_.block().time[next_];
  moment.time = time_;
  moment.every = source_.header().every;
  moment.rows = rows_of(source_.shape(), source_.block(), next_);
  ++next_;
  ++times_;
  return true;
}

}  // namespace

BlockSource::BlockSource(const std::string& path) : path_(path) {
  switch (format_of(path)) {
    case RecordingFormat::hdf5:
      hdf5_.emplace(path);
      break;
    case RecordingFormat::spool:
      spool_.emplace(path);
      // before memory is allocated for as many robots as the header promises
      if (!spool_->next(compressed_))
        throw RecordingError(path + ": found no whole block, must be one or more");
      if (!compressed_.can_be(spool_->shape())) refuse_block();
      codec_.emplace(spool_->shape());
      break;
    default:
      throw RecordingError(path + ": found neither HDF5 nor a spool, must be one of them");
  }
}

const RecordingHeader& BlockSource::header() const {
  return hdf5_ ? hdf5_->header() : spool_->header();
}

const BlockShape& BlockSource::shape() const {
  return hdf5_ ? hdf5_->shape() : spool_->shape();
}

void BlockSource::refuse_block() const {
  throw RecordingError(path_ + ": found a damaged block, must be whole");
}

const avo::Scenario& BlockSource::scenario() {
  if (!scenario_) scenario_ = own_scene(path_, header());
  return *scenario_;
}

const avo::space::Scenario& BlockSource::scenario_of_space() {
  if (!scenario_of_space_) scenario_of_space_ = own_scene_of_space(path_, header());
  return *scenario_of_space_;
}

// Returns the end of the scene; a caller that judges by another scene or by limits does not need
// the recording's own.
double BlockSource::end_of_scene() {
  try {
    return header().space ? scenario_of_space().duration : scenario().duration;
  } catch (const OwnSceneError&) {
    return std::numeric_limits<double>::infinity();
  }
}

bool BlockSource::next() {
  if (!checks_) checks_.emplace(path_, end_of_scene());
  if (!read_block()) return false;
  checks_->check(shape(), *block_);
  return true;
}

bool BlockSource::read_block() {
  if (hdf5_) {
    if (!block_) block_.emplace(hdf5_->shape());
    return hdf5_->next(*block_);
  }
  if (begun_ && !spool_->next(compressed_)) return false;
  begun_ = true;
  if (!block_) block_.emplace(spool_->shape());
  if (!codec_->uncompress(compressed_, *block_)) refuse_block();
  return true;
}

std::unique_ptr<RowSource> block_rows(const std::string& path, std::optional<std::int64_t> robots) {
  return std::make_unique<BlockRows>(path, robots);
}

namespace {

/// Returns the first bytes of a file, which identify its format.
std::string beginning_of(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw FileError(with_errno(path));
  std::string bytes(4096, '\0');
  const ssize_t got = read(descriptor, bytes.data(), bytes.size());
  close(descriptor);
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

}  // namespace

RecordingFormat format_of(const std::string& path) {
  std::error_code error;
  const auto type =
      path == "-" ? std::filesystem::file_type::fifo : std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::not_found) {
    errno = ENOENT;
    const std::string spool = spool_path(path);
    const bool killed = is_hdf5_path(path) && std::filesystem::exists(spool, error);
    throw FileError(with_errno(path) +
                    (killed ? fmt::format("; a run has left {0}, which avo reads, and avo recover "
                                          "makes {1} of it",
                                          spool, path)
                            : std::string()));
  }
  if (type == std::filesystem::file_type::directory)
    throw FileError(path + ": found a directory, must be a file");
  // bytes that are read from a pipe cannot be read again
  if (type != std::filesystem::file_type::regular) return RecordingFormat::csv;
  const std::string bytes = beginning_of(path);
  if (is_hdf5(bytes))
    return is_pedestrian_hdf5(path) ? RecordingFormat::pedestrian_hdf5 : RecordingFormat::hdf5;
  if (is_spool(bytes)) return RecordingFormat::spool;
  if (is_sqlite(bytes)) return RecordingFormat::pedestrian_sqlite;
  constexpr std::string_view kPart = ".part";
  const std::string_view name = path;
  if (is_hdf5_path(name.ends_with(kPart) ? name.substr(0, name.size() - kPart.size()) : name))
    throw RecordingError(path +
                         ": found neither HDF5 nor a spool in it, cut off or damaged, must be one "
                         "of them, whole");
  return is_pedestrian_text(bytes) ? RecordingFormat::pedestrian_text : RecordingFormat::csv;
}

namespace {

std::unique_ptr<RowSource> rows_at(const std::string& path, std::optional<std::int64_t> robots) {
  switch (format_of(path)) {
    case RecordingFormat::csv:
      return csv_rows(path, robots);
    case RecordingFormat::pedestrian_text:
      return track_rows(read_pedestrian_text(path), robots);
    case RecordingFormat::pedestrian_hdf5:
      return track_rows(read_pedestrian_hdf5(path), robots);
    case RecordingFormat::pedestrian_sqlite:
      return track_rows(read_pedestrian_sqlite(path), robots);
    case RecordingFormat::hdf5:
    case RecordingFormat::spool:
      break;
  }
  return block_rows(path, robots);
}

}  // namespace

RecordingReader::RecordingReader(const std::string& path, std::optional<std::int64_t> robots)
    : source_(rows_at(path, robots)) {}
RecordingReader::~RecordingReader() = default;

bool RecordingReader::next(RecordedTime& moment) {
  return source_->next(moment);
}

std::string RecordingReader::place(std::optional<std::int64_t> robot) const {
  return source_->place(robot);
}

std::optional<double> RecordingReader::frame_rate() const {
  return source_->frame_rate();
}

std::optional<RecordingHeader> read_recording_header(const std::string& path) {
  switch (format_of(path)) {
    case RecordingFormat::hdf5:
      return Hdf5Reader(path).header();
    case RecordingFormat::spool:
      return SpoolReader(path).header();
    default:
      return std::nullopt;
  }
}

}  // namespace avo_io
