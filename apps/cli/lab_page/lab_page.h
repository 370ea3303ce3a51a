// SPDX-License-Identifier: Apache-2.0
// The page of the lab, with its input embedded.
#pragma once
#include <string>
#include <string_view>

#include "avo_io/scene.h"

namespace avo_cli {

/// Returns the page as it was built; empty if the program was built without it (AVO_LAB).
std::string_view lab_page();

/// Returns the input of a page as JSON without "<". `embedded`: the page is part of another page.
std::string scene_input(const avo_io::SceneSource& source, bool embedded = false);
/// `scene`: for a recording that contains no scene; or null.
std::string recording_input(const std::string& name, std::string_view bytes,
                            const avo_io::SceneSource* scene, bool embedded = false);

/// Returns the page that opens that input. Throws std::logic_error if the page has no place for it.
std::string lab_page_with(std::string_view input);
/// Returns whether the file is such a page.
bool is_lab_page(const std::string& path);

}  // namespace avo_cli
