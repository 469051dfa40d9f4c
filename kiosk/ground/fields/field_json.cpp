#include "kiosk/ground/fields/field_json.h"

#include <string>

namespace onggi::fields {
namespace {

using files::Json;

const char* name_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::boolean:
      return "boolean";
    case FieldKind::whole:
      return "whole";
    case FieldKind::number:
      return "number";
    case FieldKind::text:
      return "text";
    case FieldKind::texts:
      return "texts";
    case FieldKind::list:
      break;
  }
  return "list";
}

bool has_bounds(const Field& field) {
  return (field.kind == FieldKind::whole || field.kind == FieldKind::number) &&
         field.least < field.most;
}

Json json_of_field(const Field& field) {
  Json out = Json::object({{"table", field.table},
                           {"key", field.key},
                           {"kind", name_of(field.kind)},
                           {"words", field.words},
                           {"allowed", allowed_range(field)}});
  if (has_bounds(field)) {
    out["least"] = field.least;
    out["most"] = field.most;
  }
  if (!field.unit.empty()) out["unit"] = field.unit;
  if (!field.usual.empty()) out["default"] = field.usual;
  if (!field.choices.empty()) out["choices"] = Json::list_of(field.choices);
  if (!field.page.empty()) out["page"] = field.page;
  out["any_key"] = field.any_key;
  out["restarts_console"] = field.restarts_console;
  return out;
}

Json json_of_table(const OptionalTable& table) {
  Json out =
      Json::object({{"name", table.name}, {"is_list", table.is_list}, {"words", table.words}});
  if (!table.gives.empty()) out["gives"] = table.gives;
  if (!table.needs.empty()) out["needs"] = table.needs;
  return out;
}

}  // namespace

Json json_of(const FieldList& list) {
  Json all = Json::list();
  for (const Field& field : list.fields) all.push_back(json_of_field(field));
  Json tables = Json::list();
  for (const OptionalTable& table : list.tables) tables.push_back(json_of_table(table));
  return Json::object({{"file", list.file}, {"fields", all}, {"tables", tables}});
}

std::string text_of(const FieldList& list) {
  std::string out = list.file + "\n";
  for (const OptionalTable& table : list.tables)
    out +=
        (table.is_list ? "  [[" + table.name + "]]" : "  [" + table.name + "], may be left out") +
        "\n      " + table.words + "\n";
  for (const Field& field : list.fields) {
    out += "  " + field.name();
    if (const std::string allowed = allowed_range(field); !allowed.empty()) out += ": " + allowed;
    if (!field.usual.empty()) out += " [" + field.usual + "]";
    out += "\n      " + field.words + "\n";
  }
  std::erase(out, '`');  // the marks of code in Markdown
  return out;
}

}  // namespace onggi::fields
