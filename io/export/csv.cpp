// SPDX-License-Identifier: Apache-2.0
// Exports as CSV: the same bytes that the run would have written.
#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "avo_io/errors.h"
#include "io/export/target.h"
#include "io/recording/csv_lines.h"

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
  std::optional<CsvForm> form_;  // set by the first time
  std::string rows_;
};

void CsvExport::begin(const RecordedTime& first) {
  form_.emplace();
  form_->headings = std::any_of(first.rows.begin(), first.rows.end(),
                                [](const auto& row) { return row.heading.has_value(); });
  form_->thinned = first.every > 1;
  if (first.estimated) form_->estimated = true;
  file_.write(csv_header(*form_));
}

void CsvExport::add(const ExportedTime& moment) {
  if (!form_) begin(moment.recorded);
  form_->every = moment.recorded.every;
  if (form_->estimated) form_->estimated = moment.recorded.estimated;
  const std::string time = csv_time(moment.recorded.time);
  rows_.clear();
  for (const avo::CheckedState& row : moment.recorded.rows) {
    if (row.heading && !form_->headings)
      throw RecordingError(
          fmt::format("found a heading of robot {}, must have one at the first time", row.robot));
    append_csv_line(time, row, *form_, rows_);
  }
  file_.write(rows_);
}

}  // namespace

std::unique_ptr<ExportTarget> export_csv(const ExportPlace& place) {
  return std::make_unique<CsvExport>(place.file);
}

}  // namespace avo_io
