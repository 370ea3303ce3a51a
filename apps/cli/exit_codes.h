// SPDX-License-Identifier: Apache-2.0
// What the command line tells its caller.
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
inline constexpr int kIncomplete = 7;    ///< lacks rows and breaks no rule; lacks runs
inline constexpr int kSignal = 128;      ///< + number of the signal: 130, 143
inline constexpr int kClosedPipe = 141;  ///< who read our output went away

/// What `avo generate man` says of them.
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
    {"141", "whoever read the output went away"}};

/// A scene that breaks what its certificate assumes, one line for each thing that is broken.
class BrokenScene : public avo::Error {
 public:
  explicit BrokenScene(std::vector<std::string> complaints)
      : avo::Error(complaints.at(0)), lines(std::move(complaints)) {}
  std::vector<std::string> lines;
};

/// A command line that says something impossible.
class UsageError : public avo::Error {
 public:
  using avo::Error::Error;
};

}  // namespace avo_cli
