// SPDX-License-Identifier: Apache-2.0
// The exit codes of the command line.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"

namespace avo_cli {

inline constexpr int kDone = 0;
inline constexpr int kUnsafe = 1;     ///< a recording that breaks a rule
inline constexpr int kUsage = 2;      ///< the command line is wrong
inline constexpr int kBadScene = 3;   ///< the scene or the recording is wrong
inline constexpr int kFile = 4;       ///< a file cannot be read or written
inline constexpr int kResources = 5;  ///< no memory, no threads
inline constexpr int kOurFault = 6;
/// the recording lacks rows and breaks no rule; or a table lacks runs
inline constexpr int kIncomplete = 7;
inline constexpr int kSignal = 128;      ///< + number of the signal: 130, 143
inline constexpr int kClosedPipe = 141;  ///< the reader of our output has gone away

/// The text of `avo generate man` about an exit code.
struct ExitCode {
  const char* number;
  const char* meaning;
};
inline constexpr ExitCode kExitCodes[] = {
    {"0", "done; of check: safe"},
    {"1", "of check: the recording breaks a rule"},
    {"2", "the command line is wrong"},
    {"3", "the scene or the recording is wrong"},
    {"4", "a file cannot be read or written"},
    {"5", "there is no memory, or there are no threads"},
    {"6", "a fault of the program itself"},
    {"7", "of check: rows are missing, and those that are there break no rule; of sweep: runs are"},
    {"130, 143, ...", "ended by a signal: 128 and its number"},
    {"141", "the reader of the output went away"}};

/// A scene that breaks the assumptions of its certificate, with one line for each that is broken.
class BrokenScene : public avo::Error {
 public:
  explicit BrokenScene(std::vector<std::string> complaints)
      : avo::Error(complaints.at(0)), lines(std::move(complaints)) {}
  std::vector<std::string> lines;
};

/// A command line that asks for something impossible.
class UsageError : public avo::Error {
 public:
  using avo::Error::Error;
};

}  // namespace avo_cli
