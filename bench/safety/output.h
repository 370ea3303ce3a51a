// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there.
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

/// Written beside the path and renamed by commit(); removed otherwise. Throws OutputError.
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

/// CSV with header "time,robot,x,y,vx,vy", 17 significant digits, rows by time then robot. With
/// headings, ",heading,speed" follow, empty for robots that have none.
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
