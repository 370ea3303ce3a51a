// SPDX-License-Identifier: Apache-2.0
// Trajectories of the Pedestrian Dynamics Data Archive: the table /trajectory of an HDF5 file.
#include <algorithm>
#include <array>
#include <cstddef>
#include <fmt/format.h>
#include <hdf5.h>

#include "avo_io/errors.h"
#include "io/recording/hdf5_handle.h"
#include "io/recording/hdf5_output.h"
#include "io/recording/tracks.h"

namespace avo_io {
namespace {

constexpr const char* kTrajectory = "trajectory";
constexpr hsize_t kRowsAtOnce = 65536;
// bytes of a chunk, which is always read whole
constexpr hsize_t kLargestPart = hsize_t{64} << 20U;
constexpr hsize_t kMostInflated = 1100;  // the most bytes that deflate makes of one

/// All numbers of this row are whole in every known file.
struct ArchiveRow {
  double id, frame, x, y;
};

struct ArchiveFile {
  std::string path;
  Hdf5Handle file = {}, table = {};
  hsize_t rows = 0;

  [[noreturn]] void refuse(const std::string& what) const {
    throw RecordingError(fmt::format("{}: {}", path, what));
  }
  void open();
  void require_columns(const Hdf5Handle& type) const;
  void require_stored(const Hdf5Handle& type) const;
  [[nodiscard]] double frames_per_second() const;
  void read(hsize_t first, std::vector<ArchiveRow>& some) const;
};

bool has_table(hid_t file) {
  H5L_info_t link{};
  return H5Lexists(file, kTrajectory, H5P_DEFAULT) > 0 &&
         H5Lget_info(file, kTrajectory, &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
}

Hdf5Handle opened(const std::string& path) {
  prepare_hdf5();
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

void ArchiveFile::open() {
  file = opened(path);
  if (!file) refuse("found a file that HDF5 cannot open, cut off or damaged, must be whole");
  table = {has_table(file.id()) ? H5Dopen2(file.id(), kTrajectory, H5P_DEFAULT) : H5I_INVALID_HID,
           H5Dclose};
  const Hdf5Handle space(table ? H5Dget_space(table.id()) : H5I_INVALID_HID, H5Sclose);
  const Hdf5Handle type(table ? H5Dget_type(table.id()) : H5I_INVALID_HID, H5Tclose);
  if (!space || !type || H5Sget_simple_extent_ndims(space.id()) != 1 ||
      H5Sget_simple_extent_dims(space.id(), &rows, nullptr) < 0)
    refuse("trajectory: found no list of rows, must be one");
  if (rows > kMostTrackRows)
    refuse(fmt::format("trajectory: found {} rows, must be {} at most", rows, kMostTrackRows));
  require_columns(type);
  require_stored(type);
}

void ArchiveFile::require_columns(const Hdf5Handle& type) const {
  if (H5Tget_class(type.id()) != H5T_COMPOUND)
    refuse("trajectory: found no columns, must be id, frame, x and y");
  for (const char* name : {"id", "frame", "x", "y"}) {
    const int member = H5Tget_member_index(type.id(), name);
    const H5T_class_t kind =
        member < 0 ? H5T_NO_CLASS : H5Tget_member_class(type.id(), static_cast<unsigned>(member));
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
      refuse(fmt::format("trajectory: found no column of numbers \"{}\", must be there", name));
  }
}

// Requires that the data lie in this file, and that its bytes can hold what the table promises.
void ArchiveFile::require_stored(const Hdf5Handle& type) const {
  const Hdf5Handle layout(H5Dget_create_plist(table.id()), H5Pclose);
  const H5D_layout_t kind = layout ? H5Pget_layout(layout.id()) : H5D_LAYOUT_ERROR;
  if (kind == H5D_LAYOUT_ERROR || kind == H5D_VIRTUAL || H5Pget_external_count(layout.id()) != 0)
    refuse("trajectory: found rows in other files, must be in this one");
  const hsize_t size = H5Tget_size(type.id());
  hsize_t chunk = 1;
  if (kind == H5D_CHUNKED && (H5Pget_chunk(layout.id(), 1, &chunk) < 0 ||
                              chunk > kLargestPart / std::max<hsize_t>(size, 1)))
    refuse(fmt::format("trajectory: found chunks of {} rows, must be of {} bytes at most", chunk,
                       kLargestPart));
  if (rows / kMostInflated * size > H5Dget_storage_size(table.id()))
    refuse(fmt::format("trajectory: found bytes of a part of its {} rows, must be all", rows));
}

double ArchiveFile::frames_per_second() const {
  if (H5Aexists(table.id(), "fps") <= 0)
    refuse("trajectory: found no attribute fps, must be there");
  const Hdf5Handle rate(H5Aopen(table.id(), "fps", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(rate ? H5Aget_type(rate.id()) : H5I_INVALID_HID, H5Tclose);
  const Hdf5Handle space(rate ? H5Aget_space(rate.id()) : H5I_INVALID_HID, H5Sclose);
  double fps = 0.0;
  const H5T_class_t kind = type ? H5Tget_class(type.id()) : H5T_NO_CLASS;
  const bool number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && space &&
                      H5Sget_simple_extent_npoints(space.id()) == 1;
  if (!number || H5Aread(rate.id(), H5T_NATIVE_DOUBLE, &fps) < 0 || !(fps > 0.0 && fps <= 1e9))
    refuse(fmt::format("trajectory: fps: found {}, must be a number > 0",
                       number ? fmt::format("{}", fps) : "no number"));
  return fps;
}

void ArchiveFile::read(hsize_t first, std::vector<ArchiveRow>& some) const {
  const hsize_t count = std::min(kRowsAtOnce, rows - first);
  some.resize(count);
  const Hdf5Handle type(H5Tcreate(H5T_COMPOUND, sizeof(ArchiveRow)), H5Tclose);
  const std::array<std::pair<const char*, std::size_t>, 4> columns{
      {{"id", offsetof(ArchiveRow, id)},
       {"frame", offsetof(ArchiveRow, frame)},
       {"x", offsetof(ArchiveRow, x)},
       {"y", offsetof(ArchiveRow, y)}}};
  for (const auto& [name, offset] : columns) H5Tinsert(type.id(), name, offset, H5T_NATIVE_DOUBLE);
  const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle space(H5Dget_space(table.id()), H5Sclose);
  if (!memory || !space ||
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &first, nullptr, &count, nullptr) < 0 ||
      H5Dread(table.id(), type.id(), memory.id(), space.id(), H5P_DEFAULT, some.data()) < 0)
    refuse(
        fmt::format("trajectory: found damaged rows from {} of {} on, must be whole", first, rows));
}

}  // namespace

bool is_pedestrian_hdf5(const std::string& path) {
  const Hdf5Handle file = opened(path);
  return file && H5Aexists(file.id(), "format") <= 0 && has_table(file.id());
}

TrackTable read_pedestrian_hdf5(const std::string& path) {
  ArchiveFile archive{path};
  archive.open();
  TrackTable result{path, archive.frames_per_second(), {}};
  result.rows.reserve(archive.rows);
  std::vector<ArchiveRow> some;
  for (hsize_t first = 0; first < archive.rows; first += kRowsAtOnce) {
    archive.read(first, some);
    for (std::size_t k = 0; k < some.size(); ++k) {
      const ArchiveRow& row = some[k];
      for (const double number : {row.id, row.frame})
        if (!(number >= 0.0 && number <= 0x1p53) ||
            number != static_cast<double>(static_cast<std::int64_t>(number)))
          archive.refuse(
              fmt::format("trajectory: row {}: found id {}, frame {}, must be integers "
                          ">= 0",
                          first + k, row.id, row.frame));
      add_track_row(result, {static_cast<std::int64_t>(row.id),
                             static_cast<std::int64_t>(row.frame),
                             {row.x, row.y},
                             {}});
    }
  }
  return result;
}

}  // namespace avo_io
