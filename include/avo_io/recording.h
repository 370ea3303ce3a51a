// SPDX-License-Identifier: Apache-2.0
// What a run leaves behind: a table of all states, and one object of results.
#pragma once
#include <string>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/output_file.h"

namespace avo_io {

/// CSV with header "time,robot,x,y,vx,vy", 17 significant digits, rows by time then robot.
class CsvRecording {
 public:
  explicit CsvRecording(const std::string& path);
  /// One row a robot. Throws FileError.
  void add(const avo::Simulation& simulation);
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
};

/// One JSON object, keys in a fixed order; what there is not is null.
std::string to_json(const avo::RunSummary& summary);

}  // namespace avo_io
