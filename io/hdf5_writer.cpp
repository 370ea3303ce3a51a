// SPDX-License-Identifier: Apache-2.0
// Recordings as HDF5 files: written from a spool, whose compressed chunks are copied.
#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <initializer_list>

#include "avo/planner.h"
#include "hdf5_recording.h"
#include "regular_file.h"
#include "spool.h"

namespace avo_io {
namespace {

constexpr unsigned kDeflateLevel = 1;

/// What is written where, and under which name messages tell of it.
struct Hdf5Target {
  const std::string& name;

  [[noreturn]] void fail() const {
    throw FileError(errno != 0 ? with_errno(name) : name + ": HDF5 cannot write it");
  }
  void require(herr_t result) const {
    if (result < 0) fail();
  }
  Hdf5Handle require(hid_t id, herr_t (*close)(hid_t)) const {
    if (id < 0) fail();
    return {id, close};
  }
};

Hdf5Handle text_type(const Hdf5Target& target, std::size_t size) {
  Hdf5Handle type = target.require(H5Tcopy(H5T_C_S1), H5Tclose);
  target.require(H5Tset_size(type.id(), size));
  target.require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  target.require(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

void write_attribute(const Hdf5Target& target, hid_t object, const std::string& name,
                     const std::string& text) {
  const Hdf5Handle type = text_type(target, std::max<std::size_t>(text.size(), 1));
  const Hdf5Handle space =
      target.require(H5Screate(text.empty() ? H5S_NULL : H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute = target.require(
      H5Acreate2(object, name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!text.empty()) target.require(H5Awrite(attribute.id(), type.id(), text.data()));
}

void write_attribute(const Hdf5Target& target, hid_t object, const std::string& name,
                     std::uint64_t number) {
  const Hdf5Handle space = target.require(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute = target.require(
      H5Acreate2(object, name.c_str(), H5T_STD_U64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  target.require(H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &number));
}

/// The words of avo::PlanStatus, and one for who is not there.
Hdf5Handle status_type(const Hdf5Target& target) {
  Hdf5Handle type = target.require(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
  for (std::uint8_t k = 0; k <= static_cast<std::uint8_t>(avo::PlanStatus::invalid_input); ++k)
    target.require(H5Tenum_insert(type.id(), avo::to_string(static_cast<avo::PlanStatus>(k)), &k));
  target.require(H5Tenum_insert(type.id(), "absent", &kAbsent));
  return type;
}

/// A table whose chunks are a block's.
Hdf5Handle create_table(const Hdf5Target& target, hid_t file, const char* name, hid_t type,
                        std::initializer_list<hsize_t> size, std::initializer_list<hsize_t> chunk) {
  const int rank = static_cast<int>(size.size());
  std::vector<hsize_t> most(size);
  most[0] = H5S_UNLIMITED;  // else a chunk could not be longer than the table
  const Hdf5Handle space =
      target.require(H5Screate_simple(rank, size.begin(), most.data()), H5Sclose);
  const Hdf5Handle layout = target.require(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  target.require(H5Pset_chunk(layout.id(), rank, chunk.begin()));
  if (H5Tget_size(type) > 1) target.require(H5Pset_shuffle(layout.id()));
  target.require(H5Pset_deflate(layout.id(), kDeflateLevel));
  target.require(H5Pset_obj_track_times(layout.id(), false));
  return target.require(
      H5Dcreate2(file, name, type, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT), H5Dclose);
}

void write_times(const Hdf5Target& target, hid_t file, const std::vector<double>& times) {
  const hsize_t size = times.size();
  const Hdf5Handle space = target.require(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Hdf5Handle layout = target.require(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  target.require(H5Pset_obj_track_times(layout.id(), false));
  const Hdf5Handle table = target.require(
      H5Dcreate2(file, "time", H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
      H5Dclose);
  target.require(
      H5Dwrite(table.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, times.data()));
  write_attribute(target, table.id(), "unit", "s");
}

/// The tables of all blocks, as long as there are times.
struct Tables {
  Hdf5Handle state, status, clearance;

  Tables(const Hdf5Target& target, hid_t file, const BlockShape& shape, hsize_t times) {
    const hsize_t robots = shape.robots, width = shape.robots_of_chunk();
    state = create_table(target, file, "state", H5T_IEEE_F64LE, {times, robots, shape.columns},
                         {kBlockTimes, width, 1});
    write_attribute(target, state.id(), "columns",
                    shape.columns == kHeadingColumns ? "x,y,vx,vy,heading,speed" : "x,y,vx,vy");
    write_attribute(target, state.id(), "units",
                    shape.columns == kHeadingColumns ? "m,m,m/s,m/s,rad,m/s" : "m,m,m/s,m/s");
    const Hdf5Handle words = status_type(target);
    status =
        create_table(target, file, "status", words.id(), {times, robots}, {kBlockTimes, width});
    clearance = create_table(target, file, "clearance", H5T_IEEE_F32LE, {times, robots},
                             {kBlockTimes, width});
    write_attribute(target, clearance.id(), "unit", "m");
  }

  void write(const Hdf5Target& target, const CompressedBlock& block, const BlockShape& shape,
             hsize_t first) const {
    const std::string* chunk = block.chunks.data();
    const auto write_part = [&](const Hdf5Handle& table, hsize_t part, hsize_t column) {
      const hsize_t offset[3] = {first, part * shape.robots_of_chunk(), column};
      target.require(
          H5Dwrite_chunk(table.id(), H5P_DEFAULT, 0, offset, chunk->size(), chunk->data()));
      ++chunk;
    };
    for (hsize_t column = 0; column < shape.columns; ++column)
      for (hsize_t part = 0; part < shape.parts(); ++part) write_part(state, part, column);
    for (const Hdf5Handle* table : {&status, &clearance})
      for (hsize_t part = 0; part < shape.parts(); ++part) write_part(*table, part, 0);
  }
};

/// How many times the spool has, and what its end says.
std::vector<double> times_of(const std::string& path, RecordingHeader& header) {
  SpoolReader spool(path);
  CompressedBlock block;
  std::vector<double> times;
  while (spool.next(block)) times.insert(times.end(), block.time.begin(), block.time.end());
  header = spool.header();
  return times;
}

}  // namespace

std::int64_t write_hdf5(const std::string& spool, const std::string& path,
                        const std::string& name) {
  const Hdf5Target target{name};
  prepare_hdf5();
  RecordingHeader header;
  const std::vector<double> times = times_of(spool, header);
  if (times.empty()) throw RecordingError(spool + ": found no whole block, must be one or more");
  errno = 0;
  const Hdf5Handle access = target.require(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // attributes of any size, and a checksum of all that is not data
  target.require(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18));
  const Hdf5Handle creation = target.require(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  target.require(H5Pset_obj_track_times(creation.id(), false));  // equal runs have equal bytes
  Hdf5Handle file =
      target.require(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
  write_attribute(target, file.id(), "format", "avo recording 1");
  for (const RecordingField& field : fields_of(header))
    std::visit([&](const auto& value) { write_attribute(target, file.id(), field.name, value); },
               field.value);
  write_times(target, file.id(), times);
  {
    SpoolReader reader(spool);
    const Tables tables(target, file.id(), reader.shape(), times.size());
    CompressedBlock block;
    for (hsize_t first = 0; reader.next(block); first += kBlockTimes)
      tables.write(target, block, reader.shape(), first);
  }
  if (!file.close()) target.fail();
  return static_cast<std::int64_t>(times.size());
}

}  // namespace avo_io
