#include "kiosk/ground/toml/toml_tree.h"

#include <cstdint>  // the next headers use its names unasked

// Compiled in here, whatever the package offers: its library asserts and throws where we want a
// Problem. Without NDEBUG an assertion of toml++ is TOML_ASSERT and nothing else: with NDEBUG it
// becomes a promise to the compiler, and a typing error such as "[.]" breaks it (toml++ 3.3 and 3.4
// assert that a [header] begins with a letter just before the loop that reports what does not).
// Its other fault, letters that are taken for spaces, is kept away in toml_text.cpp.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#undef TOML_HEADER_ONLY
#undef TOML_SHARED_LIB
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_MAX_NESTED_VALUES 64
#define TOML_ASSERT(condition) static_cast<void>(0)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>

#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {

namespace {

Place place_of(const ::toml::source_region& source) {
  return {std::max(1u, source.begin.line), std::max(1u, source.begin.column)};
}

TomlNode::Table table_of(const ::toml::table& table);

TomlNode node_of(const ::toml::node& node) {
  TomlNode out;
  out.place = place_of(node.source());
  if (const auto* text = node.as_string()) out.value = text->get();
  if (const auto* whole = node.as_integer()) out.value = whole->get();
  if (const auto* number = node.as_floating_point()) out.value = number->get();
  if (const auto* yes = node.as_boolean()) out.value = yes->get();
  if (const auto* table = node.as_table()) out.value = table_of(*table);
  if (const auto* array = node.as_array()) {
    TomlNode::List list;
    for (const ::toml::node& element : *array) list.push_back(node_of(element));
    out.value = std::move(list);
  }
  return out;
}

TomlNode::Table table_of(const ::toml::table& table) {
  TomlNode::Table out;
  for (const auto& [key, value] : table)
    out.push_back({std::string(key.str()), place_of(key.source()), node_of(value)});
  return out;
}

}  // namespace

bool TomlNode::is_list_of_tables() const {
  const List* list = as<List>();
  return list != nullptr && !list->empty() &&
         std::ranges::all_of(*list, [](const TomlNode& n) { return n.as<Table>() != nullptr; });
}

const TomlNode* find(const TomlNode::Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &TomlNode::Member::key);
  return found == table.end() ? nullptr : &found->value;
}

Result<TomlNode::Table> parse_toml(const std::string& text, const std::string& name) {
  if (const Result<void> sound = check_outside_quotes(text, name); !sound)
    return tl::unexpected(sound.error());
  const ::toml::parse_result parsed =
      ::toml::parse(escaped_after_line_ends(text), std::string_view(name));
  if (parsed) return table_of(parsed.table());
  const ::toml::parse_error& error = parsed.error();
  const Place at = place_of(error.source());
  const std::string line = line_of(text, at.line);
  return problem(name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                 "This cannot be read as TOML (" + shown(error.description(), 160) + ")" +
                     (line.empty() ? "." : ", in the line: " + line),
                 "Write `key = value`: text in \"quotes\", commas between the elements of a list, "
                 "every bracket and quote closed, each key once in its [table].");
}

}  // namespace onggi::toml
