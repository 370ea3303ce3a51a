// SPDX-License-Identifier: Apache-2.0
// Messages to the user.
#include "system/terminal.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

#include "avo_io/errors.h"
#include "avo_io/output_file.h"
#include "avo_io/printable.h"

namespace avo_cli {
namespace {

constexpr std::size_t kLongestLine = 1000;
constexpr std::string_view kWipe = "\r\033[K";

std::atomic<bool> bar_shown = false;
Volume said = Volume::normal;

/// Writes to the standard error output. Failure is ignored: there is no place to report it.
void write_error(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && (kind == nullptr || std::string_view(kind) != "dumb");
}

/// Returns "42 s", "3 min 5 s", "2 h 10 min".
std::string clock_time(double seconds) {
  constexpr double kMinute = 60.0, kHour = 3600.0;
  const double whole = std::round(seconds);
  if (whole < kMinute) return fmt::format("{:.0f} s", whole);
  if (whole < kHour)
    return fmt::format("{:.0f} min {:.0f} s", std::floor(whole / kMinute),
                       std::fmod(whole, kMinute));
  return fmt::format("{:.0f} h {:.0f} min", std::floor(whole / kHour),
                     std::floor(std::fmod(whole, kHour) / kMinute));
}

std::string bar(double part) {
  constexpr int kWidth = 30;
  return fmt::format("[{:<{}}] ", std::string(static_cast<std::size_t>(kWidth * part), '#'),
                     kWidth);
}

/// Returns the part that fits into a line of the terminal: a bar that wraps could not be wiped.
std::string fitting(const std::string& bar, const std::string& text) {
  winsize size = {};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::size_t columns = known ? size.ws_col - 1U : 79U;
  return bar.size() + text.size() <= columns ? bar + text : text.substr(0, columns);
}

}  // namespace

void prepare_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0) continue;
    // open in the wrong direction: reading or writing fails, as on a closed stream
    const int direction = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (open("/dev/null", direction) < 0)  // open() takes the lowest free number
      throw avo_io::FileError("/dev/null: " + std::generic_category().message(errno));
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void print(std::string_view text) {
  avo_io::OutputFile out("-");
  out.write(text);
  out.commit();
}

void say(std::string_view line) noexcept {
  try {
    if (bar_shown.exchange(false)) write_error(kWipe);
    write_error(avo_io::printable(line, kLongestLine) + "\n");
  } catch (const std::bad_alloc&) {
  }
}

void say(const std::vector<std::string>& lines) noexcept {
  for (const std::string& line : lines) say(line);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void warn(const std::vector<std::string>& lines) {
  if (volume() == Volume::quiet) return;
  for (const std::string& line : lines) say("warning: " + line);
}

void set_volume(Volume volume) {
  said = volume;
}

Volume volume() {
  return said;
}

void print_results(std::string_view text) {
  if (volume() != Volume::quiet) print(text);
}

Progress::Progress(double whole, const char* words, const char* left)
    : whole_(whole),
      words_(words),
      left_(left),
      shown_(volume() != Volume::quiet && is_terminal()),
      start_(Clock::now()),
      last_(start_) {}

Progress::Progress(double duration, bool may_end_before)
    : Progress(duration, "t = {:.1f} of {:.1f} s", may_end_before ? "at most " : "") {}

Progress Progress::of_parts(int parts) {
  return {static_cast<double>(parts), "{:.0f} of {:.0f} parts", ""};
}

Progress Progress::of_scenes(int scenes) {
  return {static_cast<double>(scenes), "{:.0f} of {:.0f} scenes checked", ""};
}

Progress::~Progress() {
  if (bar_shown.exchange(false)) write_error(kWipe);
}

void Progress::show(double time) {
  if (!shown_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  bar_shown = true;
  const double part = std::clamp(time / whole_, 1e-9, 1.0);
  const double left = std::chrono::duration<double>(now - start_).count() * (1.0 / part - 1.0);
  const std::string text =
      fmt::format("{:3.0f} %  {}, {}{} left", 100.0 * part,
                  fmt::format(fmt::runtime(words_), time, whole_), left_, clock_time(left));
  write_error("\r" + fitting(bar(part), text) + "\033[K");
}

}  // namespace avo_cli
