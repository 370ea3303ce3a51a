// SPDX-License-Identifier: Apache-2.0
// Handles the user's signals. A separate thread waits for them, so that its reaction may lock and
// allocate, and does not depend on what the other threads are doing.
#include "system/signals.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <poll.h>
#include <signal.h>
#include <thread>
#include <unistd.h>

#include "avo_io/output_file.h"
#include "exit_codes.h"
#include "system/child_process.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

using Steady = std::chrono::steady_clock;

/// timeout(1) and other programs send a signal to the process and to its group. Two within this
/// time count as one.
constexpr std::chrono::milliseconds kSame{50};
constexpr std::chrono::milliseconds kPatience{1000};

std::atomic<int> noted_signal = 0;

sigset_t awaited_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGQUIT, SIGHUP}) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (number != SIGHUP || action.sa_handler != SIG_IGN) sigaddset(&signals, number);
  }
  return signals;
}

/// Returns the next of the signals, or 0 if none comes before `end`.
int wait_until(Steady::time_point end, const sigset_t& signals) {
  using std::chrono::nanoseconds;
  while (true) {
    const nanoseconds left = std::max(nanoseconds(end - Steady::now()), nanoseconds(0));
    const timespec time{static_cast<time_t>(left / std::chrono::seconds(1)),
                        static_cast<long>((left % std::chrono::seconds(1)).count())};
    const int number = sigtimedwait(&signals, nullptr, &time);
    if (number > 0) return number;
    if (errno != EINTR) return 0;
  }
}

/// Returns whether a line can be written to the standard error output without waiting for its
/// reader.
bool is_heard() {
  pollfd error_output{STDERR_FILENO, POLLOUT, 0};
  return poll(&error_output, 1, 0) == 1;
}

// First suspends the child, so that it does not create again a file that is removed. Then the
// program ends; a thread that waits for the child's end finds the outputs locked.
[[noreturn]] void end_now(int signal) {
  stop_child();
  avo_io::abandon_outputs();
  kill_child();
  if (is_heard()) say("ended by a signal; outputs that were not complete are not there");
  _exit(kSignal + signal);
}

void end_on_signals(const sigset_t& signals, Patience patience) {
  int first = 0;
  while (sigwait(&signals, &first) != 0) {
  }
  noted_signal = first;
  if (patience == Patience::none) end_now(first);
  std::this_thread::sleep_for(kSame);
  sigset_t same;
  sigemptyset(&same);
  sigaddset(&same, first);
  wait_until(Steady::now(), same);
  int second = wait_until(Steady::now() + kPatience, signals);
  while (second == 0 && patience == Patience::until_second_signal)
    second = wait_until(Steady::now() + kPatience, signals);
  end_now(second != 0 ? second : first);
}

}  // namespace

void catch_signals(Patience patience) {
  const sigset_t signals = awaited_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread(end_on_signals, signals, patience).detach();
}

int signal_caught() {
  return noted_signal;
}

}  // namespace avo_cli
