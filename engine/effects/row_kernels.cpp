#include "engine/effects/row_kernels.h"

#include "engine/math/vector_choice.h"

namespace onggi {

ONGGI_CHOICE_OF(row_kernels::Table, kRowKernels)

const row_kernels::Table& row_kernels::of(Vectors kind) noexcept {
  return choose_kRowKernels(kind);
}

}  // namespace onggi
