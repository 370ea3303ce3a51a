// SPDX-License-Identifier: Apache-2.0
// Reads recordings from HDF5 files, safe against any change of the file since it was written.
#include <algorithm>
#include <array>
#include <cerrno>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "avo_io/errors.h"
#include "io/recording/hdf5_chunks.h"
#include "io/recording/hdf5_output.h"
#include "io/recording/hdf5_recording.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

constexpr hsize_t kLargestAttribute = hsize_t{16} << 20U;
constexpr hsize_t kMostAttributes = 100'000;

/// Takes attributes that are whole numbers or texts; it leaves out others.
herr_t take_attribute(hid_t object, const char* name, const H5A_info_t* info, void* data) {
  auto& fields = *static_cast<std::vector<RecordingField>*>(data);
  if (info->data_size > kLargestAttribute || fields.size() >= kMostAttributes) return -1;
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(attribute ? H5Aget_type(attribute.id()) : H5I_INVALID_HID, H5Tclose);
  const Hdf5Handle space(attribute ? H5Aget_space(attribute.id()) : H5I_INVALID_HID, H5Sclose);
  if (!type || !space) return -1;
  const H5S_class_t extent = H5Sget_simple_extent_type(space.id());
  if (H5Tget_class(type.id()) == H5T_INTEGER && extent == H5S_SCALAR) {
    std::uint64_t number = 0;
    if (H5Aread(attribute.id(), H5T_NATIVE_UINT64, &number) < 0) return -1;
    fields.push_back({name, number});
  } else if (H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0) {
    std::string text(extent == H5S_SCALAR ? H5Tget_size(type.id()) : 0, '\0');
    if (text.size() > kLargestAttribute) return -1;
    if (!text.empty() && H5Aread(attribute.id(), type.id(), text.data()) < 0) return -1;
    fields.push_back({name, std::move(text)});
  }
  return 0;
}

/// The chunks of the writer: times, robots, columns.
constexpr std::array<hsize_t, 3> kLargestChunk{kBlockTimes, 1024, 1};

void require_format(const std::vector<RecordingField>& fields) {
  const auto format = std::find_if(fields.begin(), fields.end(), [](const RecordingField& field) {
    return field.name == "format";
  });
  const auto* found = format == fields.end() ? nullptr : std::get_if<std::string>(&format->value);
  if (found == nullptr || *found != kRecordingFormat)
    throw avo::Error(fmt::format("format: found {}, must be {}",
                                 found == nullptr ? "none" : in_quotes(*found), kRecordingFormat));
}

}  // namespace

