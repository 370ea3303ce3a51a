// SPDX-License-Identifier: Apache-2.0
// Writes a run's states to a spool, compressed by a separate thread, and then to an HDF5 file.
#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <mutex>
#include <optional>
#include <thread>
#include <unistd.h>
#include <utility>

#include "avo/clearance.h"
#include "avo/simd.h"
#include "avo/version.h"
#include "avo_io/recording.h"
#include "io/files/regular_file.h"
#include "io/recording/block_source.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/recorded_states.h"
#include "io/recording/recording_blocks.h"
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

RecordingHeader header_of(const avo::Scenario& scenario, const SceneSource& source,
                          const RecordingOptions& options) {
  return {.version = avo::kVersion,
          .build = build_description(),
          .seed = scenario.seed,
          .robots = static_cast<std::int64_t>(scenario.robots.size()),
          .every = options.every,
          .headings = has_headings(scenario),
          .until_arrived = options.until_arrived,
          .scene = source};
}

BlockShape shape_of(const avo::Scenario& scenario) {
  return {scenario.robots.size(), has_headings(scenario) ? kHeadingColumns : kPlainColumns};
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

struct Hdf5Recording::State {
  const std::string path;
  const BlockShape shape;
  std::array<RecordingBlock, 2> blocks;
  std::size_t filling = 0;
  avo::ClearanceFinder clearances;
  BlockCodec codec;
  CompressedBlock compressed;
  SpoolWriter spool;
  Exchange exchange;
  std::thread thread;
  bool finished = false;

  State(const std::string& file, const avo::Scenario& scenario, const SceneSource& source,
        const RecordingOptions& options)
      : path(file),
        shape(shape_of(scenario)),
        blocks{RecordingBlock(shape), RecordingBlock(shape)},
        clearances(scenario),
        codec(shape),
        spool(spool_path(file), header_of(scenario, source, options)),
        thread([this] { work(); }) {}
  ~State() { stop(); }

  void hand_over();
  void wait_until_free(std::unique_lock<std::mutex>& lock);
  void stop();
  void write_rest();
  void work();
  void write(RecordingBlock& block);
};

void Hdf5Recording::State::wait_until_free(std::unique_lock<std::mutex>& lock) {
  exchange.changed.wait(lock, [this] { return exchange.full == nullptr; });
  if (exchange.failure) std::rethrow_exception(exchange.failure);
}

void Hdf5Recording::State::hand_over() {
  std::unique_lock lock(exchange.mutex);
  wait_until_free(lock);
  exchange.full = &blocks[filling];
  filling = 1 - filling;
  blocks[filling].times = 0;
  exchange.changed.notify_all();
}

void Hdf5Recording::State::stop() {
  {
    const std::lock_guard lock(exchange.mutex);
    exchange.ends = true;
    exchange.changed.notify_all();
  }
  if (thread.joinable()) thread.join();
}

void Hdf5Recording::State::write(RecordingBlock& block) {
  for (std::size_t k = 0; k < block.times; ++k) find_clearances(shape, k, clearances, block);
  codec.compress(block, compressed);
  spool.write(compressed);
}

// The body of the compressing thread.
void Hdf5Recording::State::work() {
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

Hdf5Recording::Hdf5Recording(const std::string& path, const avo::Scenario& scenario,
                             const SceneSource& source, const RecordingOptions& options)
    : Recording(path) {
  if (file_.temporary().empty())
    throw FileError(path + ": found no regular file, HDF5 must be written to one");
  state_ = std::make_unique<State>(path, scenario, source, options);
}

Hdf5Recording::~Hdf5Recording() {
  if (!state_) return;
  state_->stop();
  if (state_->finished && file_.temporary().empty()) unlink(state_->spool.path().c_str());
}

void Hdf5Recording::add(const avo::Simulation& simulation) {
  add_states(simulation, state_->shape, state_->blocks[state_->filling]);
  if (state_->blocks[state_->filling].times == kBlockTimes) state_->hand_over();
}

void Hdf5Recording::add(const RecordedTime& moment) {
  add_rows(moment, state_->shape, state_->blocks[state_->filling]);
  if (state_->blocks[state_->filling].times == kBlockTimes) state_->hand_over();
}

void Hdf5Recording::State::write_rest() {
  if (blocks[filling].times > 0) hand_over();
  std::unique_lock lock(exchange.mutex);
  wait_until_free(lock);
}

void Hdf5Recording::finish(const avo::Simulation& simulation) {
  state_->write_rest();
  state_->spool.write_end(simulation.state_hash());
  finish();
}

void Hdf5Recording::finish() {
  state_->write_rest();
  write_hdf5(state_->spool.path(), file_.temporary(), state_->path);
  state_->finished = true;
}

std::unique_ptr<Recording> open_recording(const std::string& path, const avo::Scenario& scenario,
                                          const SceneSource& source,
                                          const RecordingOptions& options) {
  if (is_hdf5_path(path)) return std::make_unique<Hdf5Recording>(path, scenario, source, options);
  return std::make_unique<CsvRecording>(path, has_headings(scenario), options.every);
}

Recovered recover(const std::string& spool, const std::string& path) {
  Recovered found;
  {
    BlockSource source(spool);  // do not make a recording that no reader would accept
    while (source.next()) {
    }
  }
  {
    SpoolReader reader(spool);
    CompressedBlock block;
    while (reader.next(block)) found.last_time = block.time.back();
    found.lost_bytes = reader.lost_bytes();
    found.complete = reader.header().state_hash.has_value() && found.lost_bytes == 0;
  }
  OutputFile file(path);
  if (file.temporary().empty())
    throw FileError(path + ": found no regular file, HDF5 must be written to one");
  found.times = write_hdf5(spool, file.temporary(), path);
  file.commit();
  return found;
}

}  // namespace avo_io
