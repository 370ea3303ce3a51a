// SPDX-License-Identifier: Apache-2.0
// Common parts of everything that is written as HDF5: its errors, its texts, and equal bytes for
// equal contents.
#pragma once
#include <cstdint>
#include <string>

#include "io/recording/hdf5_handle.h"

namespace avo_io {

/// Prepares HDF5; call it before any other use. HDF5 then prints nothing and does nothing at the
/// end of the process. Otherwise it would write again then what a full disk has refused.
void prepare_hdf5();

/// An output file; `name` is its name in messages. Failures throw FileError.
struct Hdf5Output {
  std::string name;

  [[noreturn]] void fail() const;
  void require(herr_t result) const {
    if (result < 0) fail();
  }
  [[nodiscard]] Hdf5Handle require(hid_t id, herr_t (*close)(hid_t)) const {
    if (id < 0) fail();
    return {id, close};
  }

  /// Empties the file at `path`. `any_size`: attributes may have more than 64 KiB, which HDF5 reads
  /// from version 1.8 on. Shorter attributes of the file itself are then in its header, however
  /// many.
  [[nodiscard]] Hdf5Handle create_file(const std::string& path, bool any_size) const;
  /// Returns properties of a kind of object, H5P_DATASET_CREATE or H5P_GROUP_CREATE, without the
  /// time of day.
  [[nodiscard]] Hdf5Handle properties(hid_t kind) const;
  /// Returns the type of texts of `size` bytes, padded with zeros.
  [[nodiscard]] Hdf5Handle text_type(std::size_t size) const;
  void write_attribute(hid_t object, const std::string& key, const std::string& text) const;
  void write_attribute(hid_t object, const std::string& key, std::uint64_t number) const;
  /// Writes the rest. Throws if the disk is full.
  void finish(Hdf5Handle& handle) const {
    if (!handle.close()) fail();
  }
};

}  // namespace avo_io
