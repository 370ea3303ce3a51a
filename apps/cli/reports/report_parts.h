// SPDX-License-Identifier: Apache-2.0
// What pages of recordings and of sweeps have in common.
#pragma once
#include <string>
#include <vector>

#include "avo_io/recorded_run.h"

namespace avo_cli {

/// A word of a command, in quotes that a shell takes away where it needs any.
std::string shell_word(const std::string& word);
/// " --set KEY=VALUE" for each.
std::string set_options(const std::vector<std::string>& overrides);

/// A part of a page under a heading of its own.
std::string page_section(const std::string& heading, const std::string& html);
/// The same of text as it is.
std::string page_text(const std::string& heading, const std::string& text);
/// Figures side by side.
std::string page_figures(const std::string& heading, const std::string& images);
/// The run in motion, as a drawing; for builds without the lab.
std::string page_replay(const std::string& heading, const avo_io::RecordedRun& run);
/// The lab, which opens that (lab_page.h); it must be there.
std::string page_lab(const std::string& heading, const std::string& input);
/// The whole page of its sections, in their order.
std::string page_of(const std::string& title, const std::string& subtitle,
                    const std::vector<std::string>& sections);

}  // namespace avo_cli
