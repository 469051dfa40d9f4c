#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace onggi::clay {

/// Inserts `value` at place `j` of figures by place; those from `j` on move up, and the highest
/// falls out. No allocation.
template <class T>
void open_place(std::vector<T>& by_place, int j, T value = {}) noexcept {
  std::move_backward(by_place.begin() + j, by_place.end() - 1, by_place.end());
  by_place[static_cast<std::size_t>(j)] = value;
}
/// Removes place `j`; those above move down.
template <class T>
void close_place(std::vector<T>& by_place, int j) noexcept {
  std::move(by_place.begin() + j + 1, by_place.end(), by_place.begin() + j);
}

}  // namespace onggi::clay
