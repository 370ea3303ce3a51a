// SPDX-License-Identifier: Apache-2.0
// Writes recordings as HDF5 files from a spool; its compressed chunks are copied.
#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <initializer_list>
#include <unistd.h>

#include "avo/planner.h"
#include "avo_io/errors.h"
#include "io/recording/hdf5_output.h"
#include "io/recording/hdf5_recording.h"
#include "io/recording/spool.h"

namespace avo_io {
namespace {

constexpr unsigned kDeflateLevel = 1;

/// Returns a type with the words of avo::PlanStatus, and one word for an absent robot.
Hdf5Handle status_type(const Hdf5Output& target) {
  Hdf5Handle type = target.require(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
  for (std::uint8_t k = 0; k <= static_cast<std::uint8_t>(avo::PlanStatus::detour); ++k)
    target.require(H5Tenum_insert(type.id(), avo::to_string(static_cast<avo::PlanStatus>(k)), &k));
  target.require(H5Tenum_insert(type.id(), "absent", &kAbsent));
  return type;
}

/// Creates a table with the chunks of a block.
Hdf5Handle create_table(const Hdf5Output& target, hid_t file, const char* name, hid_t type,
                        std::initializer_list<hsize_t> size, std::initializer_list<hsize_t> chunk) {
  const int rank = static_cast<int>(size.size());
  std::vector<hsize_t> most(size);
  most[0] = H5S_UNLIMITED;  // without it, a chunk could not be longer than the table
  const Hdf5Handle space =
      target.require(H5Screate_simple(rank, size.begin(), most.data()), H5Sclose);
  const Hdf5Handle layout = target.properties(H5P_DATASET_CREATE);
  target.require(H5Pset_chunk(layout.id(), rank, chunk.begin()));
  if (H5Tget_size(type) > 1) target.require(H5Pset_shuffle(layout.id()));
  target.require(H5Pset_deflate(layout.id(), kDeflateLevel));
  return target.require(
      H5Dcreate2(file, name, type, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT), H5Dclose);
}

void write_times(const Hdf5Output& target, hid_t file, const std::vector<double>& times) {
  const hsize_t size = times.size();
  const Hdf5Handle space = target.require(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Hdf5Handle layout = target.properties(H5P_DATASET_CREATE);
  const Hdf5Handle table = target.require(
      H5Dcreate2(file, "time", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
      H5Dclose);
  target.require(
      H5Dwrite(table.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times.data()));
  target.write_attribute(table.id(), "unit", "s");
}

/// The tables of all blocks, as long as the number of times.
struct Tables {
  Hdf5Handle state, status, clearance;

  Tables(const Hdf5Output& target, hid_t file, const BlockShape& shape, hsize_t times) {
    const hsize_t robots = shape.robots, width = shape.robots_of_chunk();
    state = create_table(target, file, "state", H5T_IEEE_F64LE, {times, robots, shape.columns()},
                         {kBlockTimes, width, 1});
    target.write_attribute(state.id(), "columns", shape.state->list);
    target.write_attribute(state.id(), "units", shape.state->units);
    const Hdf5Handle words = status_type(target);
    status =
        create_table(target, file, "status", words.id(), {times, robots}, {kBlockTimes, width});
    clearance = create_table(target, file, "clearance", H5T_IEEE_F32LE, {times, robots},
                             {kBlockTimes, width});
    target.write_attribute(clearance.id(), "unit", "m");
  }

  void write(const Hdf5Output& target, const CompressedBlock& block, const BlockShape& shape,
             hsize_t first) const {
    const std::string* chunk = block.chunks.data();
    const auto write_part = [&](const Hdf5Handle& table, hsize_t part, hsize_t column) {
      const hsize_t offset[3] = {first, part * shape.robots_of_chunk(), column};
      target.require(
          H5Dwrite_chunk(table.id(), H5P_DEFAULT, 0, offset, chunk->size(), chunk->data()));
      ++chunk;
    };
    for (hsize_t column = 0; column < shape.columns(); ++column)
      for (hsize_t part = 0; part < shape.parts(); ++part) write_part(state, part, column);
    for (const Hdf5Handle* table : {&status, &clearance})
      for (hsize_t part = 0; part < shape.parts(); ++part) write_part(*table, part, 0);
  }
};

/// Returns the times of the spool, and takes what its end record says.
std::vector<double> times_of(const std::string& path, RecordingHeader& header) {
  SpoolReader spool(path);
  CompressedBlock block;
  std::vector<double> times;
  while (spool.next(block)) times.insert(times.end(), block.time.begin(), block.time.end());
  header = spool.header();
  return times;
}

void write_all(const Hdf5Output& target, hid_t file, const RecordedTables& recording) {
  target.write_attribute(file, "format", kRecordingFormat);
  for (const RecordingField& field : in_parts(fields_of(recording.header)))
    std::visit([&](const auto& value) { target.write_attribute(file, field.name, value); },
               field.value);
  write_times(target, file, recording.times);
  const Tables tables(target, file, recording.shape, recording.times.size());
  CompressedBlock block;
  for (hsize_t first = 0; recording.next(block); first += kBlockTimes)
    tables.write(target, block, recording.shape, first);
}

/// A file that vanishes with its descriptor, once its name is removed. (HDF5's own in-memory files
/// have a wrong checksum as long as they are open for writing.)
struct TemporaryFile {
  std::string path = (std::filesystem::temp_directory_path() / "avo-XXXXXX").string();
  int descriptor = mkostemp(path.data(), O_CLOEXEC);

  TemporaryFile() = default;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    unlink(path.c_str());  // the name still exists if HDF5 could not open the file
    close(descriptor);
  }
  [[nodiscard]] off_t size() const { return lseek(descriptor, 0, SEEK_END); }
};

}  // namespace

std::int64_t write_hdf5(const std::string& spool, const std::string& path,
                        const std::string& name) {
  const Hdf5Output target{name};
  RecordingHeader header;
  const std::vector<double> times = times_of(spool, header);
  if (times.empty()) throw RecordingError(spool + ": found no whole block, must be one or more");
  Hdf5Handle file = target.create_file(path, true);
  SpoolReader reader(spool);
  write_all(target, file.id(), {header, reader.shape(), times, [&](CompressedBlock& block) {
                                  return reader.next(block);
                                }});
  target.finish(file);
  return static_cast<std::int64_t>(times.size());
}

std::string hdf5_bytes(const RecordedTables& recording, const std::string& name) {
  const Hdf5Output target{name};
  const TemporaryFile temporary;
  if (temporary.descriptor < 0) Hdf5Output{temporary.path}.fail();
  Hdf5Handle file = target.create_file(temporary.path, true);
  unlink(temporary.path.c_str());
  write_all(target, file.id(), recording);
  target.finish(file);
  std::string bytes(static_cast<std::size_t>(std::max<off_t>(temporary.size(), 0)), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = pread(temporary.descriptor, bytes.data() + done, bytes.size() - done,
                                static_cast<off_t>(done));
    if (count <= 0) target.fail();
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

}  // namespace avo_io
