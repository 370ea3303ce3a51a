// SPDX-License-Identifier: Apache-2.0
// Reads a whole regular file, safe against pipes, devices and huge sizes; or the standard input.
#pragma once
#include <string>

namespace avo_io {

/// Returns the bytes of a regular file of at most 16 MiB. Throws FileError, and SceneError if it is
/// larger.
std::string read_regular_file(const std::string& path);

/// Returns whether no file of that name exists.
bool is_missing(const std::string& path);

/// The name of the standard input in messages.
inline constexpr const char* kStandardInput = "standard input";

/// Returns all bytes of the standard input, at most 16 MiB. Throws FileError, and SceneError if
/// there are more.
std::string read_standard_input();

/// Returns "name: reason" for the present errno.
std::string with_errno(const std::string& name);

}  // namespace avo_io
