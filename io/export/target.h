// SPDX-License-Identifier: Apache-2.0
// What a recording is written to, one time after the other.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "avo_io/convert.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"

namespace avo_io {

/// m/s: who is slower goes nowhere. Squares of speeds like it are numbers still.
inline constexpr double kAtRest = 1e-12;

/// One time with what formats need besides its rows.
struct ExportedTime {
  const RecordedTime& recorded;
  std::int64_t frame = 0;               ///< of the formats that have frames
  double fps = 0.0;                     ///< likewise; 0: not known yet, at the first time
  const std::vector<avo::Vec2>& faces;  ///< of each row: where it faces, of length 1
};

class ExportTarget {
 public:
  virtual ~ExportTarget() = default;
  virtual void add(const ExportedTime& moment) = 0;
  /// Once after the last add(). `fps`: of the formats that have frames.
  virtual void finish(double fps) = 0;
};

/// Where a target writes; both outlive it.
struct ExportPlace {
  OutputFile& file;
  const std::string& name;  ///< what messages call it
};

/// The columns are those of the first time.
std::unique_ptr<ExportTarget> export_csv(const ExportPlace& place);
/// These two write where OutputFile::temporary() is. `scenario`: may be none.
std::unique_ptr<ExportTarget> export_sqlite(const ExportPlace& place,
                                            const avo::Scenario* scenario);
std::unique_ptr<ExportTarget> export_pedestrian(const ExportPlace& place,
                                                const avo::Scenario* scenario);
/// `obsmat`: as ETH and UCY have it.
std::unique_ptr<ExportTarget> export_text(const ExportPlace& place, bool obsmat);
std::unique_ptr<ExportTarget> export_mcap(const ExportPlace& place, const avo::Scenario& scenario);

}  // namespace avo_io
