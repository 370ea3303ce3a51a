// SPDX-License-Identifier: Apache-2.0
// Trajectories of JuPedSim's database, versions 1 and 2: the table trajectory_data, and the frame
// rate in the table metadata.
#include <fmt/format.h>
#include <sqlite3.h>

#include "avo_io/errors.h"
#include "io/recording/row_numbers.h"
#include "io/recording/tracks.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

/// A database that is open for reading, and one statement at a time.
class TrackDatabase {
 public:
  explicit TrackDatabase(const std::string& path) : path_(path) {
    // a name such as :memory: is a file here
    const std::string file = path.starts_with('/') ? path : "./" + path;
    require(sqlite3_open_v2(file.c_str(), &database_, SQLITE_OPEN_READONLY, nullptr));
    sqlite3_db_config(database_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  }
  TrackDatabase(const TrackDatabase&) = delete;
  TrackDatabase& operator=(const TrackDatabase&) = delete;
  ~TrackDatabase() {
    sqlite3_finalize(statement_);
    sqlite3_close_v2(database_);
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw RecordingError(fmt::format("{}: {}", path_, what));
  }
  void prepare(const char* text) {
    sqlite3_finalize(statement_);
    statement_ = nullptr;
    require(sqlite3_prepare_v2(database_, text, -1, &statement_, nullptr));
  }
  bool step() {
    const int result = sqlite3_step(statement_);
    if (result == SQLITE_ROW) return true;
    require(result);
    return false;
  }
  [[nodiscard]] bool is_number(int column) const {
    const int type = sqlite3_column_type(statement_, column);
    return type == SQLITE_INTEGER || type == SQLITE_FLOAT;
  }
  [[nodiscard]] bool is_integer(int column) const {
    return sqlite3_column_type(statement_, column) == SQLITE_INTEGER;
  }
  [[nodiscard]] double number(int column) const {
    return sqlite3_column_double(statement_, column);
  }
  [[nodiscard]] std::int64_t integer(int column) const {
    return sqlite3_column_int64(statement_, column);
  }
  [[nodiscard]] std::string text(int column) const {
    const unsigned char* bytes = sqlite3_column_text(statement_, column);
    const int size = sqlite3_column_bytes(statement_, column);
    return bytes == nullptr ? "" : std::string(bytes, bytes + size);
  }

 private:
  void require(int result) const {
    if (result == SQLITE_OK || result == SQLITE_DONE) return;
    if (result == SQLITE_CANTOPEN || result == SQLITE_IOERR)
      throw FileError(fmt::format("{}: SQLite cannot read it: {}", path_, sqlite3_errstr(result)));
    refuse(fmt::format("found a database that SQLite cannot read ({}), must be JuPedSim's",
                       database_ == nullptr ? sqlite3_errstr(result) : sqlite3_errmsg(database_)));
  }

  std::string path_;
  sqlite3* database_ = nullptr;
  sqlite3_stmt* statement_ = nullptr;
};

// Requires tables: a view could contain any program.
void require_tables(TrackDatabase& database) {
  for (const char* table : {"trajectory_data", "metadata"}) {
    const std::string query =
        fmt::format("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = '{}'", table);
    database.prepare(query.c_str());
    if (!database.step())
      database.refuse(
          fmt::format("found no table {}, must be there, as JuPedSim writes it", table));
  }
}

std::string metadata(TrackDatabase& database, const char* key) {
  const std::string query = fmt::format("SELECT value FROM metadata WHERE key = '{}'", key);
  database.prepare(query.c_str());
  if (!database.step()) database.refuse(fmt::format("metadata: found no {}, must be there", key));
  return database.text(0);
}

}  // namespace

bool is_sqlite(std::string_view begin) {
  return begin.starts_with(std::string_view("SQLite format 3\0", 16));
}

// doubles represent all of them exactly
constexpr std::int64_t kMostFrames = std::int64_t{1} << 53U;

TrackTable read_pedestrian_sqlite(const std::string& path) {
  TrackDatabase database(path);
  require_tables(database);
  const std::string version = metadata(database, "version");
  if (version != "1" && version != "2")
    database.refuse(fmt::format("metadata: version: found {}, must be 1 or 2", in_quotes(version)));
  const std::string rate = metadata(database, "fps");
  const auto fps = parsed(rate);
  if (!fps || !(*fps > 0.0 && *fps <= 1e9))
    database.refuse(fmt::format("metadata: fps: found {}, must be > 0", in_quotes(rate)));
  TrackTable table{path, *fps, {}};
  database.prepare("SELECT frame, id, pos_x, pos_y FROM trajectory_data");
  while (database.step()) {
    const std::int64_t frame = database.integer(0), id = database.integer(1);
    const bool numbers = database.is_integer(0) && database.is_integer(1) &&
                         database.is_number(2) && database.is_number(3);
    if (!numbers || frame < 0 || frame > kMostFrames || id < 0 || id > kMostFrames)
      database.refuse(
          fmt::format("trajectory_data: found a row [{}, {}, {}, {}], must be frame and "
                      "id, integers from 0 to 2^53, and pos_x and pos_y, numbers",
                      in_quotes(database.text(0)), in_quotes(database.text(1)),
                      in_quotes(database.text(2)), in_quotes(database.text(3))));
    add_track_row(table, {id, frame, {database.number(2), database.number(3)}, {}});
  }
  return table;
}

}  // namespace avo_io
