// SPDX-License-Identifier: Apache-2.0
// Completion in zsh: the specifications that _arguments needs of every verb.
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "completion/generate.h"

namespace avo_cli {
namespace {

/// Returns the text escaped for the description of an option in single quotes.
std::string escaped_for_zsh(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      result += std::string("\\") + c;
    else
      result += c;
  }
  return result;
}

/// Returns the action that offers files with such endings.
std::string files_of(const std::vector<std::string>& endings) {
  // a single ending in parentheses would be a qualifier
  if (endings.size() == 1) return fmt::format("\"*.{}\"", endings[0]);
  return fmt::format("\"*.({})\"", fmt::join(endings, "|"));
}

/// Returns the action that offers such values.
std::string action_of(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::none:
    case ValueKind::anything:
      return " ";
    case ValueKind::file:
      return "_files -g " + files_of(option.endings);
    case ValueKind::scene:
      return "_avo_scenes " + files_of(option.endings);
    case ValueKind::name:
      return "_avo_names";
    case ValueKind::setting:
      return "_avo_settings";
    case ValueKind::verb:
      return "_avo_verbs";
  }
  return " ";
}

/// Returns one argument of _arguments for each name of the option.
std::string arguments_of(const OptionText& option) {
  const std::string value = fmt::format(":{}:{}", escaped_for_zsh(option.value), action_of(option));
  if (option.is_operand)
    return fmt::format(" \\\n        '{}{}'", option.is_required ? "" : ":", value);
  std::string text;
  for (const std::string& name : option.names) {
    const std::string others =
        option.repeats ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    const bool has_value = option.kind != ValueKind::none;
    text += fmt::format(" \\\n        '{}{}{}[{}]{}'", others, name, has_value ? "=" : "",
                        escaped_for_zsh(option.description), has_value ? value : "");
  }
  return text;
}

std::string arguments_of(const VerbText& verb) {
  std::string text;
  for (const OptionText& option : verb.options) text += arguments_of(option);
  return text;
}

}  // namespace

std::string zsh_completion(const ProgramText& text) {
  std::string verbs, cases, keys, values;
  for (const VerbText& verb : text.verbs) {
    verbs += fmt::format("    '{}:{}'\n", verb.name, escaped_for_zsh(verb.description));
    cases += fmt::format("    {})\n      _arguments -s -S{} ;;\n", verb.name, arguments_of(verb));
  }
  for (const avo_io::SceneSetting& setting : text.settings) {
    keys += " " + setting.key;
    if (!setting.values.empty())
      values +=
          fmt::format("      {}) compadd -- {} ;;\n", setting.key, fmt::join(setting.values, " "));
  }
  return "#compdef avo\n# Completion of avo in zsh, made by `avo generate zsh` from its "
         "options.\n\n" +
         fmt::format("_avo_verbs() {{\n  local -a verbs=(\n{}  )\n  _describe verb verbs\n}}\n\n",
                     verbs) +
         fmt::format("_avo_names() {{\n  compadd -- {}\n}}\n\n", fmt::join(text.scenes, " ")) +
         "_avo_scenes() {\n  _avo_names\n  _files -g \"$1\"\n}\n\n" +
         fmt::format(
             "_avo_settings() {{\n  if compset -P '*='; then\n    case ${{${{IPREFIX%=}}##*=}} in\n"
             "{}    esac\n  else\n    compadd -q -S = --{}\n  fi\n}}\n\n",
             values, keys) +
         fmt::format(
             "_avo() {{\n  local curcontext=$curcontext state line\n  typeset -A opt_args\n"
             "  _arguments -C -S{} \\\n        '1:verb:_avo_verbs' \\\n        '*::: :->rest' && "
             "return\n"
             "  words=(\"$line[1]\" \"${{words[@]}}\")\n  (( ++CURRENT ))\n"
             "  case $line[1] in\n{}  esac\n}}\n\n_avo \"$@\"\n",
             arguments_of(text.program), cases);
}

}  // namespace avo_cli
