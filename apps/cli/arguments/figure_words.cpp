// SPDX-License-Identifier: Apache-2.0
// The options of a figure of a run as words.
#include "arguments/figure_words.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

#include "avo_io/printable.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

template <typename Number>
std::optional<Number> number_of(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

[[noreturn]] void refuse(const char* option, const std::string& word, const char* allowed) {
  throw UsageError(fmt::format("{}: found {}, must be {}", option,
                               avo_io::printable(word, kLongestWord), allowed));
}

}  // namespace

FigureSize figure_size(const std::string& word) {
  constexpr double kLeast = 100.0, kMost = 5000.0;
  const auto length = [&](std::string_view part) {
    const auto value = number_of<double>(part);
    if (!value || !(*value >= kLeast && *value <= kMost))
      refuse("--figure-size", word, "WIDTH or WIDTHxHEIGHT, each from 100 to 5000 pt");
    return *value;
  };
  const std::size_t times = word.find('x');
  const std::string_view all = word;
  FigureSize size{length(all.substr(0, times)), 0.0};
  if (times != std::string::npos) size.height = length(all.substr(times + 1));
  return size;
}

TimeWindow figure_time(const std::string& word) {
  const char* const allowed = "FROM:TO in s, 0 <= FROM < TO; one of them may be left out";
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) refuse("--figure-time", word, allowed);
  const auto time = [&](std::string_view part, double otherwise) {
    if (part.empty()) return otherwise;
    const auto value = number_of<double>(part);
    if (!value || !(*value >= 0.0)) refuse("--figure-time", word, allowed);
    return *value;
  };
  const TimeWindow whole;
  const std::string_view all = word;
  const TimeWindow window{time(all.substr(0, colon), whole.from),
                          time(all.substr(colon + 1), whole.to)};
  if (word == ":" || !(window.from < window.to)) refuse("--figure-time", word, allowed);
  return window;
}

std::vector<std::size_t> figure_robots(const std::string& word) {
  constexpr std::size_t kMost = 1'000'000;
  std::set<std::size_t> robots;
  const auto robot = [&](std::string_view part) {
    const auto value = number_of<std::size_t>(part);
    if (!value || *value > kMost)
      refuse("--figure-robots", word, "numbers of robots and ranges, such as 0,3,7-9");
    return *value;
  };
  std::string_view left = word;
  for (bool more = true; more;) {
    const std::size_t comma = left.find(',');
    const std::string_view part = left.substr(0, comma);
    const std::size_t dash = part.find('-');
    const std::size_t first = robot(part.substr(0, dash));
    const std::size_t last = dash == std::string_view::npos ? first : robot(part.substr(dash + 1));
    for (std::size_t k = first; k <= last; ++k) robots.insert(k);
    more = comma != std::string_view::npos;
    if (more) left.remove_prefix(comma + 1);
  }
  if (robots.empty()) refuse("--figure-robots", word, "ranges from a lower to a higher number");
  return {robots.begin(), robots.end()};
}

}  // namespace avo_cli
