#include "kiosk/ground/toml/toml_tables.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "kiosk/ground/toml/toml_document_impl.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_splice.h"

namespace onggi::toml {
namespace {

Result<void> check_toml(const std::string& text, const std::string& name) {
  if (const TomlReader reader = TomlReader::of_text(text, name); !reader.ok())
    return tl::unexpected(reader.problems().front());
  return {};
}

/// `lines` behind the end of `text`, an empty line between them.
TableSpliced at_the_end(const std::string& text, const std::string& lines) {
  const std::string newline(end_of_line(text));
  const bool bare = text.find_first_not_of("\xEF\xBB\xBF") == std::string::npos;
  std::string is = lines + newline;
  if (!bare) is.insert(0, text.ends_with('\n') ? newline : newline + newline);
  return {text + is, {}, is};
}

/// Takes the table or element at `path` away.
void drop_table(::toml::table& root, const Path& path) {
  ::toml::node* parent = node_at(root, {path.begin(), path.end() - 1});
  if (parent == nullptr) return;
  if (::toml::table* table = parent->as_table()) {
    table->erase(path.back());
  } else if (::toml::array* list = parent->as_array()) {
    const std::size_t n = std::stoul(path.back());
    if (n >= 1 && n <= list->size())
      list->erase(list->begin() + static_cast<std::ptrdiff_t>(n - 1));
  }
}

bool is_empty(const ::toml::node& node) {
  const ::toml::table* table = node.as_table();
  const ::toml::array* list = node.as_array();
  return (table != nullptr && table->empty()) || (list != nullptr && list->empty());
}

/// True if `more` is `less` with the table at `path`, and nothing else.
bool only_adds(const std::string& less, const std::string& more, Path path) {
  auto old = parsed(less), fresh = parsed(more);
  if (!old || !fresh || node_at(*fresh, path) == nullptr) return false;
  drop_table(*fresh, path);
  // What was there for its sake alone: the list of one element, a table that no line names.
  for (path.pop_back(); !path.empty(); path.pop_back()) {
    const ::toml::node* around = node_at(*fresh, path);
    if (around == nullptr || !is_empty(*around) || node_at(*old, path) != nullptr) break;
    drop_table(*fresh, path);
  }
  return *old == *fresh;
}

Problem no_place(const Path& path, const std::string& name) {
  return {name, "The table " + key_text(path) + " cannot be put in or taken out here.",
          "Something else stands in its place. Change the file in an editor."};
}

std::size_t line_begin(const std::string& text, std::size_t at) {
  const std::size_t end = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  return end == std::string::npos ? 0 : end + 1;
}

/// Where the header at index `n` begins, with the comment right above it, unless that is the
/// file's.
std::size_t begin_of(const std::string& text, const TomlPlaces& places, std::size_t n) {
  const std::size_t begin = places.headers()[n].begin;
  if (n == 0) return begin;
  std::size_t least = places.headers()[n - 1].behind;
  for (const TomlPlaces::Value& value : places.values())
    if (value.header == n - 1) least = std::max(least, behind_line(text, value.end));
  std::size_t at = begin;
  while (at > least) {
    const std::size_t above = line_begin(text, at - 1);
    const std::size_t first = text.find_first_not_of(" \t", above);
    if (first == std::string::npos || text[first] != '#') break;
    at = above;
  }
  const bool of_file = text.find_first_not_of("\xEF\xBB\xBF") >= at;
  return of_file ? begin : at;
}

/// What goes with the header at index `n`.
std::pair<std::size_t, std::size_t> part_below(const std::string& text, const TomlPlaces& places,
                                               std::size_t n) {
  const bool last = n + 1 == places.headers().size();
  return {begin_of(text, places, n), last ? text.size() : begin_of(text, places, n + 1)};
}

}  // namespace

Result<TableSpliced> with_table(const std::string& text, const Path& path,
                                const std::string& name) {
  if (auto good = check_toml(text, name); !good) return tl::unexpected(good.error());
  auto document = parsed(text);
  const ::toml::node* there = document ? node_at(*document, path) : nullptr;
  if (there != nullptr && there->is_table()) return TableSpliced{text, {}, {}};
  TableSpliced out = at_the_end(text, "[" + key_text(path) + "]");
  if (there == nullptr && only_adds(text, out.text, path)) return out;
  return tl::unexpected(no_place(path, name));
}

Result<TableSpliced> with_element(const std::string& text, const Path& list, const std::string& id,
                                  const std::string& name) {
  if (auto good = check_toml(text, name); !good) return tl::unexpected(good.error());
  Path path = list;
  path.push_back(std::to_string(TomlPlaces(text).elements(list) + 1));
  const std::string newline(end_of_line(text));
  TableSpliced out =
      at_the_end(text, "[[" + key_text(list) + "]]" + newline + "id = " + quoted_text(id));
  if (only_adds(text, out.text, path)) return out;
  return tl::unexpected(no_place(path, name));
}

Result<TableSpliced> without_table(const std::string& text, const Path& path,
                                   const std::string& name) {
  if (auto good = check_toml(text, name); !good) return tl::unexpected(good.error());
  auto document = parsed(text);
  const ::toml::node* there = document ? node_at(*document, path) : nullptr;
  if (there == nullptr) return TableSpliced{text, {}, {}};
  TableSpliced out{text, {}, {}};
  const TomlPlaces places(text);
  for (std::size_t n = places.headers().size(); n-- > 0;) {
    if (!begins_with(places.headers()[n].path, path)) continue;
    const auto [begin, end] = part_below(text, places, n);
    out.was.insert(0, text.substr(begin, end - begin));
    out.text.erase(begin, end - begin);
  }
  // At the end of the file no empty line stays behind.
  while (!out.was.empty() && out.text.ends_with("\n\n")) out.text.pop_back();
  while (!out.was.empty() && out.text.ends_with("\r\n\r\n")) out.text.resize(out.text.size() - 2);
  if (there->is_table() && only_adds(out.text, text, path)) return out;
  return tl::unexpected(no_place(path, name));
}

}  // namespace onggi::toml
