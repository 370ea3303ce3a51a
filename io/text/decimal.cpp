// SPDX-License-Identifier: Apache-2.0
// Numbers as text, whatever the locale.
#include "io/text/decimal.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

#include "io/text/words.h"

namespace avo_io {

#ifdef __cpp_lib_to_chars

std::errc read_decimal(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return end == text.data() + text.size() ? error : std::errc::invalid_argument;
}

#else  // libc++ 19 has from_chars() for whole numbers only

std::errc read_decimal(std::string_view text, double& value) {
  if (!is_number(text) || text[0] == '+') return std::errc::invalid_argument;
  value = std::strtod(std::string(text).c_str(), nullptr);
  const bool is_zero =
      text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == text.npos;
  return std::isfinite(value) && (value != 0.0 || is_zero) ? std::errc()
                                                           : std::errc::result_out_of_range;
}

#endif

}  // namespace avo_io
