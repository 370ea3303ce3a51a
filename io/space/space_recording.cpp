// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_recording.h"

#include <array>
#include <cstdint>

#include "avo_io/errors.h"

namespace avo_io {
namespace {

/// CSV, all robots of one time in the order of the scene.
class SpaceCsvRecording final : public SpaceRecording {
 public:
  SpaceCsvRecording(const std::string& path, std::int64_t every) : SpaceRecording(path) {
    moment_.every = every;
    file_.write(space_csv_header(every));
  }
  void add(const avo::space::Simulation& simulation) override {
    moment_.time = simulation.time();
    moment_.rows.clear();
    for (const avo::space::Robot& robot : simulation.robots())
      moment_.rows.push_back(
          {static_cast<std::int64_t>(moment_.rows.size()), robot.position, robot.velocity});
    lines_.clear();
    append_csv_lines(moment_, lines_);
    file_.write(lines_);
  }
  void finish(const avo::space::Simulation& /*simulation*/) override {}

 private:
  SpaceMoment moment_;
  std::string lines_;
};

RecordingHeader header_of(const avo::space::Scenario& scenario, const SceneSource& source,
                          const RecordingOptions& options, bool is_converted) {
  RecordingHeader header = header_of_run(scenario, source, options);
  header.space = true;
  if (is_converted) header.build = kConvertedRows;
  return header;
}

const std::string& require_regular(const OutputFile& file, const std::string& path) {
  if (file.temporary().empty())
    throw FileError(path + ": found no regular file, HDF5 must be written to one");
  return path;
}

}  // namespace

void add_states(const avo::space::Simulation& simulation, const BlockShape& shape,
                RecordingBlock& block) {
  const std::size_t k = block.times++;
  block.time[k] = simulation.time();
  std::array<double*, kSpaceColumns.count> row{};
  for (std::size_t c = 0; c < row.size(); ++c) row[c] = block.row(shape, c, k);
  std::uint8_t* const status = block.status.data() + k * shape.robots;
  for (std::size_t i = 0; i < shape.robots; ++i) {
    const avo::space::Robot& robot = simulation.robots()[i];
    const std::array<double, kSpaceColumns.count> values = {robot.position.x, robot.position.y,
                                                            robot.position.z, robot.velocity.x,
                                                            robot.velocity.y, robot.velocity.z};
    for (std::size_t c = 0; c < row.size(); ++c) row[c][i] = values[c];
    status[i] = static_cast<std::uint8_t>(simulation.plans()[i].status);
  }
}

SpaceHdf5Recording::SpaceHdf5Recording(const std::string& path,
                                       const avo::space::Scenario& scenario,
                                       const SceneSource& source, const RecordingOptions& options,
                                       bool is_converted)
    : SpaceRecording(path),
      clearances_(scenario),
      recorder_(require_regular(file_, path), header_of(scenario, source, options, is_converted),
                [this](std::size_t time, RecordingBlock& block) {
                  clearances_.find(recorder_.shape(), time, block);
                }) {}

SpaceHdf5Recording::~SpaceHdf5Recording() {
  recorder_.remove_spool_of(file_);
}

void SpaceHdf5Recording::add(const avo::space::Simulation& simulation) {
  add_states(simulation, recorder_.shape(), recorder_.block());
  recorder_.taken();
}

void SpaceHdf5Recording::add(const SpaceMoment& moment) {
  append_moment(moment, recorder_.shape(), recorder_.block());
  recorder_.taken();
}

void SpaceHdf5Recording::finish(const avo::space::Simulation& simulation) {
  recorder_.finish(file_.temporary(), simulation.state_hash());
}

void SpaceHdf5Recording::finish() {
  recorder_.finish(file_.temporary(), {});
}

std::unique_ptr<SpaceRecording> open_space_recording(const std::string& path,
                                                     const avo::space::Scenario& scenario,
                                                     const SceneSource& source,
                                                     const RecordingOptions& options) {
  if (!is_hdf5_path(path)) return std::make_unique<SpaceCsvRecording>(path, options.every);
  return std::make_unique<SpaceHdf5Recording>(path, scenario, source, options);
}

}  // namespace avo_io
