// SPDX-License-Identifier: Apache-2.0
// Values that are made at the first request.
#pragma once
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace avo::inline core {

/// One value for each of a number of places. Several threads may request it at once: the first one
/// to finish stores its value, so make() must return the same for all.
template <typename T>
class Memo {
 public:
  Memo() = default;
  explicit Memo(std::size_t size)
      : size_(size), values_(std::make_unique<std::atomic<const T*>[]>(size)) {}
  Memo(Memo&& other) noexcept
      : size_(std::exchange(other.size_, 0)), values_(std::move(other.values_)) {}
  Memo& operator=(Memo&& other) noexcept {
    std::swap(size_, other.size_), std::swap(values_, other.values_);
    return *this;
  }
  ~Memo() {
    for (std::size_t k = 0; k < size_; ++k) delete values_[k].load(std::memory_order_relaxed);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// None before the first request.
  [[nodiscard]] const T* known(std::size_t k) const {
    return values_[k].load(std::memory_order_acquire);
  }
  template <typename Make>
  const T& get(std::size_t k, const Make& make) const {
    const T* value = known(k);
    if (value != nullptr) return *value;
    auto made = std::make_unique<const T>(make());
    if (values_[k].compare_exchange_strong(value, made.get(), std::memory_order_acq_rel))
      return *made.release();
    return *value;
  }
  /// There must be no request at the same time.
  void put(std::size_t k, std::unique_ptr<const T> value) {
    delete values_[k].exchange(value.release(), std::memory_order_acq_rel);
  }

 private:
  std::size_t size_ = 0;
  std::unique_ptr<std::atomic<const T*>[]> values_;
};

}  // namespace avo::inline core
