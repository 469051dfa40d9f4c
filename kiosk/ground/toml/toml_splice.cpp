#include "kiosk/ground/toml/toml_splice.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include "kiosk/ground/toml/toml_document_impl.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::toml {
namespace {

Path behind(const Path& path, const Path& first) {
  return {path.begin() + static_cast<std::ptrdiff_t>(first.size()), path.end()};
}

/// Finds where a value that is absent belongs.
class Adding {
 public:
  Adding(const std::string& text, const Path& path, const std::string& value)
      : text_(text), path_(path), value_(value), places_(text), newline_(end_of_line(text)) {}

  /// The bytes to put in, and where.
  std::pair<std::size_t, std::string> place() const {
    if (const TomlPlaces::Value* table = inline_table()) return within(*table);
    if (const auto header = own_header()) return below(*header);
    if (const TomlPlaces::Value* sibling = dotted_sibling()) {
      const Path above = places_.headers()[sibling->header].path;
      return line_behind(behind_line(text_, sibling->end), behind(path_, above));
    }
    if (const auto header = header_of_element()) return below(*header);
    return at_the_end();
  }

 private:
  Path table_path() const { return {path_.begin(), path_.end() - 1}; }

  /// The innermost inline table that holds the path.
  const TomlPlaces::Value* inline_table() const {
    const TomlPlaces::Value* found = nullptr;
    for (const TomlPlaces::Value& value : places_.values())
      if (value.kind == TomlPlaces::Kind::table && begins_with(path_, value.path) &&
          (found == nullptr || value.path.size() > found->path.size()))
        found = &value;
    return found;
  }

  std::pair<std::size_t, std::string> within(const TomlPlaces::Value& table) const {
    const std::string entry = key_text(behind(path_, table.path)) + " = " + value_;
    const TomlPlaces::Value* last = nullptr;
    for (const TomlPlaces::Value& value : places_.values())
      if (&value != &table && value.begin > table.begin && value.end < table.end &&
          (last == nullptr || value.end > last->end))
        last = &value;
    if (last != nullptr) return {last->end, ", " + entry};
    return {table.begin + 1, " " + entry + " "};
  }

  std::optional<std::size_t> header_at(const Path& path) const {
    for (std::size_t n = 0; n < places_.headers().size(); ++n)
      if (places_.headers()[n].path == path) return n;
    return std::nullopt;
  }
  std::optional<std::size_t> own_header() const { return header_at(table_path()); }
  /// The [[list]] line of the innermost element that holds the path.
  std::optional<std::size_t> header_of_element() const {
    for (Path path = table_path(); !path.empty(); path.pop_back()) {
      const Path list(path.begin(), path.end() - 1);
      if (const auto header = header_at(path); header && places_.elements(list) > 0) return header;
    }
    return std::nullopt;
  }

  /// The last key of the table, where the table is written as `table.key = ...`.
  const TomlPlaces::Value* dotted_sibling() const {
    const Path table = table_path();
    const TomlPlaces::Value* found = nullptr;
    for (const TomlPlaces::Value& value : places_.values())
      if (begins_with(value.path, table) && value.path.size() > table.size() &&
          places_.headers()[value.header].path.size() < table.size())
        found = &value;
    return found;
  }

  std::pair<std::size_t, std::string> below(std::size_t header) const {
    const auto& headers = places_.headers();
    const std::size_t begin = headers[header].behind,
                      end = header + 1 < headers.size() ? headers[header + 1].begin : text_.size();
    const Path key = behind(path_, headers[header].path);
    if (const auto example = behind_example(begin, end, key_text(key)))
      return line_behind(*example, key);
    const TomlPlaces::Value* last = nullptr;
    for (const TomlPlaces::Value& value : places_.values())
      if (value.header == header && (last == nullptr || value.end > last->end)) last = &value;
    if (last != nullptr) return line_behind(behind_line(text_, last->end), key);
    return line_behind(header == 0 ? behind_first_comment(begin) : begin, key);
  }

