// SPDX-License-Identifier: Apache-2.0
// The manual page avo(1), in the man macros of roff.
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "avo/version.h"
#include "completion/generate.h"
#include "exit_codes.h"

namespace avo_cli {
namespace {

/// Escapes the text, so that roff shows every character unchanged: no dash becomes a hyphen, and no
/// line a request.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return text.starts_with('.') || text.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(std::string_view text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + escaped(text) + "\\fR";
}

/// Returns the entry of an option: its names, its value, and its purpose.
std::string entry(const OptionText& option) {
  std::string head;
  if (option.is_operand) {
    head = italic(option.value);
  } else {
    for (const std::string& name : option.names) head += (head.empty() ? "" : ", ") + bold(name);
    if (!option.value.empty()) head += " " + italic(option.value);
  }
  return fmt::format(".TP\n{}\n{}\n", head, escaped(option.description));
}

std::string synopsis(const VerbText& verb) {
  std::string line = bold("avo " + verb.name) + " [" + italic("options") + "]";
  for (const OptionText& option : verb.options) {
    if (!option.is_operand) continue;
    line += option.is_required ? " " + italic(option.value) : " [" + italic(option.value) + "]";
  }
  return line + "\n";
}

std::string section(const VerbText& verb) {
  std::string text = fmt::format(".SS {}\n{}\n", "avo " + verb.name, escaped(verb.description));
  text += ".PP\n" + synopsis(verb);
  for (const OptionText& option : verb.options)
    if (option.is_operand) text += entry(option);
  for (const OptionText& option : verb.options)
    if (!option.is_operand) text += entry(option);
  if (!verb.footer.empty()) text += ".PP\n" + escaped(verb.footer) + "\n";
  return text;
}

}  // namespace

std::string man_page(const ProgramText& text) {
  std::string page = fmt::format(
      ".TH AVO 1 \"\" \"avo {}\" \"User Commands\"\n"
      ".SH NAME\navo \\- {}\n"
      ".SH SYNOPSIS\n",
      avo::kVersion, escaped(text.program.description));
  for (const VerbText& verb : text.verbs) page += synopsis(verb) + ".br\n";
  page += ".SH OPTIONS\n";
  for (const OptionText& option : text.program.options) page += entry(option);
  page += ".SH VERBS\n";
  for (const VerbText& verb : text.verbs) page += section(verb);
  page += ".SH SCENES\nBuilt in are, with any number of robots in place of 10, 100 and 1000:\n";
  std::string names;
  for (const std::string& scene : text.scenes) names += (names.empty() ? "" : ", ") + scene;
  page += escaped(names) + ".\n";
  page += ".SH EXIT STATUS\n";
  for (const ExitCode& code : kExitCodes)
    page += fmt::format(".TP\n{}\n{}\n", bold(code.number), escaped(code.meaning));
  page +=
      ".SH ENVIRONMENT\n.TP\n" + bold("AVO_SIMD") +
      "\nThe instruction set: avx512, avx2, sse4, neon or scalar; auto, or nothing: the best that "
      "the machine has. The results have the same bits with each of them.\n";
  return page;
}

}  // namespace avo_cli
