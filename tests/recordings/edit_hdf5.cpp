// SPDX-License-Identifier: Apache-2.0
// Recordings changed behind the back of their writer.
#include "edit_hdf5.h"

#include <array>
#include <gtest/gtest.h>

namespace avo_test {
namespace {

using avo_io::Hdf5Handle;

/// The file itself, or a table in it.
Hdf5Handle object_in(const Hdf5Handle& file, const char* table) {
  Hdf5Handle object(H5Oopen(file.id(), table == nullptr ? "/" : table, H5P_DEFAULT), H5Oclose);
  EXPECT_TRUE(object) << table;
  return object;
}

void remove_from(const Hdf5Handle& object, const char* name) {
  if (H5Aexists(object.id(), name) > 0) {
    EXPECT_GE(H5Adelete(object.id(), name), 0);
  }
}

herr_t copy_attribute(hid_t object, const char* name, const H5A_info_t* info, void* to) {
  const Hdf5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  std::string bytes(info->data_size, '\0');
  if (H5Aread(attribute.id(), type.id(), bytes.data()) < 0) return -1;
  const Hdf5Handle copy(
      H5Acreate2(*static_cast<hid_t*>(to), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  return H5Awrite(copy.id(), type.id(), bytes.data());
}

/// The table again without some rows, laid out as it was or as `anew` says.
void make_again(const Hdf5Handle& file, const char* name, hsize_t from, hsize_t to,
                const Hdf5Handle& anew = {}) {
  const Hdf5Handle old = object_in(file, name);
  const Hdf5Handle type(H5Dget_type(old.id()), H5Tclose);
  const Hdf5Handle space(H5Dget_space(old.id()), H5Sclose);
  const Hdf5Handle before(H5Dget_create_plist(old.id()), H5Pclose);
  const Hdf5Handle& layout = anew ? anew : before;
  std::array<hsize_t, 3> size{1, 1, 1}, most{1, 1, 1};
  const int rank = H5Sget_simple_extent_dims(space.id(), size.data(), most.data());
  const std::size_t row = size[1] * size[2] * H5Tget_size(type.id());
  std::string bytes(size[0] * row, '\0');
  EXPECT_GE(H5Dread(old.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
  bytes.erase(from * row, (to - from) * row);
  size[0] -= to - from;
  const bool grows = H5Pget_layout(layout.id()) == H5D_CHUNKED;  // else no chunk may be longer
  most[0] = grows ? H5S_UNLIMITED : size[0];
  const Hdf5Handle fewer(H5Screate_simple(rank, size.data(), most.data()), H5Sclose);
  EXPECT_GE(H5Ldelete(file.id(), name, H5P_DEFAULT), 0);
  Hdf5Handle table(
      H5Dcreate2(file.id(), name, type.id(), fewer.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
      H5Dclose);
  EXPECT_GE(H5Dwrite(table.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
  hid_t target = table.id();
  EXPECT_GE(H5Aiterate2(old.id(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, copy_attribute, &target),
            0);
}

}  // namespace

Hdf5Handle open_to_edit(const std::string& h5) {
  Hdf5Handle file(H5Fopen(h5.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
  EXPECT_TRUE(file) << h5;
  return file;
}

void change_bytes(const std::string& h5, const char* table, const std::vector<hsize_t>& index,
                  hid_t type, const void* bytes) {
  const Hdf5Handle file = open_to_edit(h5), set = object_in(file, table);
  const Hdf5Handle space(H5Dget_space(set.id()), H5Sclose), one(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle stored(H5Dget_type(set.id()), H5Tclose);
  EXPECT_GE(H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, index.data()), 0);
  EXPECT_GE(
      H5Dwrite(set.id(), type < 0 ? stored.id() : type, one.id(), space.id(), H5P_DEFAULT, bytes),
      0);
}

void leave_out(const std::string& h5, hsize_t from, hsize_t to) {
  const Hdf5Handle file = open_to_edit(h5);
  for (const char* name : {"time", "state", "status", "clearance"})
    make_again(file, name, from, to);
}

void lay_out(const std::string& h5, const char* table, const Hdf5Handle& layout) {
  make_again(open_to_edit(h5), table, 0, 0, layout);
}

void set_attribute(const std::string& h5, const char* name, std::uint64_t number) {
  const Hdf5Handle file = open_to_edit(h5), space(H5Screate(H5S_SCALAR), H5Sclose);
  remove_from(file, name);
  const Hdf5Handle attribute(
      H5Acreate2(file.id(), name, H5T_STD_U64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  EXPECT_GE(H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &number), 0);
}

void set_attribute(const std::string& h5, const char* name, const std::string& text,
                   const char* table) {
  const Hdf5Handle file = open_to_edit(h5), object = object_in(file, table);
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose), type(H5Tcopy(H5T_C_S1), H5Tclose);
  EXPECT_GE(H5Tset_size(type.id(), text.size()), 0);
  EXPECT_GE(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), 0);
  remove_from(object, name);
  const Hdf5Handle attribute(
      H5Acreate2(object.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  EXPECT_GE(H5Awrite(attribute.id(), type.id(), text.data()), 0);
}

void remove_attribute(const std::string& h5, const char* name, const char* table) {
  const Hdf5Handle file = open_to_edit(h5), object = object_in(file, table);
  remove_from(object, name);
}

}  // namespace avo_test
