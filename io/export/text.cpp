// SPDX-License-Identifier: Apache-2.0
// Exports as text by frames, in two formats: of the Pedestrian Dynamics Data Archive, as PedPy
// reads it, and of ETH and UCY (obsmat.txt).
#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

#include "io/export/target.h"

namespace avo_io {
namespace {

/// The frame rate stands at the front, and is known at the second time.
class TextExport final : public ExportTarget {
 public:
  TextExport(OutputFile& file, bool obsmat) : file_(file), obsmat_(obsmat) {}
  void add(const ExportedTime& moment) override;
  void finish(double fps) override {
    begin(fps);
    file_.write(rows_);
  }

 private:
  void begin(double fps);

  OutputFile& file_;
  bool obsmat_, begun_ = false;
  std::string rows_;
};

void TextExport::begin(double fps) {
  if (begun_) return;
  begun_ = true;
  file_.write(fmt::format("# framerate: {}\n# {}\n", fps,
                          obsmat_ ? "frame id x/m z/m y/m vx vz vy" : "id frame x/m y/m z/m"));
}

void TextExport::add(const ExportedTime& moment) {
  if (moment.fps > 0.0) {
    begin(moment.fps);
    file_.write(rows_);
    rows_.clear();
  }
  const auto end = std::back_inserter(rows_);
  for (const avo::CheckedState& row : moment.recorded.rows) {
    const avo::Vec2 p = row.position, v = row.velocity;
    if (obsmat_)
      fmt::format_to(end, FMT_COMPILE("{} {} {} 0 {} {} 0 {}\n"), moment.frame, row.robot, p.x, p.y,
                     v.x, v.y);
    else
      fmt::format_to(end, FMT_COMPILE("{} {} {} {} 0\n"), row.robot, moment.frame, p.x, p.y);
  }
}

}  // namespace

std::unique_ptr<ExportTarget> export_text(const ExportPlace& place, bool obsmat) {
  return std::make_unique<TextExport>(place.file, obsmat);
}

}  // namespace avo_io
