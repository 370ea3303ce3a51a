// SPDX-License-Identifier: Apache-2.0
// What everything that is written as HDF5 has in common: how it fails, how texts are kept, and that
// equal contents have equal bytes.
#pragma once
#include <cstdint>
#include <string>

#include "io/recording/hdf5_handle.h"

namespace avo_io {

/// Before any other use of HDF5: it prints nothing, and does nothing at the end of the process,
/// when it would write once more what a full disk has refused.
void prepare_hdf5();

/// A file that is written; `name` is what messages call it. What fails throws FileError.
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
  /// from 1.8 on.
  [[nodiscard]] Hdf5Handle create_file(const std::string& path, bool any_size) const;
  /// Of a kind of object, H5P_DATASET_CREATE or H5P_GROUP_CREATE: without the time of day.
  [[nodiscard]] Hdf5Handle properties(hid_t kind) const;
  /// Texts of `size` bytes, filled up with zeros.
  [[nodiscard]] Hdf5Handle text_type(std::size_t size) const;
  void write_attribute(hid_t object, const std::string& key, const std::string& text) const;
  void write_attribute(hid_t object, const std::string& key, std::uint64_t number) const;
  /// What is left to write. Throws where the disk is full.
  void finish(Hdf5Handle& handle) const {
    if (!handle.close()) fail();
  }
};

}  // namespace avo_io
