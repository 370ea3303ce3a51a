// SPDX-License-Identifier: Apache-2.0
// Files that are whole or do not exist.
#include "output.h"

#include <cerrno>
#include <cinttypes>
#include <system_error>
#include <unistd.h>

#include "avo/checked.h"

namespace avo::safety {

Output::Output(const std::string& path)
    : path_(path), temporary_(path + ".part" + std::to_string(getpid())) {
  file_ = std::fopen(temporary_.c_str(), "wx");
  if (file_ == nullptr) fail(errno);
}

Output::~Output() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(temporary_.c_str());
}

void Output::fail(int reason) {
  throw OutputError(path_ + ": " + std::generic_category().message(reason));
}

void Output::write(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail(errno);
}

void Output::commit() {
  if (std::fflush(file_) != 0) fail(errno);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  std::fclose(file_);
  file_ = nullptr;
}

Recording::Recording(const std::string& path, bool headings) : output_(path), headings_(headings) {
  output_.write(headings ? "time,robot,x,y,vx,vy,heading,speed\n" : "time,robot,x,y,vx,vy\n");
}

void Recording::add(const Simulation& simulation) {
  add(simulation.time(), checked_states(simulation.fleet()));
}

void Recording::add(double time, std::span<const CheckedState> rows) {
  char row[320];
  for (const CheckedState& state : rows) {
    const Vec2 p = state.position, v = state.velocity;
    std::snprintf(row, sizeof row, "%.17g,%" PRId64 ",%.17g,%.17g,%.17g,%.17g", time, state.robot,
                  p.x, p.y, v.x, v.y);
    output_.write(row);
    if (headings_ && state.heading) {
      std::snprintf(row, sizeof row, ",%.17g,%.17g", state.heading->angle, state.heading->speed);
      output_.write(row);
    } else if (headings_) {
      output_.write(",,");
    }
    output_.write("\n");
  }
}

}  // namespace avo::safety
