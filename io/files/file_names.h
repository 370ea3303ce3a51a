// SPDX-License-Identifier: Apache-2.0
// Parts of the names of files, as text: of POSIX, whatever system it is.
#pragma once
#include <string>
#include <string_view>

namespace avo_io {

/// What is in front of the last "/"; empty where there is none.
std::string folder_of(std::string_view path);
/// What is behind it.
std::string file_name_of(std::string_view path);
/// That without its last extension: "b" of "a/b.yaml".
std::string stem_of(std::string_view path);
/// `file`, relative to `folder` unless it begins with "/".
std::string path_in(std::string_view folder, std::string_view file);

}  // namespace avo_io
