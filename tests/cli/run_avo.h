// SPDX-License-Identifier: Apache-2.0
// Runs the command line as a process of its own, without a shell.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace avo_test {

struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal if it was killed
  std::string out, err;
};

struct ProcessOptions {
  std::string binary = {};    ///< in place of avo as it was built
  std::string out_path = {};  ///< standard output goes there instead; "|" is a pipe nobody reads
  std::string err_path = {};  ///< the same for the standard error output
  std::function<void()> before = {};            ///< called in the process before avo starts
  std::function<void(int pid)> meanwhile = {};  ///< called while it runs
};

/// In a folder of its own for each test, see folder().
ProcessResult run_avo(const std::vector<std::string>& arguments,
                      const ProcessOptions& options = {});

/// An empty folder for the present test, the same at every call within it.
std::string folder();
std::string path_of(const std::string& file);

void write_file(const std::string& path, const std::string& text);
std::string read_file(const std::string& path);
bool exists(const std::string& path);
std::vector<std::string> files_in(const std::string& path);
std::vector<std::string> lines_of(const std::string& text);

}  // namespace avo_test
