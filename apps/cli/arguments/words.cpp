// SPDX-License-Identifier: Apache-2.0
// Unknown words of the command line, and the words that the user may have meant.
#include "arguments/words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "avo_io/nearest.h"
#include "avo_io/printable.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

std::string did_you_mean(std::string_view given, const std::vector<std::string>& names) {
  const std::vector<std::string_view> words(names.begin(), names.end());
  const auto meant = avo_io::nearest(given, words);
  return meant ? ", did you mean " + std::string(*meant) + "?" : "";
}

// Checks that every word that looks like a long option is an option of `app`.
void check_options(const CLI::App& app, const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (!word.starts_with("--") || word == "--") continue;
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw UsageError(avo_io::printable(name, kLongestWord) + ": found no such option" +
                       did_you_mean(name, names));
  }
}

}  // namespace

const CLI::App& verb_of(const CLI::App& app, const std::string& word) {
  std::vector<std::string> verbs;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (verb->get_name() == word) return *verb;
    if (verb->get_group().empty()) continue;
    verbs.push_back(verb->get_name());
  }
  const std::vector<std::string_view> words(verbs.begin(), verbs.end());
  throw UsageError(avo_io::printable(word, kLongestWord) + ": found no such verb, " +
                   avo_io::allowed_words(word, words, "verbs are"));
}

std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> begun = app.get_subcommands();
  if (begun.empty()) return std::string(error.what()) + "; see avo --help";
  const CLI::App& verb = *begun.front();
  std::string text = error.what();
  for (const CLI::Option* option : verb.get_options())
    if (text == option->get_name() + " is required")
      text = "found no " + option->get_name() + " (" + option->get_description() + ")";
  return verb.get_name() + ": " + text + "; see avo " + verb.get_name() + " --help";
}

int print_help(const CLI::App& app, const std::string& verb) {
  // not app.help(): that would be the help of the verb `help`
  print(verb.empty() ? app.get_formatter()->make_help(&app, "avo", CLI::AppFormatMode::Normal)
                     : verb_of(app, verb).help("avo"));
  return kDone;
}

void check_words(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return;
  if (words[0].starts_with("-")) return check_options(app, {words[0]});
  check_options(verb_of(app, words[0]), words);
}

}  // namespace avo_cli
