// SPDX-License-Identifier: Apache-2.0
// What is said to the user, and what the user says by signals.
#include "terminal.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <system_error>
#include <unistd.h>

#include "avo_io/errors.h"

namespace avo_cli {
namespace {

volatile std::sig_atomic_t noted_signal = 0;

extern "C" void note_signal(int number) {
  noted_signal = number;
}

}  // namespace

void print(std::string_view text) {
  errno = 0;
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  const int reason = errno;
  throw avo_io::FileError("standard output: " + std::generic_category().message(reason),
                          reason == EPIPE);
}

void say(std::string_view line) {
  fmt::print(stderr, "{}\n", line);
}

void warn(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) say("warning: " + line);
}

void catch_signals() {
  struct sigaction action = {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

int signal_caught() {
  return noted_signal;
}

Progress::Progress(std::int64_t steps, double time_step)
    : steps_(steps),
      time_step_(time_step),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_) fmt::print(stderr, "\r\033[K");
}

void Progress::show(std::int64_t step) {
  if (!terminal_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  const double part = static_cast<double>(step) / static_cast<double>(steps_);
  const double left = std::chrono::duration<double>(now - start_).count() * (1.0 / part - 1.0);
  constexpr int kWidth = 30;
  const auto filled = static_cast<std::size_t>(kWidth * part);
  fmt::print(stderr, "\r[{:<{}}] {:3.0f} %  t = {:.1f} of {:.1f} s, {:.0f} s left\033[K",
             std::string(filled, '#'), kWidth, 100.0 * part, static_cast<double>(step) * time_step_,
             static_cast<double>(steps_) * time_step_, left);
}

}  // namespace avo_cli
