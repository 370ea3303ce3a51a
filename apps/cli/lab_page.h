// SPDX-License-Identifier: Apache-2.0
// The page of the lab, with what it opens inside.
#pragma once
#include <string>
#include <string_view>

#include "avo_io/scene.h"

namespace avo_cli {

/// The page as it was built; empty where the program was built without it (AVO_LAB).
std::string_view lab_page();

/// What a page opens, as JSON without "<". `embedded`: as a part of another page.
std::string scene_input(const avo_io::SceneSource& source, bool embedded = false);
/// `scene`: of a recording that has none in itself; or null.
std::string recording_input(const std::string& name, std::string_view bytes,
                            const avo_io::SceneSource* scene, bool embedded = false);

/// The page that opens it. Throws std::logic_error where the page has no place for it.
std::string lab_page_with(std::string_view input);
/// Whether the file is such a page.
bool is_lab_page(const std::string& path);

}  // namespace avo_cli
