// SPDX-License-Identifier: Apache-2.0
// Common parts of everything that is written as HDF5.
#include "io/recording/hdf5_output.h"

#include <algorithm>
#include <cerrno>
#include <mutex>

#include "avo_io/errors.h"
#include "io/files/regular_file.h"

namespace avo_io {
namespace {

constexpr unsigned kMostAttributesInHeader = 65535;  // the limit of HDF5

}  // namespace

void prepare_hdf5() {
  static std::once_flag once;
  std::call_once(once, [] {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  });
}

void Hdf5Output::fail() const {
  throw FileError(errno != 0 ? with_errno(name) : name + ": HDF5 cannot write it");
}

Hdf5Handle Hdf5Output::create_file(const std::string& path, bool any_size) const {
  prepare_hdf5();
  errno = 0;
  const Hdf5Handle access = require(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (any_size) require(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_V18));
  const Hdf5Handle creation = properties(H5P_FILE_CREATE);
  // else a file with more than eight attributes keeps them in a heap, which simple readers cannot
  // read
  if (any_size) require(H5Pset_attr_phase_change(creation.id(), kMostAttributesInHeader, 0));
  return require(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose);
}

Hdf5Handle Hdf5Output::properties(hid_t kind) const {
  Hdf5Handle list = require(H5Pcreate(kind), H5Pclose);
  require(H5Pset_obj_track_times(list.id(), false));
  return list;
}

Hdf5Handle Hdf5Output::text_type(std::size_t size) const {
  Hdf5Handle type = require(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type.id(), std::max<std::size_t>(size, 1)));
  require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD));
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

void Hdf5Output::write_attribute(hid_t object, const std::string& key,
                                 const std::string& text) const {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space = require(H5Screate(text.empty() ? H5S_NULL : H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute = require(
      H5Acreate2(object, key.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!text.empty()) require(H5Awrite(attribute.id(), type.id(), text.data()));
}

void Hdf5Output::write_attribute(hid_t object, const std::string& key, std::uint64_t number) const {
  const Hdf5Handle space = require(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute =
      require(H5Acreate2(object, key.c_str(), H5T_STD_U64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
              H5Aclose);
  require(H5Awrite(attribute.id(), H5T_NATIVE_UINT64, &number));
}

}  // namespace avo_io
