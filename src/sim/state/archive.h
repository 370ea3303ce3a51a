// SPDX-License-Identifier: Apache-2.0
// Values as 64-bit words, the lowest byte first on every machine. One text, describe(), serves
// writing and reading.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/ranges.h"
#include "core/removed.h"
#include "planner/options.h"
#include "sim/state/saved_state.h"

namespace avo::inline sim {

inline constexpr std::size_t kWord = 8;  // bytes
inline constexpr std::size_t kPointWords = 2;

inline std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t index) {
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < kWord; ++k) {
    word |= std::to_integer<std::uint64_t>(bytes[index * kWord + k]) << (8 * k);
  }
  return word;
}

inline void put_word(std::uint64_t word, std::byte* to) {
  for (std::size_t k = 0; k < kWord; ++k) to[k] = static_cast<std::byte>(word >> (8 * k) & 0xff);
}

// Writes values after `written`, or removes them from the front of `unread`.
template <bool kReads>
struct Archive {
  std::vector<std::byte> written = {};
  std::span<const std::byte> unread = {};

  void word(std::uint64_t& value) {
    if constexpr (kReads) {
      if (unread.empty()) refuse_saved("the end of the bytes", "more of them");
      value = word_at(unread, 0);
      unread = unread.subspan(kWord);
    } else {
      written.resize(written.size() + kWord);
      put_word(value, &written[written.size() - kWord]);
    }
  }
  /// Makes room for so many entries as there are, each of so many words.
  template <typename Entry>
  void size(std::vector<Entry>& list, std::size_t words) {
    std::uint64_t count = list.size();
    word(count);
    const std::uint64_t most = unread.size() / (words * kWord);
    if (kReads && count > most)
      refuse_saved(std::to_string(count) + " entries", "at most " + std::to_string(most));
    list.resize(static_cast<std::size_t>(count));
  }
};

template <bool kReads, typename Value>
requires std::is_arithmetic_v<Value>
void describe(Archive<kReads>& archive, Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    auto word = std::bit_cast<std::uint64_t>(value);
    archive.word(word);
    value = std::bit_cast<Value>(word);
  } else {
    auto word = static_cast<std::uint64_t>(value);
    archive.word(word);
    value = static_cast<Value>(word);
    if (static_cast<std::uint64_t>(value) != word)
      refuse_saved("the number " + std::to_string(word), "one that its type has");
  }
}

template <bool kReads, typename Choice>
requires std::is_enum_v<Choice>
void describe(Archive<kReads>& archive, Choice& choice) {
  auto number = static_cast<std::underlying_type_t<Choice>>(choice);
  describe(archive, number);
  if (const Removed* gone = removed_value(kKey<Choice>, number))
    refuse("saved state: " + std::string(gone->key), std::string(gone->value),
           allowed_instead(*gone));
  if (number >= kNames<Choice>.size()) refuse_saved("an unknown choice", "a known one");
  choice = static_cast<Choice>(number);
}

// Eight letters in a word.
template <bool kReads>
void describe(Archive<kReads>& archive, std::string& text) {
  std::uint64_t count = text.size();
  archive.word(count);
  if (kReads && count > archive.unread.size())
    refuse_saved("a text of " + std::to_string(count) + " bytes", "shorter");
  text.resize(static_cast<std::size_t>(count));
  for (std::size_t first = 0; first < text.size(); first += kWord) {
    const std::span<char> letters =
        std::span(text).subspan(first, std::min(kWord, text.size() - first));
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < letters.size(); ++k)
      word |= std::uint64_t{static_cast<unsigned char>(letters[k])} << (8 * k);
    archive.word(word);
    for (std::size_t k = 0; k < letters.size(); ++k)
      letters[k] = static_cast<char>(word >> (8 * k) & 0xff);
  }
}

template <bool kReads>
void describe(Archive<kReads>& archive, Vec2& value) {
  describe(archive, value.x), describe(archive, value.y);
}

template <bool kReads>
void describe(Archive<kReads>& archive, LayerSet& layers) {
  describe(archive, layers.bits);
}

template <bool kReads, typename Value>
void describe(Archive<kReads>& archive, std::optional<Value>& optional) {
  bool is_set = optional.has_value();
  Value value = optional.value_or(Value{});
  describe(archive, is_set);
  describe(archive, value);
  if constexpr (kReads) optional = is_set ? std::optional(value) : std::nullopt;
}

template <bool kReads>
void describe(Archive<kReads>& archive, std::vector<Vec2>& points) {
  archive.size(points, kPointWords);
  for (Vec2& point : points) describe(archive, point);
}

template <bool kReads>
void describe(Archive<kReads>& archive, std::vector<TimedPlace>& places) {
  archive.size(places, 1 + kPointWords);
  for (TimedPlace& place : places) describe(archive, place.time), describe(archive, place.position);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SensingError& error) {
  describe(archive, error.position), describe(archive, error.velocity);
}

}  // namespace avo::inline sim
