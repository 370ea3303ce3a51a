// SPDX-License-Identifier: Apache-2.0
// Blocks of recordings, compressed.
#include "io/recording/recording_blocks.h"

#include <algorithm>
#include <cstring>
#include <libdeflate.h>
#include <limits>
#include <new>

namespace avo_io {
namespace {

constexpr std::size_t kMostRobotsOfChunk = 1024;  // 512 KiB of a column
constexpr int kLevel = 1;                         // of deflate

/// Puts all first bytes of the values in front, then all second bytes, and so on.
void shuffle_bytes(std::span<const std::byte> values, std::size_t size,
                   std::span<std::byte> shuffled) {
  const std::size_t count = values.size() / size;
  for (std::size_t b = 0; b < size; ++b)
    for (std::size_t k = 0; k < count; ++k) shuffled[b * count + k] = values[k * size + b];
}

void unshuffle_bytes(std::span<const std::byte> shuffled, std::size_t size,
                     std::span<std::byte> values) {
  const std::size_t count = values.size() / size;
  for (std::size_t b = 0; b < size; ++b)
    for (std::size_t k = 0; k < count; ++k) values[k * size + b] = shuffled[b * count + k];
}

}  // namespace

std::size_t BlockShape::parts() const {
  return std::max<std::size_t>((robots + kMostRobotsOfChunk - 1) / kMostRobotsOfChunk, 1);
}

std::size_t BlockShape::robots_of_chunk() const {
  return (robots + parts() - 1) / parts();
}

RecordingBlock::RecordingBlock(const BlockShape& shape)
    : time(kBlockTimes),
      values(shape.columns() * kBlockTimes * shape.robots),
      status(kBlockTimes * shape.robots),
      clearance(kBlockTimes * shape.robots) {}

double* RecordingBlock::row(const BlockShape& shape, std::size_t column, std::size_t k) {
  return values.data() + (column * kBlockTimes + k) * shape.robots;
}

const double* RecordingBlock::row(const BlockShape& shape, std::size_t column,
                                  std::size_t k) const {
  return values.data() + (column * kBlockTimes + k) * shape.robots;
}

bool CompressedBlock::can_be(const BlockShape& shape) const {
  constexpr std::size_t kMostPerByte = 1032;  // the limit of deflate
  std::size_t bytes = 0;
  for (const std::string& chunk : chunks) bytes += chunk.size();
  const std::size_t row = shape.robots * (shape.columns() * sizeof(double) + 1 + sizeof(float));
  return chunks.size() == shape.chunks() && !time.empty() && time.size() <= kBlockTimes &&
         kBlockTimes * row / kMostPerByte <= bytes;
}

BlockCodec::BlockCodec(const BlockShape& shape)
    : shape_(shape),
      compressor_(libdeflate_alloc_compressor(kLevel)),
      decompressor_(libdeflate_alloc_decompressor()) {
  if (compressor_ == nullptr || decompressor_ == nullptr) throw std::bad_alloc();
  const std::size_t most = kBlockTimes * shape.robots_of_chunk() * sizeof(double);
  chunk_.resize(most);
  shuffled_.resize(most);
  bytes_.resize(libdeflate_zlib_compress_bound(compressor_, most));
}

BlockCodec::~BlockCodec() {
  libdeflate_free_compressor(compressor_);
  libdeflate_free_decompressor(decompressor_);
}

// Chunks have their full size: zeros fill the places of missing times or robots.
template <typename Value>
void BlockCodec::compress_table(std::span<const Value> table, std::size_t times,
                                std::string* chunks) {
  const std::size_t width = shape_.robots_of_chunk(), size = kBlockTimes * width * sizeof(Value);
  for (std::size_t part = 0; part < shape_.parts(); ++part) {
    const std::size_t first = part * width, count = std::min(width, shape_.robots - first);
    std::fill_n(chunk_.begin(), size, std::byte{0});
    for (std::size_t k = 0; k < times; ++k)
      std::memcpy(chunk_.data() + k * width * sizeof(Value),
                  table.data() + k * shape_.robots + first, count * sizeof(Value));
    shuffle_bytes({chunk_.data(), size}, sizeof(Value), shuffled_);
    const std::size_t length =
        libdeflate_zlib_compress(compressor_, shuffled_.data(), size, bytes_.data(), bytes_.size());
    chunks[part].assign(reinterpret_cast<const char*>(bytes_.data()), length);
  }
}

void BlockCodec::compress(const RecordingBlock& block, CompressedBlock& compressed) {
  compressed.time.assign(block.time.begin(),
                         block.time.begin() + static_cast<std::ptrdiff_t>(block.times));
  compressed.chunks.resize(shape_.chunks());
  std::string* chunks = compressed.chunks.data();
  const std::size_t table = kBlockTimes * shape_.robots;
  for (std::size_t c = 0; c < shape_.columns(); ++c, chunks += shape_.parts())
    compress_table<double>({block.values.data() + c * table, table}, block.times, chunks);
  compress_table<std::uint8_t>(block.status, block.times, chunks);
  compress_table<float>(block.clearance, block.times, chunks + shape_.parts());
}

template <typename Value>
bool BlockCodec::uncompress_table(const std::string* chunks, std::span<Value> table) {
  const std::size_t width = shape_.robots_of_chunk(), size = kBlockTimes * width * sizeof(Value);
  for (std::size_t part = 0; part < shape_.parts(); ++part) {
    const std::string& bytes = chunks[part];
    if (libdeflate_zlib_decompress(decompressor_, bytes.data(), bytes.size(), shuffled_.data(),
                                   size, nullptr) != LIBDEFLATE_SUCCESS)
      return false;
    unshuffle_bytes({shuffled_.data(), size}, sizeof(Value), {chunk_.data(), size});
    const std::size_t first = part * width, count = std::min(width, shape_.robots - first);
    for (std::size_t k = 0; k < kBlockTimes; ++k)
      std::memcpy(table.data() + k * shape_.robots + first,
                  chunk_.data() + k * width * sizeof(Value), count * sizeof(Value));
  }
  return true;
}

bool BlockCodec::uncompress(const CompressedBlock& compressed, RecordingBlock& block) {
  if (!compressed.can_be(shape_)) return false;
  block.times = compressed.time.size();
  std::copy(compressed.time.begin(), compressed.time.end(), block.time.begin());
  const std::string* chunks = compressed.chunks.data();
  const std::size_t table = kBlockTimes * shape_.robots;
  for (std::size_t c = 0; c < shape_.columns(); ++c, chunks += shape_.parts())
    if (!uncompress_table<double>(chunks, {block.values.data() + c * table, table})) return false;
  return uncompress_table<std::uint8_t>(chunks, block.status) &&
         uncompress_table<float>(chunks + shape_.parts(), block.clearance);
}

}  // namespace avo_io
