// SPDX-License-Identifier: Apache-2.0
// Exports as JuPedSim's database, version 2: the same tables that its SqliteTrajectoryWriter makes.
#include <cmath>
#include <fmt/format.h>
#include <sqlite3.h>
#include <utility>

#include "avo_io/errors.h"
#include "io/export/area.h"
#include "io/export/target.h"

namespace avo_io {
namespace {

constexpr const char* kTables = R"(
PRAGMA journal_mode = OFF;
PRAGMA synchronous = OFF;
BEGIN;
CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL,
  pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL);
CREATE TABLE metadata (key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL);
CREATE TABLE frame_data (frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);
)";
constexpr const char* kIndices = R"(
CREATE UNIQUE INDEX geometry_hash ON geometry(hash);
CREATE INDEX frame_id_idx ON trajectory_data(frame, id);
COMMIT;
)";
// Identifies the only geometry; any number would do.
constexpr std::int64_t kGeometry = 1;

/// An open database, or a statement in it, with the name that messages use for it.
class Database {
 public:
  Database(const std::string& path, std::string name) : name_(std::move(name)) {
    require(sqlite3_open_v2(path.c_str(), &database_, SQLITE_OPEN_READWRITE, nullptr));
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() { sqlite3_close_v2(database_); }

  void require(int result) const {
    if (result == SQLITE_OK || result == SQLITE_DONE) return;
    throw FileError(fmt::format("{}: SQLite cannot write it: {}", name_, sqlite3_errstr(result)));
  }
  void execute(const char* statements) const {
    require(sqlite3_exec(database_, statements, nullptr, nullptr, nullptr));
  }
  [[nodiscard]] sqlite3* get() const { return database_; }

 private:
  std::string name_;
  sqlite3* database_ = nullptr;
};

class Insertion {
 public:
  Insertion(const Database& database, const char* statement) : database_(database) {
    database.require(sqlite3_prepare_v2(database.get(), statement, -1, &statement_, nullptr));
  }
  Insertion(const Insertion&) = delete;
  Insertion& operator=(const Insertion&) = delete;
  ~Insertion() { sqlite3_finalize(statement_); }

  template <typename... Values>
  void insert(const Values&... values) {
    int column = 0;
    (bind(++column, values), ...);
    database_.require(sqlite3_step(statement_));
    database_.require(sqlite3_reset(statement_));
  }

 private:
  void bind(int column, std::int64_t value) {
    database_.require(sqlite3_bind_int64(statement_, column, value));
  }
  void bind(int column, double value) {
    database_.require(sqlite3_bind_double(statement_, column, value));
  }
  void bind(int column, const std::string& value) {
    database_.require(sqlite3_bind_text64(statement_, column, value.data(), value.size(),
                                          SQLITE_TRANSIENT, SQLITE_UTF8));
  }

  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

class SqliteExport final : public ExportTarget {
 public:
  SqliteExport(const ExportPlace& place, const avo::Scenario* scenario)
      : database_(place.file.temporary(), place.name),
        area_((database_.execute(kTables), scenario)),
        rows_(database_, "INSERT INTO trajectory_data VALUES (?, ?, ?, ?, ?, ?)"),
        frames_(database_, "INSERT INTO frame_data VALUES (?, ?)") {}

  void add(const ExportedTime& moment) override {
    area_.add(moment.recorded);
    frames_.insert(moment.frame, kGeometry);
    for (std::size_t k = 0; k < moment.recorded.rows.size(); ++k) {
      const avo::CheckedState& row = moment.recorded.rows[k];
      const avo::Vec2 face = moment.faces[k];
      rows_.insert(moment.frame, row.robot, row.position.x, row.position.y, face.x, face.y);
    }
  }

  void finish(double fps) override {
    const WalkableArea area = area_.found();
    Insertion(database_, "INSERT INTO geometry VALUES (?, ?)").insert(kGeometry, area.wkt);
    Insertion metadata(database_, "INSERT INTO metadata VALUES (?, ?)");
    metadata.insert(std::string("version"), std::string("2"));
    const std::pair<const char*, double> numbers[] = {{"fps", fps},
                                                      {"xmin", area.min.x},
                                                      {"xmax", area.max.x},
                                                      {"ymin", area.min.y},
                                                      {"ymax", area.max.y}};
    for (const auto& [key, value] : numbers)
      metadata.insert(std::string(key), fmt::format("{}", value));
    database_.execute(kIndices);
  }

 private:
  Database database_;
  AreaFinder area_;
  Insertion rows_, frames_;
};

}  // namespace

std::unique_ptr<ExportTarget> export_sqlite(const ExportPlace& place,
                                            const avo::Scenario* scenario) {
  return std::make_unique<SqliteExport>(place, scenario);
}

}  // namespace avo_io
