// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>

#include "avo/planner.h"
#include "avo_io/errors.h"
#include "avo_io/space.h"
#include "io/recording/block_source.h"
#include "io/recording/row_source.h"
#include "io/text/line_reader.h"

namespace avo_io {
namespace {

/// The rows of an HDF5 file or a spool.
class SpaceBlockRows final : public SpaceRowSource {
 public:
  explicit SpaceBlockRows(const std::string& path) : path_(path), source_(path) {
    if (!source_.header().space)
      throw RecordingError(path + ": found a recording of the plane, must be one of space here");
    moment_.every = source_.header().every;
  }
  const SpaceMoment* next() override;
  [[nodiscard]] std::string place(std::optional<std::int64_t> /*robot*/) const override {
    return fmt::format("{}: time {} s", path_, moment_.time);
  }

 private:
  std::string path_;
  BlockSource source_;
  std::size_t next_ = 0, count_ = 0;  // in the block: the next time, and the number of times
  SpaceMoment moment_;
};

const SpaceMoment* SpaceBlockRows::next() {
  if (next_ == count_) {
    if (!source_.next()) return nullptr;
    next_ = 0;
    count_ = source_.block().times;
  }
  const BlockShape& shape = source_.shape();
  const RecordingBlock& block = source_.block();
  moment_.time = block.time[next_];
  moment_.rows.clear();
  for (std::size_t i = 0; i < shape.robots; ++i) {
    if (block.status[next_ * shape.robots + i] == kAbsent) continue;
    const auto value = [&](std::size_t column) { return block.row(shape, column, next_)[i]; };
    moment_.rows.push_back({static_cast<std::int64_t>(i),
                            {value(0), value(1), value(2)},
                            {value(3), value(4), value(5)}});
  }
  ++next_;
  return &moment_;
}

bool is_hdf5_or_spool(const std::string& path) {
  const RecordingFormat format = format_of(path);
  return format == RecordingFormat::hdf5 || format == RecordingFormat::spool;
}

std::unique_ptr<SpaceRowSource> source_of(const std::string& path) {
  if (is_hdf5_or_spool(path)) return std::make_unique<SpaceBlockRows>(path);
  return space_csv_rows(path);
}

}  // namespace

void append_moment(const SpaceMoment& moment, const BlockShape& shape, RecordingBlock& block) {
  const auto values = [](const avo::space::CheckedState& row) {
    return std::array{row.position.x, row.position.y, row.position.z,
                      row.velocity.x, row.velocity.y, row.velocity.z};
  };
  append_rows(moment.time, moment.rows, shape, static_cast<std::uint8_t>(avo::PlanStatus::optimal),
              values, block);
}

SpaceRows::SpaceRows(const std::string& path) : source_(source_of(path)) {}

void SpaceRows::fail(const std::string& what, std::optional<std::int64_t> robot) const {
  throw RecordingError(fmt::format("{}: {}", source_->place(robot), what));
}

void SpaceRows::require_known(const SpaceMoment& moment, std::size_t robots) const {
  for (const avo::space::CheckedState& row : moment.rows) {
    if (row.robot >= static_cast<std::int64_t>(robots))
      fail(fmt::format("robot: found {}, must be 0 to {}, the robots of the scene", row.robot,
                       static_cast<std::int64_t>(robots) - 1),
           row.robot);
  }
}

bool is_space_recording(const std::string& path) {
  // the bytes of a pipe cannot be read again
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (is_hdf5_or_spool(path)) return BlockSource(path).header().space;
  if (format_of(path) != RecordingFormat::csv) return false;
  LineReader lines(path);
  const auto first = lines.next();
  return first && first->starts_with(kSpaceCsvHeader);
}

}  // namespace avo_io
