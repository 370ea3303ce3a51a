// SPDX-License-Identifier: Apache-2.0
// The manual page and the completions of shells, made from the tree of verbs and options.
#pragma once
#include <string>
#include <vector>

#include "avo_io/scene.h"

namespace CLI {
class App;
}

namespace avo_cli {

/// The kind of a value on the command line, as far as a shell can offer some.
enum class ValueKind {
  none,      ///< a flag has no value
  anything,  ///< e.g. a number
  file,      ///< a file with one of some endings
  scene,     ///< a built-in scene, or a file with one of some endings
  name,      ///< a built-in scene
  setting,   ///< key=value of a scene
  verb,
};

struct OptionText {
  std::vector<std::string> names;  ///< "-q", "--quiet"; an operand has one name in capitals
  std::string value;               ///< the name of its value in the help; empty: it has none
  std::string description;
  ValueKind kind = ValueKind::none;
  std::vector<std::string> endings;  ///< of files, without the dot
  bool is_operand = false;
  bool is_required = false;
  bool repeats = false;
};

struct VerbText {
  std::string name;  ///< empty: the program itself
  std::string description, footer;
  std::vector<OptionText> options;  ///< including operands
};

struct ProgramText {
  VerbText program;
  std::vector<VerbText> verbs;
  std::vector<std::string> scenes;  ///< for a family a few members
  std::vector<avo_io::SceneSetting> settings;
};

std::string man_page(const ProgramText& text);
std::string bash_completion(const ProgramText& text);
std::string zsh_completion(const ProgramText& text);

/// Prints what avo generate KIND prints, to the standard output. Throws UsageError if `kind` is
/// none of the three.
int print_generated(const CLI::App& app, const std::string& kind);

}  // namespace avo_cli
