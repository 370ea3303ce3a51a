// SPDX-License-Identifier: Apache-2.0
// Parts of the names of files, as text.
#include "io/files/file_names.h"

namespace avo_io {

std::string folder_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (slash == path.npos) return "";
  const std::size_t last = path.find_last_not_of('/', slash);
  return std::string(path.substr(0, last == path.npos ? slash + 1 : last + 1));
}

std::string file_name_of(std::string_view path) {
  return std::string(path.substr(path.rfind('/') + 1));  // npos + 1 is 0
}

std::string stem_of(std::string_view path) {
  const std::string name = file_name_of(path);
  const std::size_t dot = name.rfind('.');
  if (dot == name.npos || dot == 0 || name == "..") return name;
  return name.substr(0, dot);
}

std::string path_in(std::string_view folder, std::string_view file) {
  std::string path(file.starts_with('/') ? std::string_view() : folder);
  if (!path.empty() && !path.ends_with('/')) path += '/';
  return path.append(file);
}

}  // namespace avo_io
