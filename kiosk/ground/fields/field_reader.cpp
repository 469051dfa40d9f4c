#include "kiosk/ground/fields/field_reader.h"

#include <algorithm>
#include <cstdlib>

namespace onggi::fields {

const Field& field_at(const FieldList& list, std::string_view table, std::string_view key) {
  const auto found = std::ranges::find_if(
      list.fields, [&](const Field& field) { return field.table == table && field.key == key; });
  if (found == list.fields.end()) std::abort();
  return *found;
}

bool read_number(toml::TomlReader::Table& table, const Field& field, double& out) {
  return table.number(field.key, out, field.least, field.most, field.unit);
}

bool read_whole(toml::TomlReader::Table& table, const Field& field, int& out) {
  return table.integer(field.key, out, static_cast<int>(field.least), static_cast<int>(field.most),
                       field.unit);
}

}  // namespace onggi::fields
