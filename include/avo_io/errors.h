// SPDX-License-Identifier: Apache-2.0
// Errors at the boundary, by their cause.
#pragma once
#include <string>

#include "avo/error.h"
#include "avo/export.h"

namespace avo_io {

/// A scene that cannot be used: "file:line:column: what, found, allowed, did you mean ...".
class AVO_API SceneError : public avo::Error {
 public:
  using avo::Error::Error;
};

/// The same fault in a key=value given besides the file: "--set key=value: ...".
class AVO_API OverrideError : public avo::Error {
 public:
  using avo::Error::Error;
};

/// A recording that cannot be used: "file:line: what, found, allowed".
class AVO_API RecordingError : public avo::Error {
 public:
  using avo::Error::Error;
};

/// A file that cannot be read or written: name and reason. broken_pipe: its reader went away.
class AVO_API FileError : public avo::Error {
 public:
  explicit FileError(const std::string& message, bool broken_pipe = false)
      : avo::Error(message), broken_pipe_(broken_pipe) {}
  [[nodiscard]] bool broken_pipe() const { return broken_pipe_; }

 private:
  bool broken_pipe_;
};

}  // namespace avo_io
