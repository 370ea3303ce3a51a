// SPDX-License-Identifier: Apache-2.0
// Another program that reads what we write.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace avo_cli {

class ChildProcess {
 public:
  /// Starts the program, found by PATH. Throws avo_io::FileError where there is none.
  explicit ChildProcess(const std::vector<std::string>& command);
  /// Kills it, unless it has ended.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// To its standard input. False where it does not read any more.
  bool write(std::string_view bytes);
  /// Ends its input, and waits for its end. Throws avo_io::FileError with the last line that it has
  /// said, unless it succeeds.
  void finish();

 private:
  std::string name_;
  int pid_ = -1, input_ = -1, errors_ = -1;
};

/// For a program that is about to end, from any thread: the child that was started last does
/// nothing any more; and it is killed. Nothing happens where there is none.
void stop_child();
void kill_child();

}  // namespace avo_cli
