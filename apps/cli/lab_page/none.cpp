// SPDX-License-Identifier: Apache-2.0
// An empty page, for a build without AVO_LAB.
#include "lab_page/lab_page.h"

namespace avo_cli {

std::string_view lab_page() {
  return {};
}

}  // namespace avo_cli
