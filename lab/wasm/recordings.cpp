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
#include "io/space/space_rows.h"
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

/// The table that is read, of the plane or of space.
struct Table {
  std::unique_ptr<avo_io::RowSource> rows;
  std::unique_ptr<avo_io::SpaceRowSource> rows_of_space;
  std::int64_t most_robots = 0;  // their numbers are lower
};
Table table;

void require_few(std::int64_t robot, const std::string& place) {
  if (robot >= table.most_robots)
    throw avo_io::RecordingError(place + ": robot: found " + std::to_string(robot) +
                                 ", must be less than " + std::to_string(table.most_robots) +
                                 " to be shown here");
}

void append_time(double time, std::int64_t every, std::size_t rows, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {time, static_cast<double>(every), static_cast<double>(rows)});
}

/// Appends the next time, and returns whether there is one.
bool append_next_of_space(std::vector<double>& numbers) {
  const avo_io::SpaceMoment* moment = table.rows_of_space->next();
  if (moment == nullptr) return false;
  append_time(moment->time, moment->every, moment->rows.size(), numbers);
  for (const avo::space::CheckedState& row : moment->rows) {
    require_few(row.robot, table.rows_of_space->place(row.robot));
    numbers.insert(numbers.end(), {static_cast<double>(row.robot), row.position.x, row.position.y,
                                   row.position.z, row.velocity.x, row.velocity.y, row.velocity.z});
  }
  return true;
}

bool append_next(std::vector<double>& numbers) {
  if (table.rows_of_space) return append_next_of_space(numbers);
  avo_io::RecordedTime moment;
  if (!table.rows->next(moment)) return false;
  append_time(moment.time, moment.every, moment.rows.size(), numbers);
  for (const avo::CheckedState& row : moment.rows) {
    require_few(row.robot, table.rows->place(row.robot));
    const auto heading = row.heading.value_or(avo::CheckedHeading{NAN, NAN});
    numbers.insert(numbers.end(), {static_cast<double>(row.robot), row.position.x, row.position.y,
                                   row.velocity.x, row.velocity.y, heading.angle, heading.speed});
  }
  return true;
}

avo::CheckedState state_from(std::span<const double> row) {
  avo::CheckedState state{static_cast<std::int64_t>(row[0]), {row[1], row[2]}, {row[3], row[4]}};
  const double angle = row[5];
  if (std::isnan(angle)) return state;
  const double along = dot(avo::elementary::direction(angle), state.velocity) + 0.0;  // no -0
  state.heading = {angle, std::isnan(row[6]) ? along : row[6]};
  return state;
}

void append_lines(double time, std::span<const double> states, const avo_io::CsvForm& form,
                  std::string& lines) {
  const std::string first = avo_io::csv_time(time);
  for (; !states.empty(); states = states.subspan(kRow))
    append_csv_line(first, state_from(states), form, lines);
}

avo_io::SpaceMoment moment_from(double time, std::span<const double> states, std::int64_t every) {
  avo_io::SpaceMoment moment{time, {}, every};
  for (; !states.empty(); states = states.subspan(kRow))
    moment.rows.push_back({static_cast<std::int64_t>(states[0]),
                           {states[1], states[2], states[3]},
                           {states[4], states[5], states[6]}});
  return moment;
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
                  {"dimensions", header.space ? 3 : 2},
                  {"scene", scene}};
  return into_room(json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n' + texts);
}

/// Begins to read the host's file with the name in the room, as a table of that many dimensions
/// with so many robots at most.
AVO_EXPORT(void, open_table)(std::uint32_t dimensions, std::uint32_t most_robots) {
  const std::string name = Input(taken_from_room()).text();
  table = {nullptr, nullptr, most_robots};
  if (dimensions == 3)
    table.rows_of_space = avo_io::space_csv_rows(name);
  else
    table.rows = avo_io::csv_rows(name, {});
}

/// Reads the next times, and none at the end. Each time has the numbers s, steps from row to row
/// and rows. Each row has a robot's number, x, y, vx, vy, heading and speed. In space it has a
/// robot's number, x, y, z, vx, vy, vz.
AVO_EXPORT(std::size_t, read_table)() {
  std::vector<double> numbers;
  while (numbers.size() < kPart && append_next(numbers)) {
  }
  return into_room(std::as_bytes(std::span(numbers)));
}

/// Writes the times in the room, which have the same numbers. A heading that is NaN is none, and a
/// speed that is NaN is that of the velocity. `begins`: the first line names the columns.
AVO_EXPORT(std::size_t, write_table)
(std::uint32_t dimensions, bool headings, double every, bool begins) {
  const std::vector<std::byte> room = taken_from_room();
  std::vector<double> numbers(room.size() / sizeof(double));
  std::memcpy(numbers.data(), room.data(), numbers.size() * sizeof(double));
  const avo_io::CsvForm form{headings, static_cast<std::int64_t>(every)};
  std::string lines;
  if (begins) lines = dimensions == 3 ? avo_io::space_csv_header(form.every) : csv_header(form);
  for (std::span<const double> rest(numbers); !rest.empty();) {
    const auto rows = static_cast<std::size_t>(rest[2]) * kRow;
    const std::span<const double> time = rest.first(3), states = rest.subspan(3, rows);
    if (dimensions == 3)
      append_csv_lines(moment_from(time[0], states, form.every), lines);
    else
      append_lines(time[0], states, form, lines);
    rest = rest.subspan(3 + rows);
  }
  return into_room(lines);
}

}  // namespace avo_lab
