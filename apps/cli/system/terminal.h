// SPDX-License-Identifier: Apache-2.0
// Messages to the user.
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace avo_cli {

/// The most characters of a word of the command line that a message repeats.
inline constexpr std::size_t kLongestWord = 60;

/// The amount of messages besides the output that an option asks for.
enum class Volume {
  quiet,    ///< only errors
  normal,   ///< warnings, progress, and results for people to read
  verbose,  ///< also which scene is loaded, and with which settings
};
/// Sets the volume, which is normal at first. Call it before other threads start.
void set_volume(Volume volume);
Volume volume();

/// Prepares the streams; call it first in main(). If the standard input, output or error output is
/// closed, no other file gets its number, and its use fails. Writing to a pipe without a reader, or
/// beyond a limit of file size, then also fails instead of ending the program.
void prepare_streams();

/// Prints verbatim to the standard output, at once. Throws avo_io::FileError.
void print(std::string_view text);
/// Prints text for people to read, unless the volume is quiet.
void print_results(std::string_view text);
/// Prints one line to the standard error output, made printable; the middle of a very long line is
/// left out. Nothing happens if the line cannot be written.
void say(std::string_view line) noexcept;
void say(const std::vector<std::string>& lines) noexcept;
/// Returns the lines of a text.
std::vector<std::string> lines_of(std::string_view text);
/// Prints one line for each, with "warning: " in front; nothing if the volume is quiet.
void warn(const std::vector<std::string>& lines);

/// A progress bar on the standard error output with the remaining time, updated ten times a second.
/// It appears only on a terminal (not a dumb one) and if the volume is not quiet; it is wiped at
/// the end.
class Progress {
 public:
  /// `duration`: s, of the simulation. `may_end_before`: the remaining time is shown as an upper
  /// bound.
  explicit Progress(double duration, bool may_end_before = false);
  /// Shows progress over so many parts that take about the same time.
  static Progress of_parts(int parts);
  static Progress of_scenes(int scenes);  ///< shows progress over scenes that are made and checked
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double time);  ///< s, of the simulation; for parts: the number that is done

 private:
  using Clock = std::chrono::steady_clock;
  Progress(double whole, const char* words, const char* left);
  double whole_;       // s, or parts
  const char* words_;  // for the part that is done, and for the whole
  const char* left_;   // for the remaining time
  bool shown_;
  Clock::time_point start_, last_;
};

}  // namespace avo_cli
