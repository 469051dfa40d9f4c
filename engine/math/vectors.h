#pragma once

#include <span>
#include <string_view>

namespace onggi {

/// The kinds of vectors that this machine has and the kernels were compiled for, best first:
/// "AVX2", "SSE4", ... All give the same bits; only speed differs.
std::span<const std::string_view> vector_kinds();

/// From now on the kernels use only `kind`, for tests and measurements; an empty name is the best
/// again. False, and nothing changed, where the machine has none of that name. Not while another
/// thread computes.
bool use_vectors(std::string_view kind);

}  // namespace onggi
