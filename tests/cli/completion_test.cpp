// SPDX-License-Identifier: Apache-2.0
// What is made from the tree of options: shown by man, and asked for in bash and zsh on a terminal.
#include <filesystem>
#include <gtest/gtest.h>
#include <regex>
#include <string>
#include <vector>

#include "pseudo_terminal.h"
#include "run_avo.h"

namespace avo_test {
namespace {

using Strings = std::vector<std::string>;

const Strings kVerbs{"run", "explain", "check", "bench", "scenes", "validate", "schema", "help"};

std::string generated(const std::string& kind, const std::string& file) {
  const ProcessResult result = run_avo({"generate", kind});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  write_file(path_of(file), result.out);
  return path_of(file);
}

/// What `command` writes, in a shell.
std::string said_by(const std::string& command) {
  PseudoTerminal terminal({"sh", "-c", command});
  EXPECT_EQ(terminal.wait(), 0) << command << "\n" << terminal.shown();
  return terminal.shown();
}

TEST(Manual, is_shown_without_warnings_and_has_every_option) {
  const std::string page = generated("man", "avo.1");
  EXPECT_EQ(said_by("groff -man -ww -Tutf8 -z " + page), "");
  EXPECT_EQ(said_by("man --warnings -l " + page + " 2>&1 >/dev/null"), "");
  const std::string text = said_by("MANWIDTH=200 man -l " + page + " | col -b");
  for (const std::string& verb : kVerbs) {
    EXPECT_NE(text.find("avo " + verb + " [options]"), std::string::npos) << verb;
    const std::string help = run_avo({verb, "--help"}).out;
    const std::regex pattern(R"(\n  (--[a-z-]+|-.,--[a-z-]+))");
    for (std::sregex_iterator i(help.begin(), help.end(), pattern), end; i != end; ++i) {
      const std::string match = (*i)[1], name = match.substr(match.find("--"));
      EXPECT_NE(text.find(name), std::string::npos) << name;
    }
  }
  EXPECT_NE(text.find("--set KEY=VALUE"), std::string::npos);
  EXPECT_NE(text.find("EXIT STATUS"), std::string::npos);
}

/// Types the beginning of a line and a tab, for each of these; what is to be seen then.
struct Asked {
  std::string typed, offered;
  std::string not_offered = {};
};

const std::vector<Asked> kAsked{
    {"avo val", "avo validate "},
    {"avo -", "--version"},
    {"avo help expl", "avo help explain "},
    {"avo run circle-1", "circle-1000"},
    {"avo run off", "avo run office "},
    {"avo run my-", "avo run my-scene.yaml "},
    {"avo scenes ware", "avo scenes warehouse "},
    {"avo run office --unt", "avo run office --until-arrived "},
    {"avo check --", "--max-acceleration", "--until-arrived"},
    {"avo run office --record ", "a.csv", "c.json"},
    {"avo check b", "avo check b.csv "},
    {"avo run office --figure d", "avo run office --figure d.svg "},
    {"avo run office --figure=d", "avo run office --figure=d.svg "},
    {"avo check a.csv --scene mixed-y", "avo check a.csv --scene mixed-yard "},
    {"avo run office --set contr", "avo run office --set control_time="},
    {"avo run office --set method=v", "avo run office --set method=velocity_obstacle "},
    {"avo run office --set clock=", "common"},
    {"avo run office --set=right_of_way=s", "avo run office --set=right_of_way=seen "}};

void expect_completions(PseudoTerminal& terminal) {
  for (const Asked& asked : kAsked) {
    terminal.clear();
    terminal.type(asked.typed + "\t");
    EXPECT_TRUE(terminal.wait_for(asked.offered)) << asked.typed << "\n" << terminal.shown();
    if (!asked.not_offered.empty()) {
      EXPECT_EQ(terminal.shown().find(asked.not_offered), std::string::npos) << terminal.shown();
    }
    terminal.clear();
    terminal.type("\x15: next\r");  // away with the line
    EXPECT_TRUE(terminal.wait_for("ready> "));
  }
}

void put_files() {
  std::filesystem::create_directory(path_of("files"));
  for (const char* file : {"a.csv", "b.csv", "c.json", "d.svg", "my-scene.yaml"})
    write_file(path_of("files/") + file, "");
}

TEST(Completion, of_bash) {
  const std::string script = generated("bash", "avo.bash");
  EXPECT_EQ(said_by("bash -n " + script), "");
  put_files();
  PseudoTerminal terminal({"bash", "--norc", "--noprofile", "-i"},
                          {.kind = "dumb", .columns = 200, .folder = path_of("files")});
  terminal.type(
      "bind 'set show-all-if-ambiguous on'; bind 'set bell-style none'; "
      "bind 'set enable-bracketed-paste off'; bind 'set page-completions off'\r");
  terminal.type("source " + script + "; PS1='rea''dy> '\r");
  ASSERT_TRUE(terminal.wait_for("ready> ")) << terminal.shown();
  expect_completions(terminal);
}

TEST(Completion, of_zsh) {
  const std::string script = generated("zsh", "_avo");
  EXPECT_EQ(said_by("zsh -n " + script), "");
  put_files();
  PseudoTerminal terminal({"zsh", "-f", "-i"},
                          {.kind = "dumb", .columns = 200, .folder = path_of("files")});
  terminal.type("unsetopt prompt_cr prompt_sp auto_menu list_ambiguous; setopt no_beep; fpath=(" +
                folder() + " $fpath); autoload -Uz compinit; compinit -u -D; PS1='rea''dy> '\r");
  ASSERT_TRUE(terminal.wait_for("ready> ")) << terminal.shown();
  expect_completions(terminal);
}

TEST(Completion, is_generated_for_known_shells_only_and_not_listed) {
  const ProcessResult result = run_avo({"generate", "fish"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err, "avo: fish: found no such kind, must be man, bash or zsh\n");
  EXPECT_EQ(run_avo({"--help"}).out.find("generate"), std::string::npos);
}

}  // namespace
}  // namespace avo_test
