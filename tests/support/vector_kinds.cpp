#include "tests/support/vector_kinds.h"

#include <cstdio>

namespace onggi {

int print_vector_kinds() {
  for (const Vectors kind : vectors_here()) std::printf("%s\n", name_of(kind).data());
  return 0;
}

std::optional<Vectors> choose_vectors(std::string_view kind) {
  if (kind.empty()) return best_vectors();
  for (const Vectors here : vectors_here())
    if (name_of(here) == kind) return here;
  std::fprintf(stderr, "There are no vectors \"%.*s\" here; --kinds lists what there is.\n",
               static_cast<int>(kind.size()), kind.data());
  return {};
}

}  // namespace onggi
