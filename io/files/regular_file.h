// SPDX-License-Identifier: Apache-2.0
// Reading a whole file without being led astray by pipes, devices or size; or the standard input.
#pragma once
#include <string>

namespace avo_io {

/// The bytes of a regular file of at most 16 MiB. Throws FileError, and SceneError where it is
/// larger.
std::string read_regular_file(const std::string& path);

/// Whether there is nothing of that name.
bool is_missing(const std::string& path);

/// What messages call the standard input.
inline constexpr const char* kStandardInput = "standard input";

/// All that comes from there, at most 16 MiB. Throws FileError, and SceneError where it is more.
std::string read_standard_input();

/// "name: reason" of the present errno.
std::string with_errno(const std::string& name);

}  // namespace avo_io
