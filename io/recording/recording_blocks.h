// SPDX-License-Identifier: Apache-2.0
// Recordings in blocks of 64 times, and how a block is compressed: as HDF5's filters "shuffle" and
// "deflate" have it, so that the same bytes go to a spool and to an HDF5 file.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
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
inline constexpr std::uint8_t kAbsent = 255;  ///< in place of the status of who is not there

/// x, y, vx, vy, and of recordings with headings heading, speed.
inline constexpr std::size_t kPlainColumns = 4, kHeadingColumns = 6;
inline constexpr std::array<const char*, kHeadingColumns> kStateColumns{"x",  "y",       "vx",
                                                                        "vy", "heading", "speed"};

struct BlockShape {
  std::size_t robots = 0;
  std::size_t columns = kPlainColumns;

  /// Robots are split in parts of as many, each a chunk of its own; about 1000.
  [[nodiscard]] std::size_t robots_of_chunk() const;
  [[nodiscard]] std::size_t parts() const;
  /// Of all columns, of the status, of the clearance.
  [[nodiscard]] std::size_t chunks() const { return (columns + 2) * parts(); }
};

/// The rows of up to 64 times, a table [time, robot] for each thing.
struct RecordingBlock {
  std::size_t times = 0;
  std::vector<double> time;          // s
  std::vector<double> values;        // [column, time, robot]; not a number: not there, no heading
  std::vector<std::uint8_t> status;  // PlanStatus of the last decision, kAbsent
  std::vector<float> clearance;      // m, see avo::ClearanceFinder

  explicit RecordingBlock(const BlockShape& shape);
  [[nodiscard]] double* row(const BlockShape& shape, std::size_t column, std::size_t k);
  [[nodiscard]] const double* row(const BlockShape& shape, std::size_t column, std::size_t k) const;
};

struct CompressedBlock {
  std::vector<double> time;
  std::vector<std::string> chunks;  ///< of each column all parts, then of status, of clearance

  /// Whether as much as a block of that shape can be in so few bytes: to be asked before memory is
  /// taken for it.
  [[nodiscard]] bool can_be(const BlockShape& shape) const;
};

/// Compresses and uncompresses blocks of one shape; holds the memory for it.
class BlockCodec {
 public:
  explicit BlockCodec(const BlockShape& shape);
  ~BlockCodec();
  BlockCodec(const BlockCodec&) = delete;
  BlockCodec& operator=(const BlockCodec&) = delete;

  void compress(const RecordingBlock& block, CompressedBlock& compressed);
  /// False where the bytes are no such block.
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
