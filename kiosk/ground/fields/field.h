#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kiosk/ground/toml/toml_places.h"

namespace onggi::fields {

/// What a value is.
enum class FieldKind {
  boolean,  ///< true or false
  whole,    ///< A whole number.
  number,   ///< Any number.
  text,     ///< A text: words, a path, one of a few names.
  texts,    ///< A list of texts.
  list,     ///< Any other list.
};

/// One key of a file that curators write. Readers, `onggi check --fields`, `onggi set`, the page
/// config/README.md and a form go by lists of these, so that a key is written down once.
struct Field {
  std::string table{};  ///< "screen", "label.LANGUAGE"; "": above all tables.
  std::string key{};    ///< Of any_key: what a key is, in capitals: "LANGUAGE".
  FieldKind kind = FieldKind::text;
  std::string words{};                 ///< What it does. One line of Markdown.
  double least = 0.0, most = 0.0;      ///< Of a number, both included; both 0: told by `range`.
  std::string unit{};                  ///< Of a number: "s", "mm"; "": none.
  std::string range{};                 ///< What is allowed, where least to most is not enough.
  std::string usual{};                 ///< The default, as the file writes it; "": it has none.
  std::string page{};                  ///< A page with more, from the root; "": none.
  std::vector<std::string> choices{};  ///< Of a text that is one of these.
  bool any_key = false;                ///< Each language, vessel or day is a key of the table.
  bool restarts_console = false;       ///< onggi-console must be started again.
  std::string shown_key{};             ///< The key as the page shows it; "": `key`.
  bool on_page = true;                 ///< False: another row of the page speaks for it.

  /// "screen.force", "title.LANGUAGE". A part in capitals stands for any name.
  std::string name() const;
  /// True if `names` (a Path without the numbers of elements) lead to it.
  bool matches(const toml::Path& names) const;
};

/// A table that a file has or not, as a whole: an effect of a scene, or a list's elements.
struct OptionalTable {
  std::string name;      ///< "slump", "mission".
  bool is_list = false;  ///< [[name]]: any number of elements, each with its own id.
  std::string words{};   ///< What it is, in sentences.
  std::string gives{};   ///< What visitors get by it, in sentences.
  std::string needs{};   ///< Another table, without which it cannot be; "": none.
};

/// The keys of one kind of file.
struct FieldList {
  std::string file;  ///< "exhibit.toml", "scenes/*.toml".
  std::vector<Field> fields;
  std::vector<OptionalTable> tables{};
};

/// The table that `path` means: {"slump"}, or an element of a list {"mission", "litre_jar"}. Null
/// of anything else.
const OptionalTable* find_table(const FieldList& list, const toml::Path& path);

/// A number with the fewest digits that read back as the same: "0.004", "5000000".
std::string number_words(double value);

/// The bounds of a number: "20 to 3600".
std::string bounds_words(const Field& field);

/// What is allowed: "s, 20 to 3600", "true or false", "1 to 120 letters, one line".
std::string allowed_range(const Field& field);

/// Its row in a reference page: key, meaning, unit and range, default.
std::string page_row(const Field& field);

/// The field at `names` (a Path without the numbers of elements), or null.
const Field* find_field(const FieldList& list, const toml::Path& names);

/// What to write in place of the key `wrong`, as a sentence.
std::string right_key(const FieldList& list, const std::string& wrong);

/// "a whole number", "a text".
std::string kind_words(FieldKind kind);

}  // namespace onggi::fields
