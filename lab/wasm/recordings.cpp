// SPDX-License-Identifier: Apache-2.0
// Recordings: the headers of HDF5 and spools are read. Tables of states as text are read from the
// host's file, and written, as by the command line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "avo_io/errors.h"
#include "core/elementary.h"
#include "host.h"
#include "io/files/byte_source.h"
#include "io/recording/csv_lines.h"
#include "io/recording/recording_fields.h"
#include "io/recording/row_source.h"
#include "io/text/json.h"

/// Puts the next bytes of the host's file at `to`, at most `size`; returns their number, which is 0
/// at the end.
extern "C" __attribute__((import_module("avo"), import_name("read_file"))) std::size_t
avo_read_file_in_host(char* to, std::size_t size);

namespace avo_io {
namespace {

struct HostBytes final : ByteSource {
  std::size_t read(std::span<char> bytes) override {
    return avo_read_file_in_host(bytes.data(), bytes.size());
  }
};

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::string& /*path*/) {
  return std::make_unique<HostBytes>();
}

}  // namespace avo_io

namespace avo_lab {
namespace {

using avo_io::Json;

constexpr std::size_t kPart = std::size_t{1} << 17U;  // numbers
constexpr std::size_t kRow = 7;                       // numbers of a robot

/// The table that is read.
struct Table {
  std::unique_ptr<avo_io::RowSource> rows;
  std::int64_t most_robots = 0;  // their numbers are lower
};
Table table;

void append_time(const avo_io::RecordedTime& moment, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {moment.time, static_cast<double>(moment.every),
                                 static_cast<double>(moment.rows.size())});
  for (const avo::CheckedState& row : moment.rows) {
    if (row.robot >= table.most_robots)
      throw avo_io::RecordingError(table.rows->place(row.robot) + ": robot: found " +
                                   std::to_string(row.robot) + ", must be less than " +
                                   std::to_string(table.most_robots) + " to be shown here");
    const auto heading = row.heading.value_or(avo::CheckedHeading{NAN, NAN});
    numbers.insert(numbers.end(), {static_cast<double>(row.robot), row.position.x, row.position.y,
                                   row.velocity.x, row.velocity.y, heading.angle, heading.speed});
  }
}

avo::CheckedState state_from(std::span<const double> row) {
  avo::CheckedState state{static_cast<std::int64_t>(row[0]), {row[1], row[2]}, {row[3], row[4]}};
  const double angle = row[5];
  if (std::isnan(angle)) return state;
  const double along = dot(avo::elementary::direction(angle), state.velocity) + 0.0;  // no -0
  state.heading = {angle, std::isnan(row[6]) ? along : row[6]};
  return state;
}

}  // namespace

/// Reads the header of a recording from its fields in the room, see avo_io::packed(). Returns a
/// line of JSON, and then the texts of the scene's files, one after the other.
AVO_EXPORT(std::size_t, recording_header)() {
  const std::vector<std::byte> room = taken_from_room();
  const auto fields = avo_io::unpacked({reinterpret_cast<const char*>(room.data()), room.size()});
  if (!fields)
    throw avo_io::RecordingError(
        "found no whole header, cut off or damaged, must be that of a recording of avo");
  const avo_io::RecordingHeader header = avo_io::header_from(avo_io::from_parts(*fields));
  if (header.space)
    throw avo_io::RecordingError("found a recording of space, must be one of the plane here");
  Json files = Json::array();
  std::string texts;
  for (const avo_io::SceneFile& file : header.scene.files) {
    files.push_back({{"path", file.path}, {"builtin", file.builtin}, {"size", file.text.size()}});
    texts += file.text;
  }
  const Json scene{{"name", header.scene.name},
                   {"yaml", header.scene.yaml},
                   {"overrides", header.scene.overrides},
                   {"files", files},
                   {"start_at_rest", header.scene.start_at_rest},
                   {"limit_speed", header.scene.limit_speed}};
  const Json json{{"robots", header.robots},
                  {"every", header.every},
                  {"headings", header.headings},
                  {"scene", scene}};
  return into_room(json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n' + texts);
}

/// Begins to read the host's file, whose name is in the room, as a table with so many robots at
/// most.
AVO_EXPORT(void, open_table)(std::uint32_t most_robots) {
  table = {avo_io::csv_rows(Input(taken_from_room()).text(), {}), most_robots};
}

/// Reads the next times, and none at the end. Each time has the numbers s, steps from row to row
/// and rows, and each row has a robot's number, x, y, vx, vy, heading and speed.
AVO_EXPORT(std::size_t, read_table)() {
  std::vector<double> numbers;
  avo_io::RecordedTime moment;
  while (numbers.size() < kPart && table.rows->next(moment)) append_time(moment, numbers);
  return into_room(std::as_bytes(std::span(numbers)));
}

/// Writes the times in the room, which have the same numbers. A heading that is NaN is none, and a
/// speed that is NaN is that of the velocity. `begins`: the first line names the columns.
AVO_EXPORT(std::size_t, write_table)(bool headings, double every, bool begins) {
  const std::vector<std::byte> room = taken_from_room();
  std::vector<double> numbers(room.size() / sizeof(double));
  std::memcpy(numbers.data(), room.data(), numbers.size() * sizeof(double));
  const avo_io::CsvForm form{headings, static_cast<std::int64_t>(every)};
  std::string lines = begins ? avo_io::csv_header(form) : "";
  for (std::span<const double> rest(numbers); !rest.empty();) {
    const std::string time = avo_io::csv_time(rest[0]);
    const auto rows = static_cast<std::size_t>(rest[2]);
    rest = rest.subspan(3);
    for (std::size_t k = 0; k < rows; ++k, rest = rest.subspan(kRow))
      append_csv_line(time, state_from(rest), form, lines);
  }
  return into_room(lines);
}

}  // namespace avo_lab
