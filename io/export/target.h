// SPDX-License-Identifier: Apache-2.0
// The output of an export, which takes a recording one time after the other.
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "avo_io/convert.h"
#include "avo_io/output_file.h"
#include "avo_io/recording.h"

namespace avo_io {

/// m/s: a slower robot has no direction of motion. The square of such a speed does not underflow.
inline constexpr double kAtRest = 1e-12;

/// One time of a recording, and the data that formats need besides its rows.
struct ExportedTime {
  const RecordedTime& recorded;
  std::int64_t frame = 0;  ///< for formats that have frames
  double fps = 0.0;        ///< for formats that have frames; 0: not known yet, at the first time
  /// for each row: the direction that the robot faces, of length 1
  const std::vector<avo::Vec2>& faces;
};

class ExportTarget {
 public:
  virtual ~ExportTarget() = default;
  virtual void add(const ExportedTime& moment) = 0;
  /// Ends the output; call it once after the last add(). `fps` is for formats that have frames.
  virtual void finish(double fps) = 0;
};

/// The place that a target writes to; both members outlive the target.
struct ExportPlace {
  OutputFile& file;
  const std::string& name;  ///< the name in messages
};

/// Returns an export with the columns of the first time.
std::unique_ptr<ExportTarget> export_csv(const ExportPlace& place);
/// These two write to OutputFile::temporary(). `scenario` may be null.
std::unique_ptr<ExportTarget> export_sqlite(const ExportPlace& place,
                                            const avo::Scenario* scenario);
std::unique_ptr<ExportTarget> export_pedestrian(const ExportPlace& place,
                                                const avo::Scenario* scenario);
/// `obsmat`: the layout of ETH and UCY.
std::unique_ptr<ExportTarget> export_text(const ExportPlace& place, bool obsmat);
std::unique_ptr<ExportTarget> export_mcap(const ExportPlace& place, const avo::Scenario& scenario);

}  // namespace avo_io
