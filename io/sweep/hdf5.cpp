// SPDX-License-Identifier: Apache-2.0
// Tables of sweeps in HDF5 files: a group per table, a dataset per column.
#include "io/sweep/hdf5.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <system_error>
#include <unistd.h>

#include "core/ranges.h"
#include "io/files/regular_file.h"
#include "io/recording/hdf5_output.h"

namespace avo_io {
namespace {

enum class ColumnKind : std::uint8_t { whole, number, text };

std::optional<std::uint64_t> whole_in(const std::string& field) {
  std::uint64_t value = 0;
  const char* const last = field.data() + field.size();
  const auto [end, error] = std::from_chars(field.data(), last, value);
  if (error != std::errc() || end != last || fmt::format("{}", value) != field) return std::nullopt;
  return value;
}

/// Returns the kind of the column, such that every field reads back unchanged.
ColumnKind kind_of(const SweepTable& table, std::size_t column) {
  const auto all = [&](const auto& fits) {
    return std::all_of(table.rows.begin(), table.rows.end(),
                       [&](const auto& row) { return fits(row[column]); });
  };
  if (all([](const std::string& field) { return whole_in(field).has_value(); }))
    return ColumnKind::whole;
  const auto is_exact = [](const std::string& field) {
    const std::optional<double> value = number_in(field);
    return field.empty() || (value && std::isfinite(*value) && avo::text(*value) == field);
  };
  return all(is_exact) ? ColumnKind::number : ColumnKind::text;
}

class SweepWriter {
 public:
  explicit SweepWriter(const std::string& name) : output_{name} {}

  void write(const SweepTable& runs, const std::string& path) {
    Hdf5Handle file = output_.create_file(path, true);
    output_.write_attribute(file.id(), "format", "avo sweep 1");
    table(file.id(), "runs", runs);
    table(file.id(), "summary", summary_of(runs));
    output_.finish(file);
  }

