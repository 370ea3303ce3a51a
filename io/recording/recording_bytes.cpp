// SPDX-License-Identifier: Apache-2.0
// A recording as the bytes of an HDF5 file, with the requested number of times.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "avo_io/errors.h"
#include "avo_io/recording.h"
#include "io/recording/block_source.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/recording_blocks.h"

namespace avo_io {
namespace {

/// Copies one time of a block to the end of another block, which must have room for it.
void copy_time(const BlockShape& shape, const RecordingBlock& from, std::size_t k,
               RecordingBlock& to) {
  const std::size_t n = shape.robots, last = to.times++;
  to.time[last] = from.time[k];
  for (std::size_t c = 0; c < shape.columns(); ++c)
    std::copy_n(from.row(shape, c, k), n, to.row(shape, c, last));
  std::copy_n(&from.status[k * n], n, &to.status[last * n]);
  std::copy_n(&from.clearance[k * n], n, &to.clearance[last * n]);
}

/// Every n-th time of a recording, and its last time, in new blocks.
struct ThinnedBlocks {
  BlockSource source;
  std::size_t every, last;  // n; number of the last time of all
  BlockCodec codec;
  RecordingBlock thinned;
  std::size_t read = 0;  // number of times in the blocks of the source before the present one
  std::size_t k = 0;     // the next time of the present block

  ThinnedBlocks(const std::string& path, std::size_t step, std::size_t last_time)
      : source(path),
        every(step),
        last(last_time),
        codec(source.shape()),
        thinned(source.shape()) {}

  bool next(CompressedBlock& block);
};

bool ThinnedBlocks::next(CompressedBlock& block) {
  thinned.times = 0;
  while (thinned.times < kBlockTimes && read + k <= last) {
    if (read + k == 0 || k == source.block().times) {
      read += k;
      k = 0;
      if (!source.next()) break;
    }
    if ((read + k) % every == 0 || read + k == last)
      copy_time(source.shape(), source.block(), k, thinned);
    ++k;
  }
  if (thinned.times == 0) return false;
  codec.compress(thinned, block);
  return true;
}

}  // namespace

std::string recording_bytes(const std::string& recording, std::size_t most_times) {
  BlockSource source(recording);
  std::vector<double> times;
  while (source.next())
    times.insert(times.end(), source.block().time.begin(),
                 source.block().time.begin() + static_cast<std::ptrdiff_t>(source.block().times));
  if (times.size() < 2 || most_times < 2)
    throw RecordingError(recording + ": found rows of less than two times, must be of more");
  const std::size_t last = times.size() - 1;
  const std::size_t every = (last - 1) / (most_times - 1) + 1;
  std::vector<double> kept;
  for (std::size_t k = 0; k <= last; ++k)
    if (k % every == 0 || k == last) kept.push_back(times[k]);
  RecordingHeader header = source.header();
  header.every *= static_cast<std::int64_t>(every);
  ThinnedBlocks blocks(recording, every, last);
  return hdf5_bytes({header, source.shape(), kept,
                     [&blocks](CompressedBlock& block) { return blocks.next(block); }},
                    recording);
}

}  // namespace avo_io
