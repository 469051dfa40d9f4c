#pragma once

#include <string_view>

namespace onggi {

/// For programs that are run on one kind of vectors after the other (engine/math/vectors.h).

/// Prints the kinds that this machine has, a line each; nothing where the engine has only the one
/// that it was compiled for. Gives 0.
int print_vector_kinds();
/// False, with a word on stderr, where there is no such kind. "" is the best.
bool choose_vectors(std::string_view kind);

}  // namespace onggi
