#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "kiosk/picture/render/calls.h"

namespace onggi::render {

/// Range in which two lists differ, including what lies beyond their common length.
template <typename Value>
std::pair<std::size_t, std::size_t> differing_range(const std::vector<Value>& before,
                                                    const std::vector<Value>& now) {
  const std::size_t common = std::min(before.size(), now.size());
  std::size_t first = 0, end = now.size();
  while (first < common && before[first] == now[first]) ++first;
  if (before.size() == now.size())
    while (end > first && before[end - 1] == now[end - 1]) --end;
  return {first, end};
}

/// Uploads the difference to the buffer bound to `target`, which has space for `room` values.
template <typename Value>
void upload_difference(GLenum target, std::vector<Value>& before, const std::vector<Value>& now,
                       std::size_t& room) {
  if (now.size() > room) {
    room = 2 * now.size();
    calls::buffer_data(target, room * sizeof(Value), nullptr, GL_DYNAMIC_DRAW);
    before.clear();
  }
  const auto [first, end] = differing_range(before, now);
  if (first < end)
    calls::buffer_part(target, first * sizeof(Value), (end - first) * sizeof(Value), &now[first]);
  before = now;
}

}  // namespace onggi::render
