#include "profiler/harness/covering_array.h"

namespace reprise {
namespace {

class Cover {
 public:
  Cover(std::size_t columns, std::uint32_t values)
      : columns_(columns), values_(values), missing_(columns * columns * values * values, true), left_(columns * (columns - 1) / 2 * values * values) {}

  std::size_t left() const { return left_; }

  // Columns one after the other, each with the value that shows most; among equals the one with most still to be shown, then in turn.
  std::vector<std::uint32_t> nextRow(std::size_t turn) {
    std::vector<std::uint32_t> row;
    for (std::size_t column = 0; column < columns_; ++column) {
      std::uint32_t best = 0;
      std::size_t best_shown = 0, best_open = 0;
      for (std::uint32_t i = 0; i < values_; ++i) {
        const auto value = static_cast<std::uint32_t>((turn + i) % values_);
        const std::size_t shown = shownBy(row, column, value), open = openFor(column, value);
        if (i > 0 && (shown < best_shown || (shown == best_shown && open <= best_open))) continue;
        best = value, best_shown = shown, best_open = open;
      }
      row.push_back(best);
    }
    return row;
  }

  // How many pairs were new.
  std::size_t show(const std::vector<std::uint32_t>& row) {
    const std::size_t before = left_;
    for (std::size_t a = 0; a < columns_; ++a)
      for (std::size_t b = a + 1; b < columns_; ++b) {
        auto pair = missing_[at(a, row[a], b, row[b])];
        left_ -= pair ? 1 : 0;
        pair = false;
      }
    return before - left_;
  }

  // The row with the first pair that is missing, for when the greedy one shows nothing new.
  std::vector<std::uint32_t> rowOfFirstMissing() const {
    std::vector<std::uint32_t> row(columns_, 0);
    for (std::size_t a = 0; a < columns_; ++a)
      for (std::size_t b = a + 1; b < columns_; ++b)
        for (std::uint32_t x = 0; x < values_; ++x)
          for (std::uint32_t y = 0; y < values_; ++y)
            if (missing_[at(a, x, b, y)]) {
              row[a] = x, row[b] = y;
              return row;
            }
    return row;
  }

 private:
  std::size_t at(std::size_t a, std::uint32_t x, std::size_t b, std::uint32_t y) const {
    return ((a * columns_ + b) * values_ + x) * values_ + y;
  }

  std::size_t shownBy(const std::vector<std::uint32_t>& row, std::size_t column, std::uint32_t value) const {
    std::size_t shown = 0;
    for (std::size_t other = 0; other < row.size(); ++other) shown += missing_[at(other, row[other], column, value)] ? 1 : 0;
    return shown;
  }

  std::size_t openFor(std::size_t column, std::uint32_t value) const {
    std::size_t open = 0;
    for (std::size_t later = column + 1; later < columns_; ++later)
      for (std::uint32_t y = 0; y < values_; ++y) open += missing_[at(column, value, later, y)] ? 1 : 0;
    return open;
  }

  std::size_t columns_;
  std::uint32_t values_;
  std::vector<bool> missing_;  // by pair of columns a < b and of their values
  std::size_t left_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> coveringArray(std::size_t columns, std::uint32_t values, std::size_t most_rows) {
  std::vector<std::vector<std::uint32_t>> rows;
  if (columns == 0) return rows;
  if (columns == 1) {
    for (std::uint32_t value = 0; value < values && rows.size() < most_rows; ++value) rows.push_back({value});
    return rows;
  }
  Cover cover(columns, values);
  while (cover.left() > 0 && rows.size() < most_rows) {
    std::vector<std::uint32_t> row = cover.nextRow(rows.size());
    if (cover.show(row) == 0) {
      row = cover.rowOfFirstMissing();
      cover.show(row);
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace reprise
