// SPDX-License-Identifier: Apache-2.0
// The files that a command line names, looked at before any of them is opened for writing.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verbs/verbs.h"

namespace avo_cli {

/// Throws UsageError where two outputs, the standard output among them, are one file, or where one
/// is an input. Devices and pipes may be shared, the standard output may not.
void require_distinct(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// What messages call the scene.
std::string name_of(const SceneArguments& arguments);
/// The file that is read for the scene; none for a built-in one.
NamedFile file_of(const SceneArguments& arguments);

/// Throws UsageError where the name ends like that of another format. Without an ending, and for
/// devices and pipes, any name will do.
void require_ending(const NamedFile& file, const std::vector<std::string_view>& endings);
/// The same for figures, which have to have one of three.
void require_figure(const NamedFile& file);

/// The bytes of a figure. Throws avo_io::FileError where they cannot be drawn.
std::string drawn(const std::function<std::string()>& draw);

}  // namespace avo_cli
