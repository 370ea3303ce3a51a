// SPDX-License-Identifier: Apache-2.0
// Runs the command line as a process of its own, without a shell.
#include "run_avo.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <signal.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace avo_test {
namespace {

namespace fs = std::filesystem;

/// Redirects `target` to a pipe that has no reader.
void redirect_to_closed_pipe(int target) {
  int ends[2] = {-1, -1};
  if (pipe(ends) != 0 || dup2(ends[1], target) < 0) _exit(99);
  close(ends[0]);
  close(ends[1]);
}

void redirect(const std::string& path, int target) {
  if (path == "|") return redirect_to_closed_pipe(target);
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0 || dup2(file, target) < 0) _exit(99);
  close(file);
}

[[noreturn]] void become_avo(const std::vector<std::string>& arguments, const std::string& out,
                             const std::string& err, const ProcessOptions& options) {
  redirect(out, STDOUT_FILENO);
  redirect(err, STDERR_FILENO);
  std::vector<char*> words;
  std::string name = "avo";
  words.push_back(name.data());
  std::vector<std::string> copies = arguments;
  for (std::string& word : copies) words.push_back(word.data());
  words.push_back(nullptr);
  setenv("LSAN_OPTIONS", "print_suppressions=0:suppressions=" AVO_SUPPRESSIONS, 1);
  alarm(kHang);
  if (options.before) options.before();
  execv(options.binary.empty() ? AVO_BINARY : options.binary.c_str(), words.data());
  _exit(98);
}

/// Gone with the process, like all in it.
struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() / ("avo_cli_test." + std::to_string(getpid()));
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

}  // namespace

ProcessResult run_avo(const std::vector<std::string>& arguments, const ProcessOptions& options) {
  const std::string own_err = path_of("stderr.txt"), own_out = path_of("stdout.txt");
  const std::string& err = options.err_path.empty() ? own_err : options.err_path;
  const std::string& out = options.out_path.empty() ? own_out : options.out_path;
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) become_avo(arguments, out, err, options);
  if (options.meanwhile) options.meanwhile(child);
  int status = 0;
  waitpid(child, &status, 0);
  ProcessResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.out_path.empty()) result.out = read_file(own_out);
  if (options.err_path.empty()) result.err = read_file(own_err);
  fs::remove(own_out);
  fs::remove(own_err);
  return result;
}

ProcessResult run_avo_to_its_own_end(const std::vector<std::string>& arguments,
                                     const ProcessOptions& options) {
  constexpr int kTries = 20;
  const std::vector<std::string> before = files_in(folder());
  for (int k = 0;; ++k) {
    ProcessResult result = run_avo(arguments, options);
    if (k == kTries || result.err.find("ended by a signal;") == result.err.npos) return result;
    for (const std::string& name : files_in(folder()))  // a spool is left
      if (std::find(before.begin(), before.end(), name) == before.end())
        unlink(path_of(name).c_str());
  }
}

bool wait_until(int pid, const std::function<bool()>& holds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(kHang);
  while (!holds()) {
    siginfo_t ended = {};
    if (pid > 0 &&
        waitid(P_PID, static_cast<id_t>(pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        ended.si_pid == pid)
      return holds();
    if (Clock::now() > end) return false;
    usleep(1000);
  }
  return true;
}

bool wait_until(const std::function<bool()>& holds) {
  return wait_until(0, holds);
}

bool wait_until_caught(int pid, int signal) {
  return wait_until(pid, [&] {
    const std::string status = read_file("/proc/" + std::to_string(pid) + "/status");
    const std::size_t at = status.find("SigBlk:");  // a thread of its own waits for them
    return at != status.npos &&
           (std::strtoull(status.c_str() + at + 7, nullptr, 16) >> (signal - 1) & 1U) != 0;
  });
}

bool wait_until_worked(int pid, double seconds) {
  return wait_until(pid, [&] {
    const std::string stat = read_file("/proc/" + std::to_string(pid) + "/stat");
    std::istringstream fields(stat.substr(std::min(stat.rfind(')') + 2, stat.size())));
    std::string skipped;
    for (int k = 0; k < 11; ++k) fields >> skipped;
    double in_user_mode = 0.0, in_system = 0.0;  // clock ticks
    fields >> in_user_mode >> in_system;
    return in_user_mode + in_system >= seconds * static_cast<double>(sysconf(_SC_CLK_TCK));
  });
}

bool wait_until_larger(int pid, const std::string& path, std::uintmax_t bytes) {
  return wait_until(pid, [&] {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(path, missing);
    return !missing && size > bytes;
  });
}

bool wait_until_any_larger(int pid, const std::string& part, std::uintmax_t bytes) {
  return wait_until(pid, [&] {
    const std::vector<std::string> names = files_in(folder());
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      std::error_code gone;
      const std::uintmax_t size =
          name.find(part) != name.npos ? fs::file_size(path_of(name), gone) : 0;
      return !gone && size > bytes;
    });
  });
}

std::string folder() {
  static const TemporaryFolder top;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  std::string name = std::string(test->test_suite_name()) + "." + test->name();
  std::replace(name.begin(), name.end(), '/', '_');
  fs::create_directories(top.path / name);
  return (top.path / name).string();
}

std::string path_of(const std::string& file) {
  return folder() + "/" + file;
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool exists(const std::string& path) {
  return fs::exists(path);
}

std::vector<std::string> files_in(const std::string& path) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace avo_test
