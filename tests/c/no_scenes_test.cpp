// SPDX-License-Identifier: Apache-2.0
// What a library says of scenes that was built without scene files.
#include "check.h"
#include "errors.h"
#include "scene_files.h"

int main() {
  REFUSES(avo_c::guarded([] { avo_c::load_scene("circle-10", {}); }), AVO_ERROR_UNSUPPORTED,
          "without scene files");
  REFUSES(avo_c::guarded([] { avo_c::parse_scene("version: 1", "a.yaml", {}); }),
          AVO_ERROR_UNSUPPORTED, "without scene files");
  return 0;
}
