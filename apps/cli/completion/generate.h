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

/// What a value of the command line is, as far as a shell can offer some.
enum class ValueKind {
  none,      ///< a flag has none
  anything,  ///< e.g. a number
  file,      ///< one of some endings
  scene,     ///< a built-in scene, or a file of some endings
  name,      ///< a built-in scene
  setting,   ///< key=value of a scene
  verb,
};

struct OptionText {
  std::vector<std::string> names;  ///< "-q", "--quiet"; of an operand one in capitals
  std::string value;               ///< what help calls its value; empty: it has none
  std::string description;
  ValueKind kind = ValueKind::none;
  std::vector<std::string> endings;  ///< of files, without the dot
  bool is_operand = false;
  bool is_required = false;
  bool repeats = false;
};

struct VerbText {
  std::string name;  ///< empty: of the program itself
  std::string description, footer;
  std::vector<OptionText> options;  ///< operands too
};

struct ProgramText {
  VerbText program;
  std::vector<VerbText> verbs;
  std::vector<std::string> scenes;  ///< of families a few
  std::vector<avo_io::SceneSetting> settings;
};

std::string man_page(const ProgramText& text);
std::string bash_completion(const ProgramText& text);
std::string zsh_completion(const ProgramText& text);

/// avo generate KIND: to the standard output. Throws UsageError where it is none of the three.
int print_generated(const CLI::App& app, const std::string& kind);

}  // namespace avo_cli
