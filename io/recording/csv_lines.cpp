// SPDX-License-Identifier: Apache-2.0
// The lines of recordings as CSV: numbers have the fewest digits that read back to the same bits.
#include "io/recording/csv_lines.h"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <iterator>

namespace avo_io {

std::string csv_header(const CsvForm& form) {
  return fmt::format("time,robot,x,y,vx,vy{}{}{}\n", form.headings ? ",heading,speed" : "",
                     form.thinned ? ",every" : "", form.estimated ? ",estimated" : "");
}

std::string csv_time(double time) {
  return fmt::format("{}", time);
}

void append_csv_line(std::string_view time, const avo::CheckedState& state, const CsvForm& form,
                     std::string& lines) {
  const auto end = std::back_inserter(lines);
  const avo::Vec2 p = state.position, v = state.velocity;
  fmt::format_to(end, FMT_COMPILE("{},{},{},{},{},{}"), time, state.robot, p.x, p.y, v.x, v.y);
  if (form.headings && state.heading)
    fmt::format_to(end, FMT_COMPILE(",{},{}"), state.heading->angle, state.heading->speed);
  else if (form.headings)
    lines += ",,";
  if (form.thinned) fmt::format_to(end, FMT_COMPILE(",{}"), form.every);
  if (form.estimated) lines += *form.estimated ? ",1" : ",0";
  lines += '\n';
}

}  // namespace avo_io