 private:
  void table(hid_t file, const char* name, const SweepTable& rows) const {
    const Hdf5Handle creation = output_.properties(H5P_GROUP_CREATE);
    const Hdf5Handle group =
        output_.require(H5Gcreate2(file, name, H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
    output_.write_attribute(group.id(), "columns",
                            fmt::format("{}", fmt::join(rows.columns, "\n")));
    for (std::size_t c = 0; c < rows.columns.size(); ++c) column(group.id(), rows, c);
  }

  void column(hid_t group, const SweepTable& table, std::size_t c) const {
    switch (kind_of(table, c)) {
      case ColumnKind::whole: {
        std::vector<std::uint64_t> values;
        for (const auto& row : table.rows) values.push_back(*whole_in(row[c]));
        dataset(group, table, c, H5T_STD_U64LE, H5T_NATIVE_UINT64, values.data());
        return;
      }
      case ColumnKind::number: {
        std::vector<double> values;
        for (const auto& row : table.rows)
          values.push_back(number_in(row[c]).value_or(std::numeric_limits<double>::quiet_NaN()));
        dataset(group, table, c, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values.data());
        return;
      }
      case ColumnKind::text:
        break;
    }
    std::size_t width = 1;
    for (const auto& row : table.rows) width = std::max(width, row[c].size());
    std::string texts;
    for (const auto& row : table.rows) texts += row[c] + std::string(width - row[c].size(), '\0');
    const Hdf5Handle type = output_.text_type(width);
    dataset(group, table, c, type.id(), type.id(), texts.data());
  }

  void dataset(hid_t group, const SweepTable& table, std::size_t c, hid_t stored, hid_t given,
               const void* values) const {
    const hsize_t size = table.rows.size();
    const Hdf5Handle space = output_.require(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Hdf5Handle creation = output_.properties(H5P_DATASET_CREATE);
    const Hdf5Handle created =
        output_.require(H5Dcreate2(group, table.columns[c].c_str(), stored, space.id(), H5P_DEFAULT,
                                   creation.id(), H5P_DEFAULT),
                        H5Dclose);
    if (size > 0)
      output_.require(H5Dwrite(created.id(), given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  }

  Hdf5Output output_;
};

class SweepHdf5Reader {
 public:
  explicit SweepHdf5Reader(const std::string& path) : path_(path) {}

  SweepTable read() {
    if (access(path_.c_str(), R_OK) != 0) throw FileError(with_errno(path_));
    const Hdf5Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    const Hdf5Handle group(file ? H5Gopen2(file.id(), "runs", H5P_DEFAULT) : H5I_INVALID_HID,
                           H5Gclose);
    if (!group || H5Fget_filesize(file.id(), &bytes_left_) < 0) refuse();
    SweepTable table;
    const std::string names = columns_of(group.id());
    for (std::size_t at = 0; at <= names.size();) {
      const std::size_t end = std::min(names.find('\n', at), names.size());
      table.columns.push_back(names.substr(at, end - at));
      at = end + 1;
    }
    for (std::size_t c = 0; c < table.columns.size(); ++c) read_column(group.id(), c, table);
    return table;
  }

 private:
  static constexpr std::size_t kLargestSweepText = 1 << 20;

  [[noreturn]] void refuse() const {
    throw RecordingError(path_ + ": found no table that avo sweep wrote as HDF5, or a damaged one");
  }

  [[nodiscard]] std::string columns_of(hid_t group) const {
    const Hdf5Handle attribute(H5Aopen(group, "columns", H5P_DEFAULT), H5Aclose);
    const Hdf5Handle type(attribute ? H5Aget_type(attribute.id()) : H5I_INVALID_HID, H5Tclose);
    const bool is_text = type && H5Tget_class(type.id()) == H5T_STRING &&
                         H5Tis_variable_str(type.id()) == 0 &&
                         H5Aget_storage_size(attribute.id()) == H5Tget_size(type.id());
    std::string text(is_text ? H5Tget_size(type.id()) : 0, '\0');
    if (!is_text || text.size() > kLargestSweepText ||
        H5Aread(attribute.id(), type.id(), text.data()) < 0)
      refuse();
    return text;
  }

  template <class Value>
  void take(hid_t column, hid_t type, std::size_t c, SweepTable& table) const {
    std::vector<Value> values(table.rows.size());
    if (H5Dread(column, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) refuse();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if constexpr (std::is_same_v<Value, double>)
        table.rows[i][c] = std::isnan(values[i]) ? "" : avo::text(values[i]);
      else
        table.rows[i][c] = fmt::format("{}", values[i]);
    }
  }

  void take_texts(hid_t column, hid_t type, std::size_t c, SweepTable& table) const {
    const std::size_t width = H5Tget_size(type);
    if (H5Tis_variable_str(type) != 0 || width > kLargestSweepText) refuse();
    std::string texts(width * table.rows.size(), '\0');
    if (H5Dread(column, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) < 0) refuse();
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      table.rows[i][c] = texts.substr(i * width, width).c_str();  // up to the padding
  }

  // Refuses columns that together promise more bytes than the file has, before memory is allocated
  // for them.
  void take_bytes(hid_t column, hid_t type, hsize_t size) {
    const Hdf5Handle layout(H5Dget_create_plist(column), H5Pclose);
    const hsize_t bytes = H5Dget_storage_size(column);
    if (!layout || H5Pget_layout(layout.id()) != H5D_CONTIGUOUS ||
        H5Pget_external_count(layout.id()) != 0 || bytes != size * H5Tget_size(type) ||
        bytes > bytes_left_)
      refuse();
    bytes_left_ -= bytes;
  }

  void read_column(hid_t group, std::size_t c, SweepTable& table) {
    H5L_info_t link{};  // in the file itself: a link could lead to another file
    const char* const name = table.columns[c].c_str();
    if (H5Lget_info(group, name, &link, H5P_DEFAULT) < 0 || link.type != H5L_TYPE_HARD) refuse();
    const Hdf5Handle column(H5Dopen2(group, name, H5P_DEFAULT), H5Dclose);
    const Hdf5Handle space(column ? H5Dget_space(column.id()) : H5I_INVALID_HID, H5Sclose);
    const Hdf5Handle type(column ? H5Dget_type(column.id()) : H5I_INVALID_HID, H5Tclose);
    hsize_t size = 0;
    if (!space || !type || H5Sget_simple_extent_ndims(space.id()) != 1 ||
        H5Sget_simple_extent_dims(space.id(), &size, nullptr) < 0 ||
        size > static_cast<hsize_t>(kMostSweepRuns))
      refuse();
    if (c == 0 && size * table.columns.size() > bytes_left_) refuse();
    if (size > 0) take_bytes(column.id(), type.id(), size);
    if (c == 0) table.rows.assign(size, std::vector<std::string>(table.columns.size()));
    if (size != table.rows.size()) refuse();
    if (size == 0) return;
    const H5T_class_t kind = H5Tget_class(type.id());
    if (kind == H5T_INTEGER)
      take<std::uint64_t>(column.id(), H5T_NATIVE_UINT64, c, table);
    else if (kind == H5T_FLOAT)
      take<double>(column.id(), H5T_NATIVE_DOUBLE, c, table);
    else if (kind == H5T_STRING)
      take_texts(column.id(), type.id(), c, table);
    else
      refuse();
  }

  const std::string& path_;
  hsize_t bytes_left_ = 0;  // bytes of the file for columns that are not read yet
};

}  // namespace

void write_sweep_hdf5(const SweepTable& runs, const std::string& path, const std::string& name) {
  SweepWriter(name).write(runs, path);
}

bool is_sweep_hdf5(const std::string& path) {
  prepare_hdf5();
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  return file && H5Lexists(file.id(), "runs", H5P_DEFAULT) > 0;
}

SweepTable read_sweep_hdf5(const std::string& path) {
  prepare_hdf5();
  return SweepHdf5Reader(path).read();
}

}  // namespace avo_io
