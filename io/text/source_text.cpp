// SPDX-License-Identifier: Apache-2.0
// Texts other than YAML, read word by word.
#include "io/text/source_text.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <system_error>

#include "avo_io/errors.h"
#include "io/scene/reader.h"
#include "io/text/words.h"

namespace avo_io {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

void SourceText::fail(std::size_t offset, const std::string& message) const {
  const std::string_view before = text().substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t column = offset - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
  if (node_ != nullptr)
    document_->fail(*node_, fmt::format("{}{}:{}: {}", in_front(name_), line, column, message));
  throw SceneError(fmt::format("{}:{}:{}: {}", name_, line, column, message));
}

Word Words::next() {
  const std::string_view text = source_.text();
  while (offset_ < text.size() && is_space(text[offset_])) ++offset_;
  const std::size_t begin = offset_;
  const auto is_mark = [this](char c) { return marks_.find(c) != std::string_view::npos; };
  if (begin < text.size() && is_mark(text[begin])) {
    ++offset_;
  } else {
    while (offset_ < text.size() && !is_space(text[offset_]) && !is_mark(text[offset_])) ++offset_;
  }
  return {text.substr(begin, offset_ - begin), begin};
}

void Words::fail(const Word& word, const std::string& allowed) const {
  source_.fail(
      word.offset,
      fmt::format("found {}, {}", word.text.empty() ? "the end" : in_quotes(word.text), allowed));
}

std::int64_t Words::whole_number(std::string_view what, std::int64_t min, std::int64_t max) {
  const Word word = next();
  std::int64_t value = 0;
  const char* const end = word.text.data() + word.text.size();
  const auto [rest, error] = std::from_chars(word.text.data(), end, value);
  const bool out_of_range = error == std::errc::result_out_of_range;
  if (word.text.empty() || rest != end || (error != std::errc() && !out_of_range))
    fail(word, fmt::format("{} must be a whole number", what));
  if (out_of_range || value < min || value > max)
    fail(word, fmt::format("{} must be {} to {}", what, min, max));
  return value;
}

}  // namespace avo_io
