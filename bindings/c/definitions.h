// SPDX-License-Identifier: Apache-2.0
// Reads definitions of a program, which may be compiled with an older header than the library.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "core/removed.h"
#include "errors.h"

namespace avo_c {

/// The place of a definition, for messages: "robots.3".
struct Where {
  const char* list = "";
  std::size_t index = SIZE_MAX;  // none: it is no element of a list

  [[nodiscard]] std::string operator/(const char* member) const {
    std::string name(list);
    if (index != SIZE_MAX) name += "." + std::to_string(index);
    if (!name.empty()) name += ".";
    return name + member;
  }
};

/// Sizes in bytes of the definition in all released versions; the last one is the present one. A
/// version that appends members specializes this for the definition that grows: the sizes until
/// then, then sizeof(Def). The new members begin after the padding of the older definition, which
/// programs leave unset.
template <typename Def>
inline constexpr std::array kReleasedSizes{sizeof(Def)};

/// Size of the definition in bytes. Throws Failure if no version has this size.
template <typename Def>
std::size_t size_of(const Def* def, const Where& where) {
  constexpr auto& kSizes = kReleasedSizes<Def>;
  static_assert(kSizes.back() == sizeof(Def));
  std::size_t size = 0;
  std::memcpy(&size, &at(def, where.list), sizeof size);
  if (std::find(kSizes.begin(), kSizes.end(), size) == kSizes.end())
    fail(AVO_ERROR_INVALID_DEFINITION, where / "size" + ": found " + std::to_string(size) +
                                           ", must be what avo_default_*() sets, " +
                                           std::to_string(sizeof(Def)) + " bytes in this version");
  return size;
}

/// The definition; members beyond its size are those of `defaults`.
template <typename Def>
Def read(const Def* def, const Where& where, Def defaults) {
  std::memcpy(&defaults, def, size_of(def, where));
  defaults.size = sizeof(Def);
  return defaults;
}

/// Writes the members of `from` that the program knows.
template <typename Def>
void write(Def* to, const Def& from, const Where& where) {
  const std::size_t size = size_of(to, where);
  std::memcpy(to, &from, size);
  to->size = size;
}

/// Calls take(definition, where) for each element of an array of definitions.
template <typename Def, typename Take>
void for_each(const Def* defs, std::size_t count, const char* list, const Def& defaults,
              const Take& take) {
  require_array(defs, count, list);
  if (count == 0) return;
  const std::size_t stride = size_of(defs, {list, 0});
  const auto* bytes = reinterpret_cast<const std::byte*>(defs);
  for (std::size_t k = 0; k < count; ++k, bytes += stride) {
    const Where where{list, k};
    const Def* def = reinterpret_cast<const Def*>(bytes);
    if (size_of(def, where) != stride)
      fail(AVO_ERROR_INVALID_DEFINITION,
           where / "size" + ": found another one than the first definition's, must be " +
               std::to_string(stride));
    take(read(def, where, defaults), where);
  }
}

/// Refuses a number in the place of a removed member, which programs compiled earlier may set.
inline void require_unused(std::int32_t number, const Where& where, const char* removed) {
  if (number != 0)
    fail(AVO_ERROR_INVALID_VALUE,
         where / removed + ": found " + std::to_string(number) +
             ", must be 0: " + std::string(avo::removed_key(removed)->instead));
}

/// The enumerator with that number, out of `count`. Throws Failure.
template <typename Word>
Word word(std::int32_t number, std::int32_t count, const Where& where, const char* member) {
  if (const avo::Removed* gone = avo::removed_value(member, number))
    fail(AVO_ERROR_INVALID_VALUE, where / member + ": found " + std::to_string(number) + " (" +
                                      std::string(gone->value) + "), must be " +
                                      allowed_instead(*gone));
  if (number < 0 || number >= count)
    fail(AVO_ERROR_INVALID_VALUE, where / member + ": found " + std::to_string(number) +
                                      ", must be 0 to " + std::to_string(count - 1));
  return static_cast<Word>(number);
}

}  // namespace avo_c
