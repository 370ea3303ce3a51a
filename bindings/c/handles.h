// SPDX-License-Identifier: Apache-2.0
// Objects by id. An id is the place of an object in a table and the generation of that place. The
// id of a destroyed object differs from that of the next object in its place.
#pragma once
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "errors.h"

// Tables are there before any code runs. A mutex of mingw-w64 has no constant initializer, so that
// tables are made there when the library is loaded.
#if defined(__MINGW32__)
#define AVO_C_CONSTINIT
#else
#define AVO_C_CONSTINIT constinit
#endif

namespace avo_c {

/// Id is a struct of index (from 1; 0: null) and generation. Finding an object takes no lock and
/// two reads: places never move.
template <typename Id, typename Object>
class Handles {
 public:
  /// what: the name in messages, e.g. "simulation".
  constexpr explicit Handles(const char* what) : what_(what) {}
  ~Handles() {
    for (std::atomic<Place*>& block : blocks_) delete[] block.load(std::memory_order_relaxed);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  Id add(std::unique_ptr<Object> object) {
    const std::lock_guard lock(changing_);
    if (free_.empty()) grow();
    const std::uint32_t index = free_.back();
    free_.pop_back();
    Place& place = *find_place(index);
    place.object = std::move(object);
    place.is_used.store(true, std::memory_order_release);
    return Id{index + 1, place.generation.load(std::memory_order_relaxed)};
  }

  /// Throws Failure if there is no such object.
  Object& at(Id id) const {
    if (Object* object = find(id)) return *object;
    const bool is_null = id.index == 0 && id.generation == 0;
    fail(AVO_ERROR_INVALID_ID, std::string(what_) + ": found " +
                                   (is_null ? "a null id" : "an id of none that there is") +
                                   ", must be one that was created and not destroyed");
  }

  /// None where the id is null or stale.
  Object* find(Id id) const {
    if (id.index == 0) return nullptr;
    const Place* place = find_place(id.index - 1);
    if (place == nullptr || !place->is_used.load(std::memory_order_acquire)) return nullptr;
    if (place->generation.load(std::memory_order_relaxed) != id.generation) return nullptr;
    return place->object.get();
  }

  /// Removes the object; it is destroyed with the result. Throws Failure if there is no such
  /// object.
  std::unique_ptr<Object> take(Id id) {
    const std::lock_guard lock(changing_);
    static_cast<void>(at(id));
    Place& place = *find_place(id.index - 1);
    place.is_used.store(false, std::memory_order_release);
    const std::uint32_t generation = place.generation.load(std::memory_order_relaxed);
    place.generation.store(generation + 1, std::memory_order_relaxed);
    // a place with no generations left is not used again
    if (generation < std::numeric_limits<std::uint32_t>::max()) free_.push_back(id.index - 1);
    return std::move(place.object);
  }

 private:
  struct Place {
    std::atomic<bool> is_used = false;
    std::atomic<std::uint32_t> generation = 1;
    std::unique_ptr<Object> object;
  };
  static constexpr std::size_t kPlaces = 256;    // of a block
  static constexpr std::size_t kBlocks = 1'024;  // 2^18 objects at the same time

  Place* find_place(std::uint32_t index) const {
    if (index / kPlaces >= kBlocks) return nullptr;
    Place* block = blocks_[index / kPlaces].load(std::memory_order_acquire);
    return block == nullptr ? nullptr : block + index % kPlaces;
  }

  void grow() {
    if (count_ == kBlocks)
      fail(AVO_ERROR_OUT_OF_MEMORY, std::string(what_) +
                                        ": found too many at the same time, must be " +
                                        std::to_string(kBlocks * kPlaces) + " at most");
    // room for all places, so that take() does not allocate
    free_.reserve((count_ + 1) * kPlaces);
    blocks_[count_].store(new Place[kPlaces], std::memory_order_release);
    for (std::size_t k = kPlaces; k > 0; --k)
      free_.push_back(static_cast<std::uint32_t>(count_ * kPlaces + k - 1));
    ++count_;
  }

  const char* what_;
  std::mutex changing_;
  std::vector<std::uint32_t> free_;
  std::size_t count_ = 0;  // blocks
  std::array<std::atomic<Place*>, kBlocks> blocks_ = {};
};

}  // namespace avo_c
