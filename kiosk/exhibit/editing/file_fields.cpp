#include "kiosk/exhibit/editing/file_fields.h"

#include "kiosk/collection/settings/exhibit_fields.h"

namespace onggi::editing {

std::vector<const fields::FieldList*> field_lists() { return {&settings::exhibit_fields()}; }

const fields::FieldList* fields_of(exhibit::FileKind kind) {
  switch (kind) {
    case exhibit::FileKind::exhibit:
      return &settings::exhibit_fields();
    default:
      return nullptr;
  }
}

}  // namespace onggi::editing
