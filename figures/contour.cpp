// SPDX-License-Identifier: Apache-2.0
// Marching squares on a grid with a rim of positive values, so that every contour closes.
#include "figures/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace avo::figures {
namespace {

constexpr std::size_t kBlock = 8;  // nodes per side of a block that one evaluation may settle

// Values at the nodes of a grid; the outermost ring is outside the box.
class Grid {
 public:
  Grid(const Box& box, int cells) {
    const Vec2 size = box.upper - box.lower;
    const double cell = std::max(size.x, size.y) / cells;
    const auto count = [cell](double length) {
      return static_cast<std::size_t>(std::max(1.0, std::ceil(length / cell - 1e-9)));
    };
    columns_ = count(size.x) + 3;
    rows_ = count(size.y) + 3;
    box_ = box;
    step_ = {size.x / static_cast<double>(columns_ - 3), size.y / static_cast<double>(rows_ - 3)};
    values_.assign(columns_ * rows_, 1.0);
  }

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] Vec2 at(std::size_t column, std::size_t row) const {
    // nodes of the rim lie on the edge of the box, so contours end there
    const double x = static_cast<double>(std::clamp<std::size_t>(column, 1, columns_ - 2) - 1);
    const double y = static_cast<double>(std::clamp<std::size_t>(row, 1, rows_ - 2) - 1);
    return {box_.lower.x + x * step_.x, box_.lower.y + y * step_.y};
  }
  [[nodiscard]] double value(std::size_t column, std::size_t row) const {
    return values_[row * columns_ + column];
  }

  void evaluate(const std::function<double(Vec2)>& f, double lipschitz) {
    for (std::size_t row = 1; row + 1 < rows_; row += kBlock) {
      for (std::size_t column = 1; column + 1 < columns_; column += kBlock) {
        evaluate_block(f, lipschitz, column, row);
      }
    }
  }

 private:
  void evaluate_block(const std::function<double(Vec2)>& f, double lipschitz, std::size_t column,
                      std::size_t row) {
    const std::size_t last_column = std::min(column + kBlock, columns_ - 1);
    const std::size_t last_row = std::min(row + kBlock, rows_ - 1);
    const Vec2 lower = at(column, row);
    const Vec2 upper = at(last_column - 1, last_row - 1);
    const double far = f(0.5 * (lower + upper));
    // includes one cell beyond the block, so that the contour cannot cross an edge between two
    // blocks unnoticed
    const bool settled = std::fabs(far) > lipschitz * (0.5 * norm(upper - lower) + norm(step_));
    for (std::size_t j = row; j < last_row; ++j) {
      for (std::size_t i = column; i < last_column; ++i) {
        values_[j * columns_ + i] = settled ? far : f(at(i, j));
      }
    }
  }

  std::size_t columns_, rows_;
  Box box_;
  Vec2 step_;
  std::vector<double> values_;
};

// Contours as links between edges of the grid: edge 2 n leaves node n to the right, 2 n + 1 up.
class Tracer {
 public:
  explicit Tracer(const Grid& grid) : grid_(grid), next_(2 * grid.columns() * grid.rows(), kNone) {}

  std::vector<std::vector<Vec2>> trace() {
    for (std::size_t row = 0; row + 1 < grid_.rows(); ++row) {
      for (std::size_t column = 0; column + 1 < grid_.columns(); ++column) link(column, row);
    }
    std::vector<std::vector<Vec2>> polygons;
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (next_[start] == kNone) continue;
      std::vector<Vec2> polygon;
      for (std::size_t edge = start; next_[edge] != kNone;) {
        polygon.push_back(crossing(edge));
        const std::size_t following = next_[edge];
        next_[edge] = kNone;
        edge = following;
      }
      polygons.push_back(std::move(polygon));
    }
    return polygons;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] bool inside(std::size_t column, std::size_t row) const {
    return grid_.value(column, row) < 0.0;
  }

  [[nodiscard]] Vec2 crossing(std::size_t edge) const {
    const std::size_t node = edge / 2;
    const std::size_t column = node % grid_.columns();
    const std::size_t row = node / grid_.columns();
    const std::size_t to_column = edge % 2 == 0 ? column + 1 : column;
    const std::size_t to_row = edge % 2 == 0 ? row : row + 1;
    const double a = grid_.value(column, row);
    const double b = grid_.value(to_column, to_row);
    const Vec2 from = grid_.at(column, row);
    return from + a / (a - b) * (grid_.at(to_column, to_row) - from);
  }

  // Links the crossed edges of one cell, with the inside to the left. On a counter-clockwise walk
  // around the cell, a contour enters where the walk leaves the inside. It ends where the walk
  // comes back.
  void link(std::size_t column, std::size_t row) {
    const std::size_t node = row * grid_.columns() + column;
    const std::array<std::size_t, 4> edges{2 * node, 2 * (node + 1) + 1,
                                           2 * (node + grid_.columns()), 2 * node + 1};
    const std::array<bool, 4> corner{inside(column, row), inside(column + 1, row),
                                     inside(column + 1, row + 1), inside(column, row + 1)};
    for (std::size_t k = 0; k < 4; ++k) {
      if (!corner[k] || corner[(k + 1) % 4]) continue;
      // the walk leaves the inside across edge k: the contour runs back to the edge where this
      // inside began
      std::size_t j = (k + 3) % 4;
      while (corner[j]) j = (j + 3) % 4;
      next_[edges[k]] = edges[j];
    }
  }

  const Grid& grid_;
  std::vector<std::size_t> next_;
};

}  // namespace

std::vector<std::vector<Vec2>> negative_set(const Box& box, int cells,
                                            const std::function<double(Vec2)>& f,
                                            double lipschitz) {
  Grid grid(box, cells);
  grid.evaluate(f, lipschitz);
  return Tracer(grid).trace();
}

}  // namespace avo::figures
