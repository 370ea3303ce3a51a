// SPDX-License-Identifier: Apache-2.0
// What the user says by signals.
#pragma once

namespace avo_cli {

/// How long a program may go on after the first signal.
enum class Patience {
  none,
  a_second,
  until_second_signal,
};

/// From here on the first SIGINT, SIGTERM, SIGQUIT or SIGHUP (unless that is ignored, as under
/// nohup) is only noted. Where the program has not ended a second later (Patience; with none at
/// once), and at once on a second one, a child process is killed, files that are not complete are
/// removed, and the program ends with 128 + the signal's number. Call it before other threads
/// start: they inherit that signals are not theirs.
void catch_signals(Patience patience = Patience::a_second);

/// The signal noted, or 0.
int signal_caught();

}  // namespace avo_cli
