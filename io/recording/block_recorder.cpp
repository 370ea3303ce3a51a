// SPDX-License-Identifier: Apache-2.0
#include "io/recording/block_recorder.h"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <fmt/format.h>
#include <mutex>
#include <thread>
#include <unistd.h>
#include <utility>

#include "avo/simd.h"
#include "avo/version.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/recording_fields.h"
#include "io/recording/spool.h"

namespace avo_io {
namespace {

std::string build_description() {
#if defined(__clang__)
  constexpr const char* kCompiler = "clang " __clang_version__;
#elif defined(__GNUC__)
  constexpr const char* kCompiler = "g++ " __VERSION__;
#else
  constexpr const char* kCompiler = "unknown compiler";
#endif
#if defined(__x86_64__)
  constexpr const char* kProcessor = "x86_64";
#elif defined(__aarch64__)
  constexpr const char* kProcessor = "aarch64";
#else
  constexpr const char* kProcessor = "unknown processor";
#endif
  return fmt::format("{}, {}, {}", kCompiler, kProcessor, avo::simd_target());
}

/// Two blocks: the run fills one while the other is compressed, so that the compression is never
/// more than one block behind.
struct Exchange {
  std::mutex mutex;
  std::condition_variable changed;
  RecordingBlock* full = nullptr;  // for the compressing thread
  bool ends = false;
  std::exception_ptr failure;
};

}  // namespace

RecordingHeader header_of_this_build() {
  RecordingHeader header;
  header.version = avo::kVersion;
  header.build = build_description();
  return header;
}

struct BlockRecorder::State {
  const std::string path;
  const BlockShape shape;
  std::array<RecordingBlock, 2> blocks;
  std::size_t filling = 0;
  FindClearances find_clearances;
  BlockCodec codec;
  CompressedBlock compressed;
  SpoolWriter spool;
  Exchange exchange;
  std::thread thread;
  bool finished = false;

  State(const std::string& file, const RecordingHeader& header, FindClearances clearances)
      : path(file),
        shape(shape_of(header)),
        blocks{RecordingBlock(shape), RecordingBlock(shape)},
        find_clearances(std::move(clearances)),
        codec(shape),
        spool(spool_path(file), header),
        thread([this] { work(); }) {}
  ~State() { stop(); }

  void hand_over();
  void wait_until_free(std::unique_lock<std::mutex>& lock);
  void stop();
  void write_rest();
  void work();
  void write(RecordingBlock& block);
};

void BlockRecorder::State::wait_until_free(std::unique_lock<std::mutex>& lock) {
  exchange.changed.wait(lock, [this] { return exchange.full == nullptr; });
  if (exchange.failure) std::rethrow_exception(exchange.failure);
}

void BlockRecorder::State::hand_over() {
  std::unique_lock lock(exchange.mutex);
  wait_until_free(lock);
  exchange.full = &blocks[filling];
  filling = 1 - filling;
  blocks[filling].times = 0;
  exchange.changed.notify_all();
}

void BlockRecorder::State::stop() {
  {
    const std::lock_guard lock(exchange.mutex);
    exchange.ends = true;
    exchange.changed.notify_all();
  }
  if (thread.joinable()) thread.join();
}

void BlockRecorder::State::write(RecordingBlock& block) {
  for (std::size_t k = 0; k < block.times; ++k) find_clearances(k, block);
  codec.compress(block, compressed);
  spool.write(compressed);
}

// The body of the compressing thread.
void BlockRecorder::State::work() {
  std::unique_lock lock(exchange.mutex);
  while (true) {
    exchange.changed.wait(lock, [this] { return exchange.full != nullptr || exchange.ends; });
    if (exchange.full == nullptr) return;
    lock.unlock();
    std::exception_ptr failure;
    try {
      write(*exchange.full);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (failure) exchange.failure = failure;
    exchange.full = nullptr;
    exchange.changed.notify_all();
    if (failure) return;
  }
}

void BlockRecorder::State::write_rest() {
  if (blocks[filling].times > 0) hand_over();
  std::unique_lock lock(exchange.mutex);
  wait_until_free(lock);
}

BlockRecorder::BlockRecorder(const std::string& path, const RecordingHeader& header,
                             FindClearances clearances)
    : state_(std::make_unique<State>(path, header, std::move(clearances))) {}
BlockRecorder::~BlockRecorder() = default;

const BlockShape& BlockRecorder::shape() const {
  return state_->shape;
}

RecordingBlock& BlockRecorder::block() {
  return state_->blocks[state_->filling];
}

void BlockRecorder::taken() {
  if (block().times == kBlockTimes) state_->hand_over();
}

void BlockRecorder::finish(const std::string& temporary, std::optional<std::uint64_t> state_hash) {
  state_->write_rest();
  if (state_hash) state_->spool.write_end(*state_hash);
  write_hdf5(state_->spool.path(), temporary, state_->path);
  state_->finished = true;
}

void BlockRecorder::remove_spool_of(const OutputFile& file) {
  state_->stop();
  if (state_->finished && file.temporary().empty()) unlink(state_->spool.path().c_str());
}

}  // namespace avo_io