  /// Behind a line `# key = ...` between `begin` and `end`.
  std::optional<std::size_t> behind_example(std::size_t begin, std::size_t end,
                                            const std::string& key) const {
    for (std::size_t line = begin; line < end; line = behind_line(text_, line)) {
      std::size_t at = text_.find_first_not_of(" \t", line);
      if (at == std::string::npos || text_[at] != '#' || in_a_value(at)) continue;
      at = text_.find_first_not_of("# \t", at);
      if (at == std::string::npos || text_.compare(at, key.size(), key) != 0) continue;
      at = text_.find_first_not_of(" \t", at + key.size());
      if (at != std::string::npos && text_[at] == '=') return behind_line(text_, line);
    }
    return std::nullopt;
  }
  bool in_a_value(std::size_t at) const {
    return std::ranges::any_of(places_.values(), [at](const TomlPlaces::Value& value) {
      return value.begin <= at && at < value.end;
    });
  }

  /// A comment at the very top is of the file.
  std::size_t behind_first_comment(std::size_t begin) const {
    std::size_t at = begin;
    while (at < text_.size() && text_[at] == '#') at = behind_line(text_, at);
    return at;
  }

  std::pair<std::size_t, std::string> line_behind(std::size_t at, const Path& key) const {
    const std::string line = key_text(key) + " = " + value_;
    const bool cut = at > 0 && at == text_.size() && text_[at - 1] != '\n' && !bare(at);
    return {at, cut ? newline_ + line : line + newline_};
  }
  /// Nothing but a byte order mark stands before `at`.
  bool bare(std::size_t at) const { return at == places_.headers().front().begin; }

  std::pair<std::size_t, std::string> at_the_end() const {
    const std::size_t at = text_.size();
    const std::string table =
        "[" + key_text(table_path()) + "]" + newline_ + key_text({path_.back()}) + " = " + value_;
    if (bare(at)) return {at, table + newline_};
    if (text_.back() != '\n') return {at, newline_ + newline_ + table};
    return {at, newline_ + table + newline_};
  }

  const std::string& text_;
  const Path& path_;
  const std::string& value_;
  TomlPlaces places_;
  std::string newline_;
};

/// Takes the value at `path` away, and the tables that are empty without it.
void take_away(::toml::table& root, Path path) {
  while (!path.empty()) {
    const Path above(path.begin(), path.end() - 1);
    ::toml::node* parent = node_at(root, above);
    ::toml::table* table = parent == nullptr ? nullptr : parent->as_table();
    if (table == nullptr) return;
    table->erase(path.back());
    if (!table->empty()) return;
    path = above;
  }
}

/// True if the two documents differ in nothing but the value at `path`, and that is `value`.
bool only_differs(const std::string& before, const std::string& after, const Path& path,
                  const std::string& value) {
  auto old = parsed(before), fresh = parsed(after), wanted = parsed("v = " + value);
  if (!old || !fresh || !wanted) return false;
  const ::toml::node* now = node_at(*fresh, path);
  if (now == nullptr) return false;
  ::toml::table a, b;
  a.insert_or_assign("v", *now);
  if (a != *wanted) return false;
  // A table that was empty before stays written, so both lose what is empty.
  take_away(*old, path);
  take_away(*fresh, path);
  return *old == *fresh;
}

/// True if the two documents differ in nothing but the value at `path`, which the second lacks.
bool only_lacks(const std::string& before, const std::string& after, const Path& path) {
  auto old = parsed(before), fresh = parsed(after);
  if (!old || !fresh || node_at(*fresh, path) != nullptr) return false;
  Path above(path.begin(), path.end() - 1);
  const bool kept_empty = node_at(*fresh, above) != nullptr;
  take_away(*old, path);
  // An element of a list, or a table with a comment of its own, stays without anything in it.
  if (kept_empty) take_away(*fresh, path);
  return *old == *fresh;
}

/// True if nothing is written below `header` but the value at `path`, so that its line goes too.
bool is_alone_below(const TomlPlaces& places, std::size_t header, const Path& path) {
  const Path& table = places.headers()[header].path;
  if (table.empty() || (table.size() > 1 && places.elements({table.begin(), table.end() - 1}) > 0))
    return false;
  return std::ranges::none_of(places.values(), [&](const TomlPlaces::Value& value) {
    return value.header == header && !begins_with(value.path, path);
  });
}

}  // namespace

