// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace avo_cli {

/// Has the desktop open the file, and does not wait for it. Nothing happens where there is no
/// display, or the standard output is no terminal.
void open_page(const std::string& path);

}  // namespace avo_cli
