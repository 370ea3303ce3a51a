// SPDX-License-Identifier: Apache-2.0
// Completion in bash: tables of all words, and one function that looks words up in them.
#include <fmt/format.h>
#include <string>

#include "completion/generate.h"

namespace avo_cli {
namespace {

// bash splits words at "=", and replaces only the text behind it.
constexpr const char* kFunctions = R"bash(
# KIND WORD: to COMPREPLY what the word may become
_avo_offer() {
  local kind=$1 word=$2 ending key
  COMPREPLY=()
  case $kind in
    verbs) mapfile -t COMPREPLY < <(compgen -W "$_avo_verbs" -- "$word") ;;
    names) mapfile -t COMPREPLY < <(compgen -W "$_avo_scenes" -- "$word") ;;
    settings)
      if [[ $word == *=* ]]; then
        key=${word%%=*}
        mapfile -t COMPREPLY < <(compgen -W "$(_avo_values "$key")" -- "${word#*=}")
        [[ $COMP_WORDBREAKS == *=* ]] || COMPREPLY=("${COMPREPLY[@]/#/$key=}")
      else
        compopt -o nospace
        mapfile -t COMPREPLY < <(compgen -S = -W "$_avo_settings" -- "$word")
      fi ;;
    scenes* | files*)
      compopt -o filenames
      mapfile -t COMPREPLY < <(
        if [[ $kind == scenes* ]]; then compgen -W "$_avo_scenes" -- "$word"; fi
        for ending in ${kind#* }; do compgen -f -X "!*.$ending" -- "$word"; done
        compgen -d -- "$word") ;;
  esac
}

_avo() {
  local IFS=$' 	
' word joins='' kind='' i
  local -a words=()
  for ((i = 1; i <= COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if ((${#words[@]} > 0)) && [[ $word == =* || -n $joins ]]; then
      words[-1]+=$word
    else
      words+=("$word")
    fi
    joins=''
    if [[ $word == *= ]]; then joins=1; fi
  done
  local current=${words[-1]} verb=${words[0]}
  if ((${#words[@]} == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "$_avo_verbs $(_avo_options '')" -- "$current")
    return
  fi
  if [[ $current == --*=* ]]; then
    kind=$(_avo_kind "$verb ${current%%=*}")
    _avo_offer "$kind" "${current#*=}"
    [[ $COMP_WORDBREAKS == *=* ]] || COMPREPLY=("${COMPREPLY[@]/#/${current%%=*}=}")
    return
  fi
  kind=$(_avo_kind "$verb ${words[-2]}")
  if [[ -n $kind ]]; then
    _avo_offer "$kind" "$current"
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_avo_options "$verb")" -- "$current")
  else
    _avo_offer "$(_avo_kind "$verb")" "$current"
  fi
}
complete -F _avo avo
)bash";

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// Returns the word by which _avo_offer() selects the values of the option.
std::string kind_of(const OptionText& option) {
  switch (option.kind) {
    case ValueKind::none:
      return "";
    case ValueKind::anything:
      return "nothing";
    case ValueKind::file:
      return "files " + joined(option.endings);
    case ValueKind::scene:
      return "scenes " + joined(option.endings);
    case ValueKind::name:
      return "names";
    case ValueKind::setting:
      return "settings";
    case ValueKind::verb:
      return "verbs";
  }
  return "";
}

std::string case_of(const std::string& key, const std::string& words) {
  return fmt::format("    '{}') echo '{}' ;;\n", key, words);
}

std::string function(const char* name, const std::string& cases) {
  return fmt::format("\n{}() {{\n  case $1 in\n{}  esac\n}}\n", name, cases);
}

std::string options_of(const VerbText& verb) {
  std::string names;
  for (const OptionText& option : verb.options)
    if (!option.is_operand) names += (names.empty() ? "" : " ") + joined(option.names);
  return case_of(verb.name, names);
}

/// Returns the kinds of values of the verb's options, and of its operand.
std::string kinds_of(const VerbText& verb) {
  std::string cases;
  for (const OptionText& option : verb.options) {
    if (option.kind == ValueKind::none) continue;
    for (const std::string& name : option.names)
      cases += case_of(option.is_operand ? verb.name : verb.name + " " + name, kind_of(option));
  }
  return cases;
}

}  // namespace

std::string bash_completion(const ProgramText& text) {
  std::vector<std::string> verbs, keys;
  std::string options = options_of(text.program), kinds, values;
  for (const VerbText& verb : text.verbs) {
    verbs.push_back(verb.name);
    options += options_of(verb);
    kinds += kinds_of(verb);
  }
  for (const avo_io::SceneSetting& setting : text.settings) {
    keys.push_back(setting.key);
    if (!setting.values.empty()) values += case_of(setting.key, joined(setting.values));
  }
  return "# Completion of avo in bash, made by `avo generate bash` from its options.\n" +
         fmt::format("_avo_verbs='{}'\n_avo_scenes='{}'\n_avo_settings='{}'\n", joined(verbs),
                     joined(text.scenes), joined(keys)) +
         function("_avo_options", options) + function("_avo_kind", kinds) +
         function("_avo_values", values) + kFunctions;
}

}  // namespace avo_cli