Result<Spliced> with_value(const std::string& text, const Path& path, const std::string& value,
                           const std::string& name) {
  if (const TomlReader reader = TomlReader::of_text(text, name); !reader.ok())
    return tl::unexpected(reader.problems().front());
  if (!is_value(value))
    return problem(name, "\"" + shown(value, 60) + "\" is not a value that TOML can hold.",
                   "Write a number, true or false, a text in \"quotes\", or a [list].");
  const auto no_place = [&](const std::string& what, const std::string& remedy) {
    return problem(name, what, remedy);
  };
  if (path.empty()) return no_place("No key is named.", "Name a key, such as idle.warn_after.");
  const TomlPlaces places(text);
  Spliced out;
  if (const TomlPlaces::Value* old = places.value(path)) {
    if (old->kind == TomlPlaces::Kind::table)
      return no_place(key_text(path) + " is a table, not a value.",
                      "Name one of its keys: " + key_text(path) + ".KEY.");
    out.at = old->begin;
    out.was = text.substr(old->begin, old->end - old->begin);
    out.is = value;
  } else {
    std::tie(out.at, out.is) = Adding(text, path, value).place();
    out.added = true;
  }
  out.text = text;
  out.text.replace(out.at, out.was.size(), out.is);
  if (only_differs(text, out.text, path, value)) return out;
  return no_place("The key " + key_text(path) + " cannot stand in this file.",
                  "A table or another value stands in its place, or a [[list]] lacks that element. "
                  "Change the file in an editor.");
}

Result<Spliced> without_value(const std::string& text, const Path& path, const std::string& name) {
  if (const TomlReader reader = TomlReader::of_text(text, name); !reader.ok())
    return tl::unexpected(reader.problems().front());
  const TomlPlaces places(text);
  const TomlPlaces::Value* value = places.value(path);
  Spliced out{text, 0, {}, {}, false};
  if (value == nullptr) return out;
  const auto line_begin = [&text](std::size_t at) {
    const std::size_t end = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return end == std::string::npos ? 0 : end + 1;
  };
  const std::size_t top = places.headers().front().begin;  // behind a byte order mark
  const std::size_t begin = std::max(line_begin(value->statement), top),
                    end = behind_line(text, value->end);
  out.at = begin;
  out.was = text.substr(begin, end - begin);
  out.text.erase(begin, end - begin);
  if (is_alone_below(places, value->header, path)) {
    const TomlPlaces::Header& header = places.headers()[value->header];
    // The empty line above it goes too: with_value() writes one there.
    const std::size_t above = line_begin(header.begin == top ? top : header.begin - 1);
    const bool empty = header.begin > top && text.find_first_not_of("\r\n", above) >= header.begin;
    out.at = empty ? above : header.begin;
    out.text.erase(out.at, header.behind - out.at);
  }
  if (only_lacks(text, out.text, path)) return out;
  return problem(name, "The key " + key_text(path) + " cannot be taken out of this file.",
                 "It stands within {...}, or others stand in its line. Change the file in an "
                 "editor.");
}

bool is_value(const std::string& text) {
  const std::string whole = "v = " + text;
  TomlReader reader = TomlReader::of_text(whole, "value");
  if (!reader.ok() || reader.root().keys().size() != 1) return false;
  const TomlPlaces places(whole);
  const TomlPlaces::Value* value = places.value({"v"});
  return value != nullptr && value->begin == 4 && value->end == whole.size();
}

std::string quoted_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (byte < 0x20 || byte == 0x7F) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04X", static_cast<unsigned>(byte));
      out += code.data();
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string key_text(const Path& path) {
  std::string out;
  for (const std::string& name : path) {
    const bool bare = !name.empty() && std::ranges::all_of(name, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '_' || c == '-';
    });
    out += (out.empty() ? "" : ".") + (bare ? name : quoted_text(name));
  }
  return out;
}

Path path_of(std::string_view key) {
  const std::string whole = std::string(key) + " = 0";
  if (whole.find_first_of("\r\n#[]{},") != std::string::npos) return {};
  const TomlPlaces places(whole);
  if (!parsed(whole) || places.values().size() != 1) return {};
  return places.values().front().path;
}

}  // namespace onggi::toml
