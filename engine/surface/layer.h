#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "engine/math/hash.h"

namespace onggi::surface {

/// Whole numbers on a grid, in tiles of kRows x kAcross. A tile of one value holds that value
/// alone. Each tile is kept as it was before the step that changes it, to be taken back. The same
/// values have the same hash. Allocates where it says so; not safe across threads.
template <class Cell, int kRows, int kAcross>
class Layer {
 public:
  /// Of `columns` that are a multiple of kAcross. Allocates the table of tiles.
  Layer(int rows, int columns) : across_(columns / kAcross) {
    const int down = (rows + kRows - 1) / kRows;
    tiles_.resize(static_cast<std::size_t>(down) * static_cast<std::size_t>(across_));
  }

  Cell at(int row, int column) const {
    const Tile& tile = tiles_[tile_of(row, column)];
    return tile.cells.empty() ? tile.one : tile.cells[cell_of(row, column)];
  }
  /// Allocates the first time that a tile changes in a step.
  void set(int row, int column, Cell value) {
    const std::size_t index = tile_of(row, column), cell = cell_of(row, column);
    Tile& tile = tiles_[index];
    if ((tile.cells.empty() ? tile.one : tile.cells[cell]) == value) return;
    if (tile.step != step_ && !kept_.empty()) {
      kept_.back().emplace_back(index, tile);
      tile.step = step_;
    }
    if (tile.cells.empty()) tile.cells.assign(kCells, tile.one);
    tile.cells[cell] = value;
  }

  void begin_step() {
    kept_.emplace_back();
    ++step_;
  }
  /// Gives back the memory of those tiles of the step under way that have one value now.
  void settle() {
    if (kept_.empty()) return;
    for (const auto& [index, old] : kept_.back()) {
      Tile& tile = tiles_[index];
      if (tile.cells.empty() || !tile.even()) continue;
      tile.one = tile.cells.front();
      std::vector<Cell>().swap(tile.cells);  // assigning {} would keep the memory
    }
  }
  /// Takes the last step back. There is one.
  void undo() {
    // The first of two copies of a tile last: a step that went on after another was taken back has
    // two.
    std::vector<std::pair<std::size_t, Tile>>& kept = kept_.back();
    for (auto each = kept.rbegin(); each != kept.rend(); ++each) {
      tiles_[each->first] = std::move(each->second);
      tiles_[each->first].step = 0;  // what is changed again is kept again
    }
    kept_.pop_back();
    ++step_;
  }
  void forget_oldest() { kept_.pop_front(); }

  std::size_t bytes() const {
    std::size_t sum = tiles_.capacity() * sizeof(Tile);
    for (const Tile& tile : tiles_) sum += tile.cells.capacity() * sizeof(Cell);
    return sum;
  }
  std::size_t kept_bytes() const {
    std::size_t sum = 0;
    for (const auto& step : kept_) {
      sum += step.capacity() * sizeof(step.front());
      for (const auto& [index, tile] : step) sum += tile.cells.capacity() * sizeof(Cell);
    }
    return sum;
  }
  void add_to(StateHash& hash) const {
    for (const Tile& tile : tiles_) {
      const bool even = tile.even();
      hash.add(std::uint64_t{even ? 0 : tile.cells.size()});
      if (even) {
        const Cell one = tile.cells.empty() ? tile.one : tile.cells.front();
        hash.add(static_cast<std::uint64_t>(one));
        continue;
      }
      for (const Cell& cell : tile.cells) hash.add(static_cast<std::uint64_t>(cell));
    }
  }

 private:
  static constexpr std::size_t kCells = std::size_t{kRows} * kAcross;
  struct Tile {
    Cell one{};
    std::uint32_t step = 0;   // in which it was kept
    std::vector<Cell> cells;  // none: all of them are `one`

    bool even() const {
      return std::ranges::all_of(cells, [this](const Cell& cell) { return cell == cells.front(); });
    }
  };

  std::size_t tile_of(int row, int column) const {
    return static_cast<std::size_t>(row / kRows * across_ + column / kAcross);
  }
  static std::size_t cell_of(int row, int column) {
    return static_cast<std::size_t>(row % kRows * kAcross + column % kAcross);
  }

  int across_;
  std::uint32_t step_ = 1;
  std::vector<Tile> tiles_;
  std::deque<std::vector<std::pair<std::size_t, Tile>>> kept_;
};

}  // namespace onggi::surface
