#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace onggi {

/// Which stored row stands where in a stack, from the foot up, and which are spare: rows come to
/// stand between others, and leave, without a radius moving. What is large or outlives a stroke is
/// kept by stored row; what is small, by place. Allocates in its constructor only. Not safe across
/// threads.
class RowOrder {
 public:
  static constexpr int kSpare = -1;
  RowOrder() = default;
  /// Row j stands at place j, of `rows`; `spare` more may come, the first of them first.
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
  int next() const { return spare_.back(); }  ///< That insert() takes; there must be one.
  /// The place of a stored row; kSpare of one that stands nowhere.
  int place_of(int stored) const { return place_[static_cast<std::size_t>(stored)]; }
  /// Every row stands at the place of its own number.
  bool plain() const { return plain_; }

  /// The spare row that left last comes to stand at place `j`, and those from there on a place
  /// higher; gives which. There must be one. O(rows above).
  int insert(int j) {
    const int row = spare_.back();
    spare_.pop_back();
    stored_.insert(stored_.begin() + j, row);
    number_from(j);
    return row;
  }
  /// The row at place `j` leaves, and those above it come a place lower. O(rows above).
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
