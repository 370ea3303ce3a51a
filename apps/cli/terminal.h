// SPDX-License-Identifier: Apache-2.0
// What is said to the user, and what the user says by signals.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace avo_cli {

/// To the standard output, at once. Throws avo_io::FileError.
void print(std::string_view text);
/// One line to the standard error output.
void say(std::string_view line);
/// One line for each, in front "warning: ".
void warn(const std::vector<std::string>& lines);

/// From here on SIGINT and SIGTERM are only noted, the first of them; a second one ends the
/// program. SIGPIPE is ignored in favor of write errors.
void catch_signals();
/// The signal noted, or 0.
int signal_caught();

/// A bar on the standard error output, if that is a terminal; wiped at the end.
class Progress {
 public:
  Progress(std::int64_t steps, double time_step);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(std::int64_t step);

 private:
  using Clock = std::chrono::steady_clock;
  std::int64_t steps_;
  double time_step_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point start_, last_;
};

}  // namespace avo_cli
