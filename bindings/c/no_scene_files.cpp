// SPDX-License-Identifier: Apache-2.0
// Scenes without avo_io, and in avo_c_core: there are none.
#include "errors.h"
#include "scene_files.h"

namespace avo_c {
namespace {

[[noreturn]] void fail_as_unsupported() {
  fail(AVO_ERROR_UNSUPPORTED,
       "scenes: found a library without scene files, must be avo_c of a build with AVO_IO");
}

}  // namespace

avo::Scenario load_scene(const std::string&, const std::vector<std::string>&) {
  fail_as_unsupported();
}

avo::Scenario parse_scene(std::string_view, const std::string&, const std::vector<std::string>&) {
  fail_as_unsupported();
}

avo::space::Scenario load_space_scene(const std::string&, const std::vector<std::string>&) {
  fail_as_unsupported();
}

}  // namespace avo_c
