// SPDX-License-Identifier: Apache-2.0
// Another program that reads the output of this program.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace avo_cli {

class ChildProcess {
 public:
  /// Starts the program, found by PATH. Throws avo_io::FileError if there is none.
  explicit ChildProcess(const std::vector<std::string>& command);
  /// Kills the program, unless it has ended.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to the program's standard input. Returns false once the program does not read any more.
  bool write(std::string_view bytes);
  /// Ends the program's input, and waits for its end. Unless it succeeds, this throws
  /// avo_io::FileError with the last line of its error output.
  void finish();

 private:
  std::string name_;
  int pid_ = -1, input_ = -1, errors_ = -1;
};

/// For a program that is about to end, from any thread. stop_child() suspends the child that was
/// started last, and kill_child() kills it. Nothing happens if there is none.
void stop_child();
void kill_child();

}  // namespace avo_cli
