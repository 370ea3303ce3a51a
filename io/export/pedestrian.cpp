// SPDX-License-Identifier: Apache-2.0
// Exports in the layout of the Pedestrian Dynamics Data Archive: one table of all rows.
#include <cerrno>
#include <cstddef>
#include <fmt/format.h>
#include <vector>

#include "io/export/area.h"
#include "io/export/target.h"
#include "io/recording/hdf5_output.h"

namespace avo_io {
namespace {

struct PedestrianRow {
  std::int64_t id, frame;
  double x, y;  // m
};
constexpr std::size_t kRowsOfChunk = 16384;
constexpr unsigned kPedestrianDeflate = 1;

class PedestrianExport final : public ExportTarget {
 public:
  PedestrianExport(const ExportPlace& place, const avo::Scenario* scenario);
  void add(const ExportedTime& moment) override;
  void finish(double fps) override;

 private:
  [[nodiscard]] Hdf5Handle row_type(hid_t number, hid_t coordinate) const;
  void write_rows();
  void write_attributes(double fps, const std::string& wkt) const;

  Hdf5Output output_;
  AreaFinder area_;
  Hdf5Handle file_, table_;
  std::vector<PedestrianRow> rows_;
  hsize_t written_ = 0;  // rows
};

Hdf5Handle PedestrianExport::row_type(hid_t number, hid_t coordinate) const {
  Hdf5Handle type = output_.require(H5Tcreate(H5T_COMPOUND, sizeof(PedestrianRow)), H5Tclose);
  output_.require(H5Tinsert(type.id(), "id", offsetof(PedestrianRow, id), number));
  output_.require(H5Tinsert(type.id(), "frame", offsetof(PedestrianRow, frame), number));
  output_.require(H5Tinsert(type.id(), "x", offsetof(PedestrianRow, x), coordinate));
  output_.require(H5Tinsert(type.id(), "y", offsetof(PedestrianRow, y), coordinate));
  return type;
}

PedestrianExport::PedestrianExport(const ExportPlace& place, const avo::Scenario* scenario)
    : output_{place.name}, area_(scenario) {
  file_ = output_.create_file(place.file.temporary(), false);
  const hsize_t none = 0, unlimited = H5S_UNLIMITED, chunk = kRowsOfChunk;
  const Hdf5Handle space = output_.require(H5Screate_simple(1, &none, &unlimited), H5Sclose);
  const Hdf5Handle layout = output_.properties(H5P_DATASET_CREATE);
  output_.require(H5Pset_chunk(layout.id(), 1, &chunk));
  output_.require(H5Pset_shuffle(layout.id()));
  output_.require(H5Pset_deflate(layout.id(), kPedestrianDeflate));
  const Hdf5Handle type = row_type(H5T_STD_I64LE, H5T_IEEE_F64LE);
  table_ = output_.require(H5Dcreate2(file_.id(), "trajectory", type.id(), space.id(), H5P_DEFAULT,
                                      layout.id(), H5P_DEFAULT),
                           H5Dclose);
}

void PedestrianExport::add(const ExportedTime& moment) {
  area_.add(moment.recorded);
  for (const avo::CheckedState& row : moment.recorded.rows) {
    rows_.push_back({row.robot, moment.frame, row.position.x, row.position.y});
    if (rows_.size() == kRowsOfChunk) write_rows();
  }
}

void PedestrianExport::write_rows() {
  const hsize_t count = rows_.size(), size = written_ + count;
  if (count == 0) return;
  errno = 0;
  output_.require(H5Dset_extent(table_.id(), &size));
  const Hdf5Handle type = row_type(H5T_NATIVE_INT64, H5T_NATIVE_DOUBLE);
  const Hdf5Handle memory = output_.require(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle space = output_.require(H5Dget_space(table_.id()), H5Sclose);
  output_.require(
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &written_, nullptr, &count, nullptr));
  output_.require(
      H5Dwrite(table_.id(), type.id(), memory.id(), space.id(), H5P_DEFAULT, rows_.data()));
  written_ = size;
  rows_.clear();
}

// Writes the text as a string of variable length: h5py reads it as a str. It would read a string of
// fixed length as bytes, and that may have no more than 64 KiB.
void PedestrianExport::write_attributes(double fps, const std::string& wkt) const {
  errno = 0;
  const Hdf5Handle scalar = output_.require(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle text = output_.require(H5Tcopy(H5T_C_S1), H5Tclose);
  output_.require(H5Tset_size(text.id(), H5T_VARIABLE));
  output_.require(H5Tset_cset(text.id(), H5T_CSET_UTF8));
  const Hdf5Handle geometry = output_.require(
      H5Acreate2(file_.id(), "wkt_geometry", text.id(), scalar.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const char* const bytes = wkt.c_str();
  output_.require(H5Awrite(geometry.id(), text.id(), static_cast<const void*>(&bytes)));
  const Hdf5Handle rate = output_.require(
      H5Acreate2(table_.id(), "fps", H5T_IEEE_F64LE, scalar.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  output_.require(H5Awrite(rate.id(), H5T_NATIVE_DOUBLE, &fps));
}

void PedestrianExport::finish(double fps) {
  write_rows();
  write_attributes(fps, area_.found().wkt);
  errno = 0;
  output_.finish(table_);
  output_.finish(file_);
}

}  // namespace

std::unique_ptr<ExportTarget> export_pedestrian(const ExportPlace& place,
                                                const avo::Scenario* scenario) {
  return std::make_unique<PedestrianExport>(place, scenario);
}

}  // namespace avo_io
