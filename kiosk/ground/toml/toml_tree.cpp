#include "kiosk/ground/toml/toml_tree.h"

#include <cstdint>  // toml++ uses its names without including it

// Compiled in here, whatever the package offers: its library asserts and throws where we want a
// Problem. Without NDEBUG an assertion of toml++ is TOML_ASSERT and nothing else: with NDEBUG it
// becomes a promise to the compiler, and a typing error such as "[.]" breaks it (toml++ 3.3 and 3.4
// assert that a [header] begins with a letter just before the loop that reports what does not).
// Its other fault, letters that it takes for spaces, is kept away by AsciiToml.
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

#include "kiosk/ground/toml/ascii_toml.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {

namespace {

Place place_of(const ::toml::source_region& source, const AsciiToml& file) {
  return file.original({std::max(1u, source.begin.line), std::max(1u, source.begin.column)});
}

TomlNode::Table table_of(const ::toml::table& table, const AsciiToml& file);

TomlNode node_of(const ::toml::node& node, const AsciiToml& file) {
  TomlNode out;
  out.place = place_of(node.source(), file);
  if (const auto* text = node.as_string()) out.value = text->get();
  if (const auto* whole = node.as_integer()) out.value = whole->get();
  if (const auto* number = node.as_floating_point()) out.value = number->get();
  if (const auto* yes = node.as_boolean()) out.value = yes->get();
  if (const auto* table = node.as_table()) out.value = table_of(*table, file);
  if (const auto* array = node.as_array()) {
    TomlNode::List list;
    for (const ::toml::node& element : *array) list.push_back(node_of(element, file));
    out.value = std::move(list);
  }
  return out;
}

TomlNode::Table table_of(const ::toml::table& table, const AsciiToml& file) {
  TomlNode::Table out;
  for (const auto& [key, value] : table)
    out.push_back({std::string(key.str()), place_of(key.source(), file), node_of(value, file)});
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
  const AsciiToml file(text, name);
  const ::toml::parse_result parsed = ::toml::parse(file.text(), std::string_view(name));
  // The first mistake is told. What is not closed before a fault's line may be closed after it.
  const auto& fault = file.fault();
  if (parsed && fault) return tl::unexpected(*fault);
  if (parsed) return table_of(parsed.table(), file);
  const ::toml::parse_error& error = parsed.error();
  const Place at = place_of(error.source(), file);
  if (fault && at.line >= file.fault_line()) return tl::unexpected(*fault);
  const std::string line = line_of(text, at.line);
  return problem(name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                 "This cannot be read as TOML (" + shown(error.description(), 160) + ")" +
                     (line.empty() ? "." : ", in the line: " + line),
                 "Write `key = value`: text in \"quotes\", commas between the elements of a list, "
                 "every bracket and quote closed, each key once in its [table].");
}

}  // namespace onggi::toml
