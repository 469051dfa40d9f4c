#include "tests/support/vector_kinds.h"

#include <cstdio>
#if __has_include("engine/math/vectors.h")
#include "engine/math/vectors.h"
#define ONGGI_HAS_VECTOR_KINDS 1
#else
#define ONGGI_HAS_VECTOR_KINDS 0
#endif

namespace onggi {

int print_vector_kinds() {
#if ONGGI_HAS_VECTOR_KINDS
  for (const std::string_view kind : vector_kinds())
    std::printf("%.*s\n", static_cast<int>(kind.size()), kind.data());
#endif
  return 0;
}

bool choose_vectors(std::string_view kind) {
#if ONGGI_HAS_VECTOR_KINDS
  const bool good = use_vectors(kind);
#else
  const bool good = kind.empty();
#endif
  if (!good)
    std::fprintf(stderr, "There are no vectors \"%.*s\" here; --kinds lists what there is.\n",
                 static_cast<int>(kind.size()), kind.data());
  return good;
}

}  // namespace onggi
