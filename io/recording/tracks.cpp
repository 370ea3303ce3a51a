// SPDX-License-Identifier: Apache-2.0
// Converts a table of positions to rows of a recording: sorted, with velocities, and with the
// frames that are missing.
#include "io/recording/tracks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <tuple>
#include <utility>

#include "avo_io/errors.h"
#include "core/ranges.h"

namespace avo_io {

std::string place_of(const TrackTable& table, const TrackRow& row) {
  if (row.line > 0) return fmt::format("{}:{}", table.path, row.line);
  return fmt::format("{}: frame {}, id {}", table.path, row.frame, row.robot);
}

void add_track_row(TrackTable& table, const TrackRow& row) {
  if (table.rows.size() == kMostTrackRows)
    throw RecordingError(
        fmt::format("{}: found more than {} rows, must be fewer", table.path, kMostTrackRows));
  for (const double value : {row.position.x, row.position.y})
    if (!avo::kAnyValue.contains(value))
      throw RecordingError(fmt::format("{}: found {}, must be a finite number from -{:g} to {:g}",
                                       place_of(table, row), value, avo::kLargest, avo::kLargest));
  table.rows.push_back(row);
}

namespace {

class TrackRows final : public RowSource {
 public:
  TrackRows(TrackTable table, std::optional<std::int64_t> robots);
  bool next(RecordedTime& moment) override;
  [[nodiscard]] std::string place(std::optional<std::int64_t> robot) const override;
  [[nodiscard]] std::optional<double> frame_rate() const override {
    return table_.frames_per_second / static_cast<double>(common_);
  }

 private:
  void put_in_order(std::optional<std::int64_t> robots);
  void find_steps();
  void estimate_velocities();
  [[nodiscard]] double time_of(std::int64_t frame) const {
    return static_cast<double>(frame) / table_.frames_per_second;
  }
  [[nodiscard]] bool follows(std::int64_t frame, std::int64_t next) const {
    return 2 * (next - frame) <= 3 * step_;
  }

  TrackTable table_;
  std::int64_t step_ = 1;                // frames, from time to time: the median distance
  std::int64_t common_ = 1;              // frames: all distances between times are multiples of it
  std::size_t first_ = 0, next_ = 0;     // the rows of the last returned time, and the end of them
  std::optional<std::int64_t> missing_;  // a frame without rows that was returned last
};

TrackRows::TrackRows(TrackTable table, std::optional<std::int64_t> robots)
    : table_(std::move(table)) {
  put_in_order(robots);
  find_steps();
  if (table_.frames_per_second == 0.0)
    table_.frames_per_second = static_cast<double>(step_) / kSecondsApart;
  estimate_velocities();
}

void TrackRows::put_in_order(std::optional<std::int64_t> robots) {
  std::vector<TrackRow>& rows = table_.rows;
  std::sort(rows.begin(), rows.end(), [](const TrackRow& a, const TrackRow& b) {
    return std::tie(a.frame, a.robot, a.line) < std::tie(b.frame, b.robot, b.line);
  });
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (robots && rows[k].robot >= *robots)
      throw RecordingError(fmt::format("{}: found id {}, must be 0 to {}, the robots of the scene",
                                       place_of(table_, rows[k]), rows[k].robot, *robots - 1));
    if (k > 0 && rows[k].frame == rows[k - 1].frame && rows[k].robot == rows[k - 1].robot)
      throw RecordingError(fmt::format("{}: found id {} again in frame {}, must be once",
                                       place_of(table_, rows[k]), rows[k].robot, rows[k].frame));
  }
}

void TrackRows::find_steps() {
  std::vector<std::int64_t> steps;
  for (std::size_t k = 1; k < table_.rows.size(); ++k)
    if (table_.rows[k].frame != table_.rows[k - 1].frame)
      steps.push_back(table_.rows[k].frame - table_.rows[k - 1].frame);
  if (steps.empty())
    throw RecordingError(fmt::format("{}: found rows of {} frame{}, must be of two or more",
                                     table_.path, table_.rows.empty() ? "no" : "one",
                                     table_.rows.empty() ? "s" : ""));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  step_ = *middle;
  common_ = std::accumulate(steps.begin(), steps.end(), std::int64_t{0},
                            [](std::int64_t a, std::int64_t b) { return std::gcd(a, b); });
}

// Estimates velocities; a robot without a neighboring row in time gets velocity 0.
void TrackRows::estimate_velocities() {
  std::vector<TrackRow>& rows = table_.rows;
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&rows](std::size_t a, std::size_t b) {
    return std::tie(rows[a].robot, rows[a].frame) < std::tie(rows[b].robot, rows[b].frame);
  });
  const auto linked = [&](std::size_t k) {  // with the row before it in this order
    const TrackRow &a = rows[order[k - 1]], &b = rows[order[k]];
    return a.robot == b.robot && follows(a.frame, b.frame);
  };
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t from = k > 0 && linked(k) ? k - 1 : k;
    const std::size_t to = k + 1 < order.size() && linked(k + 1) ? k + 1 : k;
    if (from == to) continue;
    const TrackRow &a = rows[order[from]], &b = rows[order[to]];
    rows[order[k]].velocity = (b.position - a.position) / (time_of(b.frame) - time_of(a.frame));
  }
}

bool TrackRows::next(RecordedTime& moment) {
  const std::vector<TrackRow>& rows = table_.rows;
  moment.rows.clear();
  moment.every = 1;
  moment.estimated = true;
  if (next_ == rows.size()) return false;
  const std::int64_t frame = rows[next_].frame;
  if (next_ > 0 && !missing_ && !follows(rows[next_ - 1].frame, frame)) {
    missing_ = rows[next_ - 1].frame + step_;
    moment.time = time_of(*missing_);
    return true;
  }
  missing_.reset();
  moment.time = time_of(frame);
  for (first_ = next_; next_ < rows.size() && rows[next_].frame == frame; ++next_)
    moment.rows.push_back({rows[next_].robot, rows[next_].position, rows[next_].velocity});
  return true;
}

std::string TrackRows::place(std::optional<std::int64_t> robot) const {
  if (missing_) return fmt::format("{}: frame {}", table_.path, *missing_);
  if (next_ == 0) return table_.path;
  for (std::size_t k = first_; k < next_; ++k)
    if (table_.rows[k].robot == robot) return place_of(table_, table_.rows[k]);
  return fmt::format("{}: frame {}", table_.path, table_.rows[first_].frame);
}

}  // namespace

std::unique_ptr<RowSource> track_rows(TrackTable table, std::optional<std::int64_t> robots) {
  return std::make_unique<TrackRows>(std::move(table), robots);
}

}  // namespace avo_io
