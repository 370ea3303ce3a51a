// SPDX-License-Identifier: Apache-2.0
// avo generate: manual page and completions, made from the options, scenes and schema.
#include "completion/generate.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <utility>

#include "avo_io/printable.h"
#include "avo_io/scene.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

/// Returns "svg", "png" and "pdf" for "FILE.svg|.png|.pdf".
std::vector<std::string> endings_of(const std::string& type) {
  std::vector<std::string> endings;
  for (std::size_t dot = type.find('.'); dot != type.npos; dot = type.find('.', dot + 1))
    endings.push_back(type.substr(dot + 1, type.find('|', dot) - dot - 1));
  return endings;
}

ValueKind kind_of(const OptionText& option, const std::string& type) {
  if (option.value.empty()) return ValueKind::none;
  if (type.starts_with("FILE.")) return ValueKind::file;
  if (type.starts_with("SCENE|FILE.")) return ValueKind::scene;
  const std::pair<const char*, ValueKind> kinds[] = {{"SCENE", ValueKind::scene},
                                                     {"NAME", ValueKind::name},
                                                     {"KEY=VALUE", ValueKind::setting},
                                                     {"VERB", ValueKind::verb}};
  for (const auto& [name, kind] : kinds)
    if (option.value == name) return kind;
  return ValueKind::anything;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  const std::string type = option.get_type_name();
  text.is_operand = option.get_positional();
  text.is_required = option.get_required();
  text.description = option.get_description();
  if (text.is_operand) {
    text.value = option.get_name(true);
    text.names = {text.value};
  } else {
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    // validators append the allowed values behind a colon
    if (option.get_items_expected_max() > 0) text.value = type.substr(0, type.find(':'));
    text.repeats = option.get_items_expected_max() > 1;
  }
  text.kind = kind_of(text, type);
  if (text.kind == ValueKind::scene) text.endings = {"yaml", "yml"};
  if (text.kind == ValueKind::scene || text.kind == ValueKind::file)
    for (std::string& ending : endings_of(type)) text.endings.push_back(std::move(ending));
  return text;
}

VerbText text_of(const CLI::App& app, const std::string& name) {
  VerbText text{name, app.get_description(), app.get_footer(), {}};
  for (const CLI::Option* option : app.get_options()) text.options.push_back(text_of(*option));
  return text;
}

/// Returns the names of scenes. A family has no end, so it appears with 10, 100 and 1000 robots.
std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const avo_io::BuiltinScene& scene : avo_io::builtin_scenes()) {
    if (!scene.name.ends_with("-N")) {
      names.push_back(scene.name);
      continue;
    }
    const std::string stem = scene.name.substr(0, scene.name.size() - 1);
    for (const char* number : {"10", "100", "1000"}) names.push_back(stem + number);
  }
  return names;
}

ProgramText text_of(const CLI::App& app) {
  ProgramText text{text_of(app, ""), {}, scene_names(), avo_io::scene_settings()};
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!verb->get_group().empty()) text.verbs.push_back(text_of(*verb, verb->get_name()));
  return text;
}

}  // namespace

int print_generated(const CLI::App& app, const std::string& kind) {
  const std::pair<const char*, std::string (*)(const ProgramText&)> kinds[] = {
      {"man", man_page}, {"bash", bash_completion}, {"zsh", zsh_completion}};
  for (const auto& [name, make] : kinds) {
    if (kind != name) continue;
    print(make(text_of(app)));
    return kDone;
  }
  throw UsageError(fmt::format("{}: found no such kind, must be man, bash or zsh",
                               avo_io::printable(kind, kLongestWord)));
}

}  // namespace avo_cli
