// SPDX-License-Identifier: Apache-2.0
// Reading a whole file without being led astray by pipes, devices or size.
#pragma once
#include <string>

namespace avo_io {

/// The bytes of a regular file of at most 16 MiB. Throws FileError.
std::string read_regular_file(const std::string& path);

/// "name: reason" of the present errno.
std::string with_errno(const std::string& name);

}  // namespace avo_io
