// SPDX-License-Identifier: Apache-2.0
// The part of a simulation's state that a recording keeps.
#include "io/recording/recorded_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "avo/checked.h"

namespace avo_io {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void add_states(const avo::Simulation& simulation, const BlockShape& shape, RecordingBlock& block) {
  using avo::Columns;
  const bool turns = shape.has_headings();
  const avo::FleetView fleet =
      simulation.fleet(Columns::id | Columns::position | Columns::velocity | Columns::plan |
                       (turns ? Columns::heading | Columns::setup : Columns{}));
  const std::size_t k = block.times++;
  block.time[k] = simulation.time();
  std::array<double*, kHeadingColumns.count> row{};
  for (std::size_t c = 0; c < shape.columns(); ++c) row[c] = block.row(shape, c, k);
  std::uint8_t* status = block.status.data() + k * shape.robots;
  std::size_t next = 0;  // robot without a row yet
  const auto leave_out_before = [&](std::size_t robot) {
    for (; next < robot; ++next) {
      for (std::size_t c = 0; c < shape.columns(); ++c) row[c][next] = kNoNumber;
      status[next] = kAbsent;
    }
  };
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    leave_out_before(fleet.id[i].value);
    row[0][next] = fleet.position[i].x;
    row[1][next] = fleet.position[i].y;
    row[2][next] = fleet.velocity[i].x;
    row[3][next] = fleet.velocity[i].y;
    if (turns) {
      const avo::CheckedState state = checked_state(fleet, i);
      row[4][next] = state.heading ? state.heading->angle : kNoNumber;
      row[5][next] = state.heading ? state.heading->speed : kNoNumber;
    }
    status[next] = static_cast<std::uint8_t>(fleet.plan[i].status);
    ++next;
  }
  leave_out_before(shape.robots);
}

void add_rows(const RecordedTime& moment, const BlockShape& shape, RecordingBlock& block) {
  const auto values = [](const avo::CheckedState& row) {
    return std::array{row.position.x,
                      row.position.y,
                      row.velocity.x,
                      row.velocity.y,
                      row.heading ? row.heading->angle : kNoNumber,
                      row.heading ? row.heading->speed : kNoNumber};
  };
  append_rows(moment.time, moment.rows, shape, static_cast<std::uint8_t>(avo::PlanStatus::optimal),
              values, block);
}

std::vector<avo::CheckedState> rows_of(const BlockShape& shape, const RecordingBlock& block,
                                       std::size_t time) {
  std::vector<avo::CheckedState> rows;
  const auto value = [&](std::size_t column, std::size_t robot) {
    return block.row(shape, column, time)[robot];
  };
  for (std::size_t i = 0; i < shape.robots; ++i) {
    if (block.status[time * shape.robots + i] == kAbsent) continue;
    avo::CheckedState& row = rows.emplace_back();
    row = {static_cast<std::int64_t>(i), {value(0, i), value(1, i)}, {value(2, i), value(3, i)}};
    if (shape.has_headings() && !std::isnan(value(4, i))) row.heading = {value(4, i), value(5, i)};
  }
  return rows;
}

void find_clearances(const BlockShape& shape, std::size_t time, avo::ClearanceFinder& clearances,
                     RecordingBlock& block) {
  const auto row = [&](std::size_t column) {
    return std::span<const double>(block.row(shape, column, time), shape.robots);
  };
  const bool headings = shape.has_headings();
  clearances.find({row(0), row(1), headings ? row(4) : std::span<const double>()},
                  {block.clearance.data() + time * shape.robots, shape.robots});
}

}  // namespace avo_io
