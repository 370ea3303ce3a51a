// SPDX-License-Identifier: Apache-2.0
// Makes text of unknown origin safe for a terminal.
#include "avo_io/printable.h"

#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <vector>

#include "io/text/utf8.h"

namespace avo_io {
namespace {

/// Splits text into characters of UTF-8, and bytes that belong to none.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> characters;
  while (!text.empty()) {
    characters.push_back(text.substr(0, std::max<std::size_t>(character_length(text), 1)));
    text.remove_prefix(characters.back().size());
  }
  return characters;
}

/// Returns whether the character is only displayed, and does not affect the place or the look of
/// other text.
bool is_plain(std::string_view character) {
  const auto is_from_to = [character](std::string_view first, std::string_view last) {
    return character.size() == first.size() && first <= character && character <= last;
  };
  if (character_length(character) == 0) return false;
  return !(is_from_to({"\0", 1}, "\x1F") || character == "\x7F" ||
           is_from_to("\xC2\x80", "\xC2\x9F") ||          // C1
           is_from_to("\xE2\x80\xA8", "\xE2\x80\xAE") ||  // line ends, direction of writing
           is_from_to("\xE2\x81\xA6", "\xE2\x81\xA9"));   // direction of writing
}

void append(std::string& shown, std::span<const std::string_view> characters) {
  for (const std::string_view character : characters) {
    if (is_plain(character))
      shown += character;
    else if (character == "\n")
      shown += "\\n";
    else
      for (const char byte : character)
        shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  const std::vector<std::string_view> characters = split(text);
  const std::span all(characters);
  std::string shown;
  if (all.size() <= most) {
    append(shown, all);
    return shown;
  }
  const std::size_t last = most / 4;
  append(shown, all.first(most - last));
  shown += "...";
  append(shown, all.last(last));
  return shown;
}

}  // namespace avo_io
