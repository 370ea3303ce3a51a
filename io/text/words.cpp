// SPDX-License-Identifier: Apache-2.0
// Reads and shows words and numbers of scene files, and guesses intended words.
#include "io/text/words.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fmt/format.h>
#include <system_error>

#include "avo_io/printable.h"
#include "io/text/decimal.h"

namespace avo_io {
namespace {

/// Returns the smallest number of insertions, deletions, replacements and swaps of neighbors
/// (optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t skip_digits(std::string_view text, std::size_t i) {
  while (i < text.size() && is_digit(text[i])) ++i;
  return i;
}

/// Returns whether `given` abbreviates `word`: it has the same beginning, and all its letters occur
/// in order.
bool abbreviates(std::string_view given, std::string_view word) {
  constexpr std::size_t kBeginning = 3;
  if (given.size() < kBeginning || !word.starts_with(given.substr(0, kBeginning))) return false;
  std::size_t i = 0;
  for (const char c : word)
    if (i < given.size() && c == given[i]) ++i;
  return i == given.size();
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  return '"' + printable(text, kLongest) + '"';
}

std::string joined(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::optional<std::string_view> nearest(std::string_view given,
                                        const std::vector<std::string_view>& words) {
  constexpr std::size_t kLongest = 40;  // bounds the work; no key is as long
  if (given.empty() || given.size() > kLongest) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t smallest = 0;
  for (const std::string_view word : words) {
    const std::size_t distance = edit_distance(given, word);
    const std::size_t allowed = std::max<std::size_t>(1, std::max(given.size(), word.size()) / 3);
    if (distance > allowed || (best && distance >= smallest)) continue;
    best = word;
    smallest = distance;
  }
  if (best) return best;
  for (const std::string_view word : words)
    if (abbreviates(given, word)) return word;
  return std::nullopt;
}

bool is_number(std::string_view text) {
  std::size_t i = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t whole = i;
  i = skip_digits(text, i);
  std::size_t digits = i - whole;
  if (i < text.size() && text[i] == '.') {
    const std::size_t fraction = ++i;
    i = skip_digits(text, i);
    digits += i - fraction;
  }
  if (digits == 0) return false;
  if (i == text.size()) return true;
  if (text[i] != 'e' && text[i] != 'E') return false;
  ++i;
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  return i < text.size() && skip_digits(text, i) == text.size();
}

std::optional<double> to_double(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  double value = 0.0;
  if (read_decimal(text, value) != std::errc()) return std::nullopt;
  return value + 0.0;
}

std::string allowed_words(std::string_view given, const std::vector<std::string_view>& words,
                          std::string before) {
  const auto meant = nearest(given, words);
  if (!meant) return fmt::format("{} {}", before, joined(words));
  before.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(before.front())));
  return fmt::format("did you mean \"{}\"? {} {}", *meant, before, joined(words));
}

}  // namespace avo_io
