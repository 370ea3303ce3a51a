// SPDX-License-Identifier: Apache-2.0
// Recordings of the plane as HDF5: what a run or another program adds.
#include <string>

#include "avo/clearance.h"
#include "avo_io/recording.h"
#include "io/files/regular_file.h"
#include "io/recording/block_recorder.h"
#include "io/recording/block_source.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/recorded_states.h"
#include "io/recording/spool.h"

namespace avo_io {
namespace {

RecordingHeader header_of(const avo::Scenario& scenario, const SceneSource& source,
                          const RecordingOptions& options) {
  RecordingHeader header = header_of_run(scenario, source, options);
  header.headings = has_headings(scenario);
  return header;
}

}  // namespace

struct Hdf5Recording::State {
  avo::ClearanceFinder clearances;
  BlockRecorder recorder;  // its thread uses the clearances

  State(const std::string& path, const avo::Scenario& scenario, const SceneSource& source,
        const RecordingOptions& options)
      : clearances(scenario),
        recorder(path, header_of(scenario, source, options),
                 [this](std::size_t time, RecordingBlock& block) {
                   find_clearances(recorder.shape(), time, clearances, block);
                 }) {}
};

Hdf5Recording::Hdf5Recording(const std::string& path, const avo::Scenario& scenario,
                             const SceneSource& source, const RecordingOptions& options)
    : Recording(path) {
  if (file_.temporary().empty())
    throw FileError(path + ": found no regular file, HDF5 must be written to one");
  state_ = std::make_unique<State>(path, scenario, source, options);
}

Hdf5Recording::~Hdf5Recording() {
  if (state_) state_->recorder.remove_spool_of(file_);
}

void Hdf5Recording::add(const avo::Simulation& simulation) {
  add_states(simulation, state_->recorder.shape(), state_->recorder.block());
  state_->recorder.taken();
}

void Hdf5Recording::add(const RecordedTime& moment) {
  add_rows(moment, state_->recorder.shape(), state_->recorder.block());
  state_->recorder.taken();
}

void Hdf5Recording::finish(const avo::Simulation& simulation) {
  state_->recorder.finish(file_.temporary(), simulation.state_hash());
}

void Hdf5Recording::finish() {
  state_->recorder.finish(file_.temporary(), {});
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
