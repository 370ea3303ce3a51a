// SPDX-License-Identifier: Apache-2.0
// Files that are whole or do not exist.
#pragma once
#include <cstdio>
#include <span>
#include <stdexcept>
#include <string>

#include "avo/check.h"
#include "avo/simulation.h"

namespace avo::safety {

struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file that is written beside the path and renamed by commit(); without commit() it is removed.
/// Throws OutputError.
class Output {
 public:
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  void write(const std::string& text);
  void commit();

 private:
  [[noreturn]] void fail(int reason);
  std::string path_, temporary_;
  std::FILE* file_;
};

/// CSV with header "time,robot,x,y,vx,vy", 17 significant digits, rows by time, then by robot. With
/// headings, ",heading,speed" follow; they are empty for robots without headings.
class Recording {
 public:
  explicit Recording(const std::string& path, bool headings = false);
  void add(const Simulation& simulation);
  void add(double time, std::span<const CheckedState> rows);
  void commit() { output_.commit(); }

 private:
  Output output_;
  bool headings_;
};

}  // namespace avo::safety
