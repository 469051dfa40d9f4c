#include "engine/effects/column_kernels.h"

#include "engine/math/vector_choice.h"

namespace onggi {

ONGGI_CHOICE_OF(column_kernels::Table, kColumnKernels)

const column_kernels::Table& column_kernels::of(Vectors kind) noexcept {
  return choose_kColumnKernels(kind);
}

}  // namespace onggi
