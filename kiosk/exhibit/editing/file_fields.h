#pragma once

#include <filesystem>

#include "kiosk/exhibit/composition/file_kind.h"
#include "kiosk/ground/fields/field.h"

namespace onggi::editing {

/// Every list of keys, in the order of config/README.md.
std::vector<const fields::FieldList*> field_lists();

/// The keys of a kind of file; null where no list has them yet.
const fields::FieldList* fields_of(exhibit::FileKind kind);

}  // namespace onggi::editing
