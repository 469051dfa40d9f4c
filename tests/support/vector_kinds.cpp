#include "tests/support/vector_kinds.h"

#include <cstdio>

namespace onggi {

int print_vector_kinds() {
  for (const Vectors kind : vectors_here()) std::printf("%s\n", name_of(kind).data());
  return 0;
}

std::optional<Vectors> choose_vectors(std::string_view kind) {
  const auto found = vectors_named(kind);
  if (!found)
    std::fprintf(stderr, "There are no vectors \"%.*s\" here; --kinds lists what there is.\n",
                 static_cast<int>(kind.size()), kind.data());
  return found;
}

}  // namespace onggi
