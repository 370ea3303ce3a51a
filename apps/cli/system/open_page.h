// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace avo_cli {

/// Asks the desktop to open the file, and does not wait for it. Nothing happens if there is no
/// display, or if the standard output is not a terminal.
void open_page(const std::string& path);

}  // namespace avo_cli
