// SPDX-License-Identifier: Apache-2.0
// Recordings in blocks of 64 times, and the compression of a block. It follows HDF5's filters
// "shuffle" and "deflate", so that the same bytes go to a spool and to an HDF5 file.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct libdeflate_compressor;
struct libdeflate_decompressor;

namespace avo_io {

inline constexpr std::size_t kBlockTimes = 64;
inline constexpr std::uint8_t kAbsent = 255;  ///< stands in place of an absent robot's status

/// The numbers of a robot's state.
struct StateColumns {
  std::size_t count = 0;
  std::array<const char*, 6> names{};
  const char *list = "", *units = "";  // as attributes of the table
};
inline constexpr StateColumns kPlainColumns{4, {"x", "y", "vx", "vy"}, "x,y,vx,vy", "m,m,m/s,m/s"};
inline constexpr StateColumns kHeadingColumns{6,
                                              {"x", "y", "vx", "vy", "heading", "speed"},
                                              "x,y,vx,vy,heading,speed",
                                              "m,m,m/s,m/s,rad,m/s"};
inline constexpr StateColumns kSpaceColumns{
    6, {"x", "y", "z", "vx", "vy", "vz"}, "x,y,z,vx,vy,vz", "m,m,m,m/s,m/s,m/s"};

struct BlockShape {
  std::size_t robots = 0;
  const StateColumns* state = &kPlainColumns;

  [[nodiscard]] std::size_t columns() const { return state->count; }
  [[nodiscard]] bool has_headings() const { return state == &kHeadingColumns; }

  /// Robots are split into parts of this number, each a chunk of its own; about 1000.
  [[nodiscard]] std::size_t robots_of_chunk() const;
  [[nodiscard]] std::size_t parts() const;
  /// Returns the number of chunks of all columns, of the status, and of the clearance.
  [[nodiscard]] std::size_t chunks() const { return (columns() + 2) * parts(); }
};

/// The rows of up to 64 times: a table [time, robot] for each quantity.
struct RecordingBlock {
  std::size_t times = 0;
  std::vector<double> time;    // s
  std::vector<double> values;  // [column, time, robot]; NaN: the robot is absent, or has no heading
  std::vector<std::uint8_t> status;  // PlanStatus of the last decision, or kAbsent
  std::vector<float> clearance;      // m, see avo::ClearanceFinder

  explicit RecordingBlock(const BlockShape& shape);
  [[nodiscard]] double* row(const BlockShape& shape, std::size_t column, std::size_t k);
  [[nodiscard]] const double* row(const BlockShape& shape, std::size_t column, std::size_t k) const;
};

/// Appends a time to a block, which must have room for it, with rows of any origin. values(row):
/// the numbers of all columns, and maybe more. `status` is that of every row's robot.
template <class Rows, class Values>
void append_rows(double time, const Rows& rows, const BlockShape& shape, std::uint8_t status,
                 const Values& values, RecordingBlock& block) {
  const std::size_t k = block.times++;
  block.time[k] = time;
  std::uint8_t* const statuses = block.status.data() + k * shape.robots;
  std::fill_n(statuses, shape.robots, kAbsent);
  for (std::size_t c = 0; c < shape.columns(); ++c)
    std::fill_n(block.row(shape, c, k), shape.robots, std::numeric_limits<double>::quiet_NaN());
  for (const auto& row : rows) {
    const auto i = static_cast<std::size_t>(row.robot);
    statuses[i] = status;
    const std::array<double, 6> numbers = values(row);
    for (std::size_t c = 0; c < shape.columns(); ++c) block.row(shape, c, k)[i] = numbers[c];
  }
}

struct CompressedBlock {
  std::vector<double> time;
  /// all parts of each column, then those of the status and of the clearance
  std::vector<std::string> chunks;

  /// Returns whether so few bytes can contain a block of that shape. Ask before memory is allocated
  /// for the block.
  [[nodiscard]] bool can_be(const BlockShape& shape) const;
};

/// Compresses and uncompresses blocks of one shape; it owns the memory for that.
class BlockCodec {
 public:
  explicit BlockCodec(const BlockShape& shape);
  ~BlockCodec();
  BlockCodec(const BlockCodec&) = delete;
  BlockCodec& operator=(const BlockCodec&) = delete;

  void compress(const RecordingBlock& block, CompressedBlock& compressed);
  /// Returns false if the bytes are not such a block.
  bool uncompress(const CompressedBlock& compressed, RecordingBlock& block);

 private:
  template <typename Value>
  void compress_table(std::span<const Value> table, std::size_t times, std::string* chunks);
  template <typename Value>
  bool uncompress_table(const std::string* chunks, std::span<Value> table);

  BlockShape shape_;
  libdeflate_compressor* compressor_;
  libdeflate_decompressor* decompressor_;
  std::vector<std::byte> chunk_, shuffled_, bytes_;
};

}  // namespace avo_io
