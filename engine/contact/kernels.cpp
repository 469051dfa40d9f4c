#include "engine/contact/kernels.h"

#include "engine/math/vector_choice.h"

namespace onggi {

ONGGI_CHOICE_OF(contact::Kernels, kContactKernels)

const contact::Kernels& contact::kernels(Vectors kind) noexcept {
  return choose_kContactKernels(kind);
}

}  // namespace onggi
