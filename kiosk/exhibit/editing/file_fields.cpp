#include "kiosk/exhibit/editing/file_fields.h"

#include "kiosk/collection/content/content_fields.h"
#include "kiosk/collection/settings/exhibit_fields.h"
#include "kiosk/collection/settings/mission_fields.h"
#include "kiosk/collection/settings/scene_file_fields.h"
#include "kiosk/wheel/device/device_fields.h"

namespace onggi::editing {

std::vector<const fields::FieldList*> field_lists() {
  using exhibit::FileKind;
  std::vector<const fields::FieldList*> lists;
  for (const FileKind kind :
       {FileKind::exhibit, FileKind::device, FileKind::scene, FileKind::vessel, FileKind::glazes,
        FileKind::lesson, FileKind::missions})
    lists.push_back(fields_of(kind));
  return lists;
}

const fields::FieldList* fields_of(exhibit::FileKind kind) {
  using exhibit::FileKind;
  switch (kind) {
    case FileKind::exhibit:
      return &settings::exhibit_fields();
    case FileKind::device:
      return &device::device_fields();
    case FileKind::scene:
      return &settings::scene_fields();
    case FileKind::vessel:
      return &content::vessel_fields();
    case FileKind::glazes:
      return &content::glaze_fields();
    case FileKind::lesson:
      return &content::lesson_fields();
    case FileKind::missions:
      return &settings::mission_fields();
    case FileKind::rubric:
    case FileKind::language:
    case FileKind::drawing:
    case FileKind::decoration:
    case FileKind::way:
    case FileKind::names:
    case FileKind::staff_page:
      return nullptr;
  }
  return nullptr;
}

}  // namespace onggi::editing
