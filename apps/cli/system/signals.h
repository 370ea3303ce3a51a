// SPDX-License-Identifier: Apache-2.0
// Handles the user's signals.
#pragma once

namespace avo_cli {

/// The time that a program may go on after the first signal.
enum class Patience {
  none,
  a_second,
  until_second_signal,
};

/// From here on, the first SIGINT, SIGTERM, SIGQUIT or SIGHUP (unless that is ignored, as under
/// nohup) is only noted. If the program has not ended a second later (Patience; with none at once),
/// it ends with 128 + the signal's number. A second signal ends it at once. In both cases the
/// program kills a child process and removes incomplete files first. Call this before other threads
/// start: they inherit the mask of these signals.
void catch_signals(Patience patience = Patience::a_second);

/// Returns the noted signal, or 0.
int signal_caught();

}  // namespace avo_cli
