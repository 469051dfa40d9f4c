#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace onggi::clay {

/// Of figures by place, as many as there is room for: those from `j` on go one place up, and the
/// highest falls out; place `j` has `value`. No allocation.
template <class T>
void open_place(std::vector<T>& by_place, int j, T value = {}) noexcept {
  std::move_backward(by_place.begin() + j, by_place.end() - 1, by_place.end());
  by_place[static_cast<std::size_t>(j)] = value;
}
/// Those above `j` come one place down, over it.
template <class T>
void close_place(std::vector<T>& by_place, int j) noexcept {
  std::move(by_place.begin() + j + 1, by_place.end(), by_place.begin() + j);
}

}  // namespace onggi::clay
