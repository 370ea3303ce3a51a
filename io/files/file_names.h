// SPDX-License-Identifier: Apache-2.0
// Parts of the names of files, as text, by the rules of POSIX on every system.
#pragma once
#include <string>
#include <string_view>

namespace avo_io {

/// Returns the text in front of the last "/"; empty if there is none.
std::string folder_of(std::string_view path);
/// Returns the text behind the last "/".
std::string file_name_of(std::string_view path);
/// Returns the file name without its last extension: "b" of "a/b.yaml".
std::string stem_of(std::string_view path);
/// Returns `file`, relative to `folder` unless it begins with "/".
std::string path_in(std::string_view folder, std::string_view file);

}  // namespace avo_io
