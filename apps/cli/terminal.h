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

/// How much is said besides what the command line asks for by an option.
enum class Volume {
  quiet,    ///< errors alone
  normal,   ///< warnings, progress, and results for people to read
  verbose,  ///< and what is loaded, and with which settings
};
/// Normal at first. Call it before other threads start.
void set_volume(Volume volume);
Volume volume();

/// First thing in main(): where the standard input, output or error output is closed, no file of
/// ours gets its number, and using it fails. Writing to a pipe without a reader or beyond a limit
/// of file size fails as well, instead of ending the program.
void prepare_streams();

/// To the standard output, at once, as it is. Throws avo_io::FileError.
void print(std::string_view text);
/// The same of what is for people to read: not where it is to be quiet.
void print_results(std::string_view text);
/// One line to the standard error output, made printable; of a very long one the middle is left
/// out. Nothing happens where it cannot be written.
void say(std::string_view line) noexcept;
void say(const std::vector<std::string>& lines) noexcept;
/// The lines of a text.
std::vector<std::string> lines_of(std::string_view text);
/// One line for each, in front "warning: "; none where it is to be quiet.
void warn(const std::vector<std::string>& lines);

/// A bar on the standard error output with the time that is left, ten times a second, if that is a
/// terminal (and no dumb one) and it is not to be quiet; wiped at the end.
class Progress {
 public:
  /// s, of the simulation. `may_end_before`: the time that is left is told as the most.
  explicit Progress(double duration, bool may_end_before = false);
  /// Of so many parts, each of which takes about as long.
  static Progress of_parts(int parts);
  static Progress of_scenes(int scenes);  ///< likewise, to be made and checked
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double time);  ///< s, of the simulation; of parts: how many are done

 private:
  using Clock = std::chrono::steady_clock;
  Progress(double whole, const char* words, const char* left);
  double whole_;       // s, or parts
  const char* words_;  // of what is done and the whole
  const char* left_;   // what is said of the time that is left
  bool shown_;
  Clock::time_point start_, last_;
};

}  // namespace avo_cli
