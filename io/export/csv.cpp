// SPDX-License-Identifier: Apache-2.0
// Exports as CSV: the same bytes that the run would have written.
#include <algorithm>
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "avo_io/errors.h"
#include "io/export/target.h"

namespace avo_io {
namespace {

class CsvExport final : public ExportTarget {
 public:
  explicit CsvExport(OutputFile& file) : file_(file) {}
  void add(const ExportedTime& moment) override;
  void finish(double /*fps*/) override {}

 private:
  void begin(const RecordedTime& first);

  OutputFile& file_;
  bool begun_ = false, headings_ = false, thinned_ = false, estimated_ = false;
  std::string rows_;
};

void CsvExport::begin(const RecordedTime& first) {
  begun_ = true;
  headings_ = std::any_of(first.rows.begin(), first.rows.end(),
                          [](const avo::CheckedState& row) { return row.heading.has_value(); });
  thinned_ = first.every > 1;
  estimated_ = first.estimated;
  file_.write(fmt::format("time,robot,x,y,vx,vy{}{}{}\n", headings_ ? ",heading,speed" : "",
                          thinned_ ? ",every" : "", estimated_ ? ",estimated" : ""));
}

void CsvExport::add(const ExportedTime& moment) {
  if (!begun_) begin(moment.recorded);
  const auto end = std::back_inserter(rows_);
  const std::string time = fmt::format("{}", moment.recorded.time);
  const std::string last = (thinned_ ? fmt::format(",{}", moment.recorded.every) : "") +
                           (estimated_ ? moment.recorded.estimated ? ",1\n" : ",0\n" : "\n");
  rows_.clear();
  for (const avo::CheckedState& row : moment.recorded.rows) {
    const avo::Vec2 p = row.position, v = row.velocity;
    fmt::format_to(end, FMT_COMPILE("{},{},{},{},{},{}"), time, row.robot, p.x, p.y, v.x, v.y);
    if (row.heading && !headings_)
      throw RecordingError(
          fmt::format("found a heading of robot {}, must have one at the first time", row.robot));
    if (row.heading)
      fmt::format_to(end, FMT_COMPILE(",{},{}"), row.heading->angle, row.heading->speed);
    else if (headings_)
      rows_ += ",,";
    rows_ += last;
  }
  file_.write(rows_);
}

}  // namespace

std::unique_ptr<ExportTarget> export_csv(const ExportPlace& place) {
  return std::make_unique<CsvExport>(place.file);
}

}  // namespace avo_io
