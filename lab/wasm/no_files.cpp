// SPDX-License-Identifier: Apache-2.0
// There are no files but those that a scene is given.
#include "avo_io/errors.h"
#include "regular_file.h"

namespace avo_io {

bool is_missing(const std::string& /*path*/) {
  return true;
}

std::string read_regular_file(const std::string& path) {
  throw FileError(path + ": found no files here");
}

}  // namespace avo_io
