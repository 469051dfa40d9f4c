#pragma once

#include <optional>
#include <string_view>

#include "engine/math/vectors.h"

namespace onggi {

/// For programs that are run on one kind of vectors after the other (engine/math/vectors.h).

/// Prints the kinds that this machine has, a line each, best first. Gives 0.
int print_vector_kinds();
/// None, with a word on stderr, where there is no such kind. "" is the best.
std::optional<Vectors> choose_vectors(std::string_view kind);

}  // namespace onggi
