// SPDX-License-Identifier: Apache-2.0
// Definitions of programs that are older than the library, on one that has grown twice.
#include <cstring>

#include "check.h"
#include "definitions.h"

namespace {

struct Grown {
  std::size_t size;
  double first;
  double second;  // since the second version
  double third;   // since the third
};
constexpr std::size_t kFirst = offsetof(Grown, second), kSecond = offsetof(Grown, third);
constexpr Grown kDefaults{sizeof(Grown), 1.0, 2.0, 3.0};

}  // namespace

template <>
inline constexpr std::array avo_c::kReleasedSizes<Grown>{kFirst, kSecond, sizeof(Grown)};

namespace {

// Beyond its size a definition of a program has bytes of other things.
Grown given(std::size_t size) {
  Grown def{};
  std::memset(static_cast<void*>(&def), 0xee, sizeof def);
  const Grown all{size, 11.0, 12.0, 13.0};
  std::memcpy(&def, &all, std::min(size, sizeof def));
  return def;
}

void check_members_beyond_have_defaults() {
  for (const std::size_t size : {kFirst, kSecond, sizeof(Grown)}) {
    const Grown def = given(size), read = avo_c::read(&def, {"def"}, kDefaults);
    CHECK(read.size == sizeof(Grown) && read.first == 11.0);
    CHECK(read.second == (size >= kSecond ? 12.0 : 2.0));
    CHECK(read.third == (size == sizeof(Grown) ? 13.0 : 3.0));
  }
}

void check_what_is_told_is_cut() {
  for (const std::size_t size : {kFirst, kSecond, sizeof(Grown)}) {
    Grown def = given(size);
    const Grown before = def;
    avo_c::write(&def, kDefaults, {"def"});
    CHECK(def.size == size && def.first == 1.0);
    const std::size_t beyond = sizeof def - size;
    CHECK(std::memcmp(reinterpret_cast<char*>(&def) + size,
                      reinterpret_cast<const char*>(&before) + size, beyond) == 0);
  }
}

// One close behind the other, as the older program has them.
void check_arrays_have_their_own_stride() {
  alignas(Grown) std::byte defs[3 * kSecond];
  for (std::size_t k = 0; k < 3; ++k) {
    const Grown def{kSecond, 10.0 * static_cast<double>(k), 5.0, 0.0};
    std::memcpy(defs + k * kSecond, &def, kSecond);
  }
  int count = 0;
  const auto take = [&](const Grown& def, const avo_c::Where&) {
    CHECK(def.first == 10.0 * count++ && def.second == 5.0 && def.third == 3.0);
  };
  const auto* first = reinterpret_cast<const Grown*>(defs);
  const auto all = [&] { avo_c::for_each(first, 3, "defs", kDefaults, take); };
  CHECK(avo_c::guarded(all) == AVO_OK && count == 3);
  std::memcpy(defs + 2 * kSecond, &kFirst, sizeof kFirst);
  count = 0;
  REFUSES(avo_c::guarded(all), AVO_ERROR_INVALID_DEFINITION,
          "defs.2.size: found another one than the first definition's, must be 24");
}

void check_sizes_between_are_none() {
  for (std::size_t size = 0; size <= 2 * sizeof(Grown); ++size) {
    const Grown def = given(size);
    const auto result = avo_c::guarded([&] { avo_c::read(&def, {"def"}, kDefaults); });
    const bool released = size == kFirst || size == kSecond || size == sizeof(Grown);
    CHECK(result == (released ? AVO_OK : AVO_ERROR_INVALID_DEFINITION));
  }
}

}  // namespace

int main() {
  check_members_beyond_have_defaults();
  check_what_is_told_is_cut();
  check_arrays_have_their_own_stride();
  check_sizes_between_are_none();
  return 0;
}
