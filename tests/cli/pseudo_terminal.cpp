// SPDX-License-Identifier: Apache-2.0
// A program believes that it is at a terminal, and a user types and reads there.
#include "pseudo_terminal.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "run_avo.h"

namespace avo_test {
namespace {

[[noreturn]] void become(std::vector<std::string>& command, const TerminalOptions& options) {
  const std::string folder = std::filesystem::path(AVO_BINARY).parent_path().string();
  setenv("PATH", (folder + ":/usr/bin:/bin").c_str(), 1);
  setenv("TERM", options.kind.c_str(), 1);
  setenv("LC_ALL", "C.UTF-8", 1);
  setenv("LSAN_OPTIONS", "print_suppressions=0:suppressions=" AVO_SUPPRESSIONS, 1);
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(97);
  if (!options.err_path.empty()) {
    const int file = open(options.err_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (file < 0 || dup2(file, STDERR_FILENO) < 0) _exit(99);
    close(file);
  }
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  execvp(words[0], words.data());
  _exit(98);
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::vector<std::string> command, const TerminalOptions& options) {
  const winsize size{24, static_cast<unsigned short>(options.columns), 0, 0};
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ < 0) throw std::runtime_error("forkpty");
  if (child_ == 0) become(command, options);
}

PseudoTerminal::~PseudoTerminal() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  close(terminal_);
}

void PseudoTerminal::type(const std::string& keys) {
  if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("write to the terminal");
}

// False at the end, which a terminal tells by an error, and where nothing comes.
bool PseudoTerminal::read_more() {
  pollfd ready{terminal_, POLLIN, 0};
  if (poll(&ready, 1, 1000 * static_cast<int>(kHang)) != 1) return false;
  char buffer[4096];
  const ssize_t got = read(terminal_, buffer, sizeof buffer);
  if (got < 0 && errno == EINTR) return true;
  if (got <= 0) return false;
  shown_.append(buffer, static_cast<std::size_t>(got));
  return true;
}

bool PseudoTerminal::wait_for(const std::string& text) {
  while (shown_.find(text) == std::string::npos)
    if (!read_more()) return shown_.find(text) != std::string::npos;
  return true;
}

int PseudoTerminal::wait() {
  while (read_more()) {
  }
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace avo_test
