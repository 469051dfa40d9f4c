#include "kiosk/ground/toml/written_twice.h"

#include <cstdint>
#include <vector>

#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// A line that names something: [table], [[list]] or key = value.
struct NamingLine {
  enum Kind : std::uint8_t { none, table, list, key };

  Kind kind = none;
  std::string_view name;

  explicit NamingLine(std::string_view line) {
    line = trimmed(line);
    const bool lists = line.starts_with("[[");
    if (line.starts_with("[")) {
      const std::size_t from = lists ? 2 : 1, end = line.find(']');
      if (end == std::string_view::npos) return;
      kind = lists ? list : table;
      name = trimmed(line.substr(from, end - from));
    } else if (const std::size_t end = line.find('='); end != std::string_view::npos) {
      kind = key;
      name = trimmed(line.substr(0, end));
    }
  }
};

/// True if `name` is `parent` or stands below it.
bool in(std::string_view name, std::string_view parent) {
  return name.starts_with(parent) && (name.size() == parent.size() || name[parent.size()] == '.');
}

/// The lines that name something, from the first to the fault's.
class Names {
 public:
  Names(std::string_view text, std::size_t last) {
    for (std::size_t n = 0; n < last; ++n) {
      const std::size_t end = text.find('\n');
      lines_.emplace_back(text.substr(0, end));
      if (end == std::string_view::npos) break;
      text.remove_prefix(end + 1);
    }
  }

  const NamingLine& last() const { return lines_.back(); }

  /// The line (from 1) of the first of the two; 0: not found.
  std::size_t first() const {
    for (std::size_t n = lines_.size() - 1; n > 0; --n) {
      const NamingLine& one = lines_[n - 1];
      const bool header = one.kind == NamingLine::table || one.kind == NamingLine::list;
      if (last().kind == NamingLine::key) {
        if (header) return 0;
        if (one.kind == NamingLine::key && one.name == last().name) return n;
      } else if (header && one.name == last().name) {
        return n;
      }
    }
    return 0;
  }

  /// The first line (from 1) of the list `name` or of a table of it; 0: not found.
  std::size_t first_in(std::string_view name) const {
    for (std::size_t n = 1; n < lines_.size(); ++n)
      if (const NamingLine& one = lines_[n - 1];
          one.kind == NamingLine::table && in(one.name, name))
        return n;
    return 0;
  }

  /// The [[list]] that the last line belongs to; "": none.
  std::string_view list() const {
    std::string_view table;
    for (std::size_t n = lines_.size(); n > 0; --n) {
      const NamingLine& one = lines_[n - 1];
      if (table.empty() && one.kind == NamingLine::table) table = one.name;
      if (one.kind != NamingLine::list) continue;
      if (table.empty() || in(table, one.name)) return one.name;
    }
    return {};
  }

 private:
  std::vector<NamingLine> lines_;
};

std::string quoted(std::string_view name) { return "\"" + shown(name, 60) + "\""; }

/// A [[list]]'s line as one writes it.
std::string list_line(std::string_view name) { return "[[" + shown(name, 60) + "]]"; }

}  // namespace

std::optional<WrittenTwice> written_twice(std::string_view description, const std::string& text,
                                          std::size_t line) {
  if (line == 0 || description.find("cannot redefine existing ") == std::string_view::npos)
    return {};
  const Names names(text, line);
  const NamingLine& last = names.last();
  if (last.kind == NamingLine::none) return {};
  if (last.kind == NamingLine::list) {
    const std::size_t above = names.first_in(last.name);
    return WrittenTwice{
        list_line(last.name) + " begins a part of a list, but " + quoted(last.name) +
            " is already something else" +
            (above == 0 ? "." : ": see line " + std::to_string(above) + "."),
        "Write " + list_line(last.name) + " on a line of its own above the first part, too."};
  }
  // A key of an inline table stands behind another name.
  std::string_view name = last.name;
  if (const std::size_t from = description.find('\''); from != std::string_view::npos)
    if (const std::size_t end = description.find('\'', from + 1); end != std::string_view::npos)
      name = description.substr(from + 1, end - from - 1);
  const std::size_t first = name == last.name ? names.first() : 0;
  const std::string_view list = names.list();
  std::string remedy = "Remove one of the two.";
  if (!list.empty())
    remedy = "If a new part of the list begins here, write " + list_line(list) +
             " on a line of its own above the part's first line. Else remove one of the two.";
  return WrittenTwice{
      quoted(name) + " is written twice" +
          (first == 0 ? "." : ": it stands in line " + std::to_string(first) + ", too."),
      std::move(remedy)};
}

}  // namespace onggi::toml
