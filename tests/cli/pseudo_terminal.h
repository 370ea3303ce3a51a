// SPDX-License-Identifier: Apache-2.0
// A program believes that it is at a terminal, and a user types and reads there.
#pragma once
#include <string>
#include <sys/types.h>
#include <vector>

namespace avo_test {

struct TerminalOptions {
  std::string kind = "xterm";  ///< TERM
  int columns = 100;
  std::string err_path = {};  ///< the standard error output goes there instead
  std::string folder = {};    ///< where it runs; empty: here
};

class PseudoTerminal {
 public:
  /// The program is looked for along PATH, in which avo is.
  explicit PseudoTerminal(std::vector<std::string> command, const TerminalOptions& options = {});
  ~PseudoTerminal();  ///< kills it if it still runs
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void type(const std::string& keys);
  /// Reads until `text` was shown since the last call of clear(), or the program has ended, or it
  /// hangs. Whether it was.
  bool wait_for(const std::string& text);
  /// All that was shown since the last call of clear().
  [[nodiscard]] const std::string& shown() const { return shown_; }
  void clear() { shown_.clear(); }
  /// Reads to the end; the exit code, or 128 + signal.
  int wait();

 private:
  bool read_more();

  pid_t child_ = -1;
  int terminal_ = -1;
  std::string shown_;
};

}  // namespace avo_test
