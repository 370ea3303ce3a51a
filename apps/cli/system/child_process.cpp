// SPDX-License-Identifier: Apache-2.0
// Another program that reads the output of this program.
#include "system/child_process.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "avo_io/errors.h"
#include "avo_io/printable.h"
#include "system/terminal.h"

extern char** environ;

namespace avo_cli {
namespace {

std::atomic<pid_t> running_child = -1;

[[noreturn]] void fail(const std::string& name, int reason) {
  throw avo_io::FileError(name + ": " + std::generic_category().message(reason));
}

/// Returns the first line in the file: the first error is the cause of all later ones.
std::string first_line(int file) {
  char text[4096];
  const ssize_t got = pread(file, text, sizeof text, 0);
  const std::string lines(text, got > 0 ? static_cast<std::size_t>(got) : 0);
  return lines.substr(0, lines.find('\n'));
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command) : name_(command.at(0)) {
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) fail(name_, errno);
  input_ = ends[1];
  errors_ = memfd_create("errors", MFD_CLOEXEC);
  std::vector<char*> words;
  words.reserve(command.size() + 1);
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors_, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors_, STDERR_FILENO);
  const int reason = posix_spawnp(&pid_, words[0], &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  if (reason == 0) {
    running_child = pid_;
    return;
  }
  close(input_);
  close(errors_);
  pid_ = -1;
  if (reason == ENOENT)
    throw avo_io::FileError(name_ + ": found no such program, must be installed");
  fail(name_, reason);
}

ChildProcess::~ChildProcess() {
  if (input_ >= 0) close(input_);
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    running_child = -1;
  }
  if (errors_ >= 0) close(errors_);
}

bool ChildProcess::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) return false;
    if (written < 0) fail(name_, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void ChildProcess::finish() {
  close(std::exchange(input_, -1));
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = running_child = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  const std::string said = avo_io::printable(first_line(errors_), 200);
  throw avo_io::FileError(
      fmt::format("{}: {}", name_, said.empty() ? "it has failed without a word" : said));
}

void stop_child() {
  const pid_t child = running_child;
  if (child <= 0 || kill(child, SIGSTOP) != 0) return;
  siginfo_t info = {};
  waitid(P_PID, static_cast<id_t>(child), &info, WSTOPPED | WEXITED | WNOWAIT);
}

void kill_child() {
  const pid_t child = running_child;
  if (child > 0) kill(child, SIGKILL);
}

}  // namespace avo_cli
