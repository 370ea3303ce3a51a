// SPDX-License-Identifier: Apache-2.0
// HDF5's identifiers, closed when they go out of scope.
#pragma once
#include <hdf5.h>
#include <utility>

namespace avo_io {

class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  /// Takes ownership; less than 0: none.
  Hdf5Handle(hid_t id, herr_t (*closes)(hid_t)) : id_(id), close_(closes) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { static_cast<void>(close()); }

  [[nodiscard]] hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  /// Returns false if the object cannot be closed, e.g. on a full disk.
  [[nodiscard]] bool close() { return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

}  // namespace avo_io