bool is_hdf5(std::string_view begin) {
  return begin.starts_with("\x89HDF\r\n\x1a\n");
}

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path) {
  prepare_hdf5();
  file_ = {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
  if (!file_) refuse("found a file that HDF5 cannot open, cut off or damaged, must be whole");
  read_attributes();
  time_ = open_dataset("time");
  const Hdf5Handle space(time_ ? H5Dget_space(time_.id()) : H5I_INVALID_HID, H5Sclose);
  if (!space || H5Sget_simple_extent_ndims(space.id()) != 1 ||
      H5Sget_simple_extent_dims(space.id(), &times_, nullptr) < 0 || times_ == 0)
    refuse("time: found no list, must be one of all times");
  require_layout(time_, "time", {times_});
  state_ = open_table("state", {times_, shape_.robots, shape_.columns()});
  require_columns();
  status_ = open_table("status", {times_, shape_.robots});
  clearance_ = open_table("clearance", {times_, shape_.robots});
}

void Hdf5Reader::read_attributes() {
  std::vector<RecordingField> fields;
  hsize_t next = 0;
  if (H5Aiterate2(file_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &next, take_attribute, &fields) < 0)
    refuse("found attributes that HDF5 cannot read, must be those of a recording of avo");
  try {
    require_format(fields);
    header_ = header_from(from_parts(std::move(fields)));
  } catch (const avo::Error& error) {
    refuse(error.what());
  }
  shape_ = shape_of(header_);
}

void Hdf5Reader::refuse(const std::string& what) const {
  throw RecordingError(fmt::format("{}: {}", path_, what));
}

// Checks the names of the state's columns.
void Hdf5Reader::require_columns() const {
  std::vector<RecordingField> fields;
  const herr_t done =
      H5Aiterate2(state_.id(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, take_attribute, &fields);
  const auto columns = std::find_if(fields.begin(), fields.end(), [](const RecordingField& field) {
    return field.name == "columns";
  });
  const auto* found =
      done < 0 || columns == fields.end() ? nullptr : std::get_if<std::string>(&columns->value);
  const char* allowed = shape_.state->list;
  if (found == nullptr || *found != allowed)
    refuse(fmt::format("state: columns: found {}, must be {}",
                       found == nullptr ? "none" : in_quotes(*found), allowed));
}

// Opens a dataset in the file itself: a link could lead to another file.
Hdf5Handle Hdf5Reader::open_dataset(const char* name) const {
  H5L_info_t link{};
  const bool here =
      H5Lget_info(file_.id(), name, &link, H5P_DEFAULT) >= 0 && link.type == H5L_TYPE_HARD;
  return {here ? H5Dopen2(file_.id(), name, H5P_DEFAULT) : H5I_INVALID_HID, H5Dclose};
}

// Refuses a table that promises more than the bytes in the file can hold. Refuses a table with
// larger chunks than those of the writer. HDF5 allocates memory for a whole chunk even if only a
// part of it is read.
void Hdf5Reader::require_layout(const Hdf5Handle& table, const char* name,
                                const std::vector<hsize_t>& size) const {
  const Hdf5Handle layout(H5Dget_create_plist(table.id()), H5Pclose);
  const Hdf5Handle type(H5Dget_type(table.id()), H5Tclose);
  const H5D_layout_t kind = layout ? H5Pget_layout(layout.id()) : H5D_LAYOUT_ERROR;
  if (kind == H5D_VIRTUAL || H5Pget_external_count(layout.id()) != 0)
    refuse(fmt::format("{}: found rows in other files, must be in this one", name));
  const H5T_class_t numbers = type ? H5Tget_class(type.id()) : H5T_NO_CLASS;
  const bool is_number = numbers == H5T_FLOAT || numbers == H5T_INTEGER || numbers == H5T_ENUM;
  if (kind == H5D_LAYOUT_ERROR || !is_number || H5Tget_size(type.id()) > sizeof(double))
    refuse(fmt::format("{}: found another type, must be numbers of {} bytes at most", name,
                       sizeof(double)));
  hsize_t bytes = H5Tget_size(type.id());
  std::vector<hsize_t> chunk(size.size(), 1);
  if (kind == H5D_CHUNKED) {
    if (H5Pget_chunk(layout.id(), static_cast<int>(chunk.size()), chunk.data()) < 0)
      refuse(fmt::format("{}: found chunks that HDF5 cannot read, must be whole", name));
    for (std::size_t d = 0; d < chunk.size(); ++d)
      if (chunk[d] > kLargestChunk[d])
        refuse(fmt::format(
            "{}: found chunks of {}, must be of {} at most", name, fmt::join(chunk, " x "),
            fmt::join(kLargestChunk.begin(), kLargestChunk.begin() + chunk.size(), " x ")));
  }
  for (std::size_t d = 0; d < size.size(); ++d)  // chunks are whole
    bytes *= (size[d] + chunk[d] - 1) / chunk[d] * chunk[d];
  constexpr hsize_t kMostPerByte = 2000;  // deflate: 1032
  const hsize_t stored = H5Dget_storage_size(table.id());
  hsize_t in_file = 0;
  if (stored < bytes / kMostPerByte || H5Fget_filesize(file_.id(), &in_file) < 0 ||
      stored > in_file)
    refuse(fmt::format("{}: found less than the half of its rows, must be all", name));
}

// Opens a table of that size.
Hdf5Handle Hdf5Reader::open_table(const char* name, const std::vector<hsize_t>& size) const {
  Hdf5Handle table = open_dataset(name);
  const Hdf5Handle space(table ? H5Dget_space(table.id()) : H5I_INVALID_HID, H5Sclose);
  std::vector<hsize_t> found(size.size());
  if (!space || H5Sget_simple_extent_ndims(space.id()) != static_cast<int>(size.size()) ||
      H5Sget_simple_extent_dims(space.id(), found.data(), nullptr) < 0 || found != size)
    refuse(fmt::format("{}: found another table, must be one of {}", name, fmt::join(size, " x ")));
  require_layout(table, name, size);
  return table;
}

void Hdf5Reader::read_rows(const Hdf5Handle& table, hid_t type, const std::vector<hsize_t>& offset,
                           const std::vector<hsize_t>& count, void* values) const {
  const int rank = static_cast<int>(count.size());
  const Hdf5Handle rows(H5Screate_simple(rank, count.data(), nullptr), H5Sclose);
  const Hdf5Handle space(H5Dget_space(table.id()), H5Sclose);
  if (!rows || !space || !are_chunks_whole(table.id(), offset, count) ||
      H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, offset.data(), nullptr, count.data(),
                          nullptr) < 0 ||
      H5Dread(table.id(), type, rows.id(), space.id(), H5P_DEFAULT, values) < 0)
    refuse(fmt::format("found damaged rows from time {} of {} on, must be whole", first_, times_));
}

bool Hdf5Reader::next(RecordingBlock& block) {
  if (first_ == times_) return false;
  const hsize_t count = std::min<hsize_t>(kBlockTimes, times_ - first_);
  const hsize_t robots = shape_.robots;
  block.times = count;
  read_rows(time_, H5T_NATIVE_DOUBLE, {first_}, {count}, block.time.data());
  for (hsize_t column = 0; column < shape_.columns(); ++column)
    read_rows(state_, H5T_NATIVE_DOUBLE, {first_, 0, column}, {count, robots, 1},
              block.row(shape_, column, 0));
  const Hdf5Handle stored(H5Dget_type(status_.id()), H5Tclose);
  const hid_t status_type = H5Tget_class(stored.id()) == H5T_ENUM ? stored.id() : H5T_NATIVE_UINT8;
  if (H5Tget_size(status_type) != 1) refuse("status: found wide numbers, must be of one byte");
  read_rows(status_, status_type, {first_, 0}, {count, robots}, block.status.data());
  read_rows(clearance_, H5T_NATIVE_FLOAT, {first_, 0}, {count, robots}, block.clearance.data());
  first_ += count;
  return true;
}

}  // namespace avo_io
