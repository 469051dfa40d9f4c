#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace onggi {

/// Maps places in a stack, from the foot up, to stored rows, and keeps the spare ones: rows are
/// inserted and removed without moving radii. Large or long-lived data is kept by stored row, small
/// data by place. Allocates in its constructor only. Not safe across threads.
class RowOrder {
 public:
  static constexpr int kSpare = -1;
  RowOrder() = default;
  /// `rows` rows, row j at place j, and `spare` more, in order.
  RowOrder(int rows, int spare)
      : place_(static_cast<std::size_t>(rows) + static_cast<std::size_t>(spare), kSpare) {
    stored_.reserve(place_.size());
    spare_.reserve(place_.size());
    for (int row = 0; row < rows; ++row) stored_.push_back(row);
    for (int row = rows + spare - 1; row >= rows; --row) spare_.push_back(row);
    number_from(0);
  }

  int rows() const { return static_cast<int>(stored_.size()); }
  int room() const { return static_cast<int>(place_.size()); }
  int spare() const { return static_cast<int>(spare_.size()); }
  int at(int j) const { return stored_[static_cast<std::size_t>(j)]; }
  std::span<const int> stored() const { return stored_; }
  int next() const { return spare_.back(); }  ///< The row that insert() takes; there must be one.
  /// The place of a stored row; kSpare if it is spare.
  int place_of(int stored) const { return place_[static_cast<std::size_t>(stored)]; }
  /// Puts every row at the place of its own number.
  bool plain() const { return plain_; }

  /// Inserts the spare row that left last at place `j` and moves those from there on up; returns
  /// that row. There must be one. O(rows above).
  int insert(int j) {
    const int row = spare_.back();
    spare_.pop_back();
    stored_.insert(stored_.begin() + j, row);
    number_from(j);
    return row;
  }
  /// Removes the row at place `j` and moves those above it down. O(rows above).
  int erase(int j) {
    const int row = at(j);
    stored_.erase(stored_.begin() + j);
    spare_.push_back(row);
    place_[static_cast<std::size_t>(row)] = kSpare;
    number_from(j);
    return row;
  }

 private:
  void number_from(int j) {
    for (int k = j; k < rows(); ++k) place_[static_cast<std::size_t>(at(k))] = k;
    plain_ = std::ranges::is_sorted(stored_) && (stored_.empty() || stored_.back() == rows() - 1);
  }

  std::vector<int> stored_;  // by place
  std::vector<int> place_;   // by stored row
  std::vector<int> spare_;   // the next one last
  bool plain_ = true;
};

}  // namespace onggi
