// SPDX-License-Identifier: Apache-2.0
// What is said to the user.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace avo_cli {

/// Characters of a word of the command line that a message repeats.
inline constexpr std::size_t kLongestWord = 60;

/// First thing in main(): where the standard input, output or error output is closed, no file of
/// ours gets its number, and using it fails. Writing to a pipe without a reader or beyond a limit
/// of file size fails as well, instead of ending the program.
void prepare_streams();

/// To the standard output, at once, as it is. Throws avo_io::FileError.
void print(std::string_view text);
/// One line to the standard error output, made printable; of a very long one the middle is left
/// out. Nothing happens where it cannot be written.
void say(std::string_view line) noexcept;
void say(const std::vector<std::string>& lines) noexcept;
/// The lines of a text.
std::vector<std::string> lines_of(std::string_view text);
/// One line for each, in front "warning: ".
void warn(const std::vector<std::string>& lines);

/// A bar on the standard error output, if that is a terminal; wiped at the end.
class Progress {
 public:
  explicit Progress(double duration);  ///< s
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double time);  ///< s

 private:
  using Clock = std::chrono::steady_clock;
  double duration_;
  bool terminal_;
  Clock::time_point start_, last_;
};

}  // namespace avo_cli
