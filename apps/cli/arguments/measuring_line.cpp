// SPDX-License-Identifier: Apache-2.0
// A measuring line that the command line names.
#include "arguments/measuring_line.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "avo_io/printable.h"
#include "avo_io/sweep.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {

std::optional<avo::MeasuringLine> line_of(const std::string& text) {
  constexpr double kFarthest = 1e12;  // m, the limit of all coordinates in scenes
  if (text.empty()) return std::nullopt;
  std::vector<double> numbers;
  bool good = true;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const auto number = avo_io::number_in(std::string_view(text).substr(at, end - at));
    good = good && number && std::abs(*number) <= kFarthest;
    numbers.push_back(number.value_or(0.0));
    at = end + 1;
  }
  if (good && numbers.size() == 4) {
    const avo::MeasuringLine line{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
    if (norm_squared(line.b - line.a) > 0.0) return line;
  }
  throw UsageError(fmt::format("--line: found {}, must be X,Y,X,Y, two points in m",
                               avo_io::printable(text, kLongestWord)));
}

}  // namespace avo_cli
