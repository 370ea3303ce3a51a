// SPDX-License-Identifier: Apache-2.0
// Runs the command line as a process of its own, without a shell.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace avo_test {

/// s. What takes longer hangs; what is slow on a busy machine does not take as long.
inline constexpr unsigned kHang = 1200;

struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal if it was killed
  std::string out, err;
};

struct ProcessOptions {
  std::string binary = {};    ///< in place of avo as it was built
  std::string out_path = {};  ///< standard output goes there instead; "|" is a pipe without reader
  std::string err_path = {};  ///< the same for the standard error output
  std::function<void()> before = {};            ///< called in the process before avo starts
  std::function<void(int pid)> meanwhile = {};  ///< called while it runs
};

/// In a folder of its own for each test, see folder(). Ends by SIGALRM where it hangs.
ProcessResult run_avo(const std::vector<std::string>& arguments,
                      const ProcessOptions& options = {});

/// The same of a program that ends by itself after a signal. It has a second for that, as elapsed:
/// where the machine has stalled for so long, its files are removed and it is run again.
ProcessResult run_avo_to_its_own_end(const std::vector<std::string>& arguments,
                                     const ProcessOptions& options);

/// Looks until it holds, however long that takes on a busy machine. False where it does not hold
/// when the child process has ended, or after kHang.
bool wait_until(int pid, const std::function<bool()>& holds);
/// The same of no process.
bool wait_until(const std::function<bool()>& holds);
/// Until it no longer dies of the signal at once, but does with it what it means to.
bool wait_until_caught(int pid, int signal);
/// Until it has had a processor for so long, s.
bool wait_until_worked(int pid, double seconds);
/// Until the file is larger.
bool wait_until_larger(int pid, const std::string& path, std::uintmax_t bytes);
/// Waits until some file in folder() with `part` in its name is larger.
bool wait_until_any_larger(int pid, const std::string& part, std::uintmax_t bytes);

/// An empty folder for the present test, the same at every call within it.
std::string folder();
std::string path_of(const std::string& file);

void write_file(const std::string& path, const std::string& text);
std::string read_file(const std::string& path);
bool exists(const std::string& path);
std::vector<std::string> files_in(const std::string& path);
std::vector<std::string> lines_of(const std::string& text);

}  // namespace avo_test
