#include "tests/support/vector_kinds.h"

#include <cstdio>

#include "engine/math/vectors.h"

namespace onggi {

int print_vector_kinds() {
  for (const std::string_view kind : vector_kinds())
    std::printf("%.*s\n", static_cast<int>(kind.size()), kind.data());
  return 0;
}

bool choose_vectors(std::string_view kind) {
  const bool good = use_vectors(kind);
  if (!good)
    std::fprintf(stderr, "There are no vectors \"%.*s\" here; --kinds lists what there is.\n",
                 static_cast<int>(kind.size()), kind.data());
  return good;
}

}  // namespace onggi
