#include "engine/clay/row_area.h"

#include "engine/math/vector_choice.h"

namespace onggi {

ONGGI_CHOICE_OF(clay::AreaKernel, kAreaKernel)

const clay::AreaKernel& clay::area_kernel(Vectors kind) noexcept {
  return choose_kAreaKernel(kind);
}

}  // namespace onggi
