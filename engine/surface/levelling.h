#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace onggi::surface {

/// Weights that smooth a line of cells: a wave of `phase` radians a cell keeps exp(-b phase^4) of
/// its height. Symmetric, their sum is 1. Below kLeastLevelling a wave of three cells would keep
/// more than 74 %, so such a line is left as it is: no weights.
struct LevelKernel {
  std::vector<float> weights;  ///< Of a cell, and of each cell `m` before and behind it.

  int reach() const { return static_cast<int>(weights.size()) - 1; }
  bool idle() const { return weights.size() < 2; }
};
inline constexpr double kLeastLevelling = 1.0 / 64;

/// The kernel for b >= 0. Exact to 0.005 of a wave's height where b is 1/16 or more. Allocates; any
/// thread.
LevelKernel level_kernel(double b);

/// A line, or several side by side: cells of one line lie `stride` apart.
inline constexpr int kLanes = 16;

/// Smooths `count` cells of kLanes lines side by side (cell n of lane k is values[n * kLanes + k]).
/// `kernels[n]`: of cell n. No glaze flows over the ends: beyond them the line is its own mirror.
/// The order of sums is fixed, so that every machine gets the same bits. Uses `room`.
void level_lanes(std::span<float> values, std::span<const LevelKernel* const> kernels,
                 std::vector<float>& room);

/// The same for one line.
void level_line(std::span<float> values, std::span<const LevelKernel* const> kernels,
                std::vector<float>& room);

/// One line that closes to a ring, with one kernel. Its reach is less than the line is long.
void level_ring(std::span<float> values, const LevelKernel& kernel, std::vector<float>& room);

}  // namespace onggi::surface
