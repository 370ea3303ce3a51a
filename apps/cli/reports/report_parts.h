// SPDX-License-Identifier: Apache-2.0
// Parts that pages of recordings and of sweeps share.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "avo_io/recorded_run.h"

namespace avo_cli {

/// Returns a word of a command, quoted for a shell if necessary.
std::string shell_word(const std::string& word);
/// Returns " --set KEY=VALUE" for each override.
std::string set_options(const std::vector<std::string>& overrides);

/// Returns a part of a page under its own heading.
std::string page_section(const std::string& heading, const std::string& html);
/// Returns the same for text, shown verbatim.
std::string page_text(const std::string& heading, const std::string& text);
/// Returns figures side by side.
std::string page_figures(const std::string& heading, const std::string& images);
/// Returns the run in motion, as a drawing; it is for builds without the lab. views: see
/// drawing_of().
std::string page_replay(const std::string& heading, const avo_io::RecordedRun& run,
                        std::size_t views = 1);
/// Returns the lab, which opens that input (lab_page.h); the build must have the lab.
std::string page_lab(const std::string& heading, const std::string& input);
/// Returns the lab, which plays a recording with so many robots; the build must have the lab.
std::string page_lab_of(const std::string& recording, std::int64_t robots);
/// Returns the whole page with its sections in order.
std::string page_of(const std::string& title, const std::string& subtitle,
                    const std::vector<std::string>& sections);

}  // namespace avo_cli
