// SPDX-License-Identifier: Apache-2.0
// The files that a command line names, checked before any of them is opened for writing.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verbs/verbs.h"

namespace avo_cli {

/// Throws UsageError if two outputs (including the standard output) are one file, or if an output
/// is also an input. Outputs may share devices and pipes, but not the standard output.
void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Returns the name of the scene in messages.
std::string name_of(const SceneArguments& arguments);
/// Returns the file of the scene; none for a built-in one.
NamedFile file_of(const SceneArguments& arguments);

/// Throws UsageError if the ending of the name is that of another format. A name without an ending,
/// and names of devices and pipes, are always accepted.
void require_ending(const NamedFile& file, const std::vector<std::string_view>& endings);
/// Does the same for figures; they must have one of three endings.
void require_figure(const NamedFile& file);

/// Returns the bytes of a figure. Throws avo_io::FileError if it cannot be drawn.
std::string drawn(const std::function<std::string()>& draw);

}  // namespace avo_cli
