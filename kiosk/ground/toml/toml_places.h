#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace onggi::toml {

/// The names that lead to a value: {"idle", "warn_after"}. An element of a list of tables has its
/// number, from 1: {"step", "2", "after"}.
using Path = std::vector<std::string>;

/// Where the values of a TOML text stand, byte by byte, so that one can be changed and all others
/// left alone. The text must be valid TOML (TomlReader::ok()); of another the places mean nothing,
/// but reading it is safe. Takes time in proportion to the text. Allocates; any thread.
class TomlPlaces {
 public:
  enum class Kind {
    plain,  ///< A text, a number, a switch, a date.
    list,   ///< [...]
    table,  ///< {...}
  };
  /// A value that is written. Those within an inline table come after it.
  struct Value {
    Path path;
    Kind kind = Kind::plain;
    std::size_t begin = 0, end = 0;  ///< Bytes of the value.
    std::size_t statement = 0;       ///< Where its statement `key = ...` begins.
    std::size_t header = 0;          ///< Its header's index in headers().
  };
  /// A line [table] or [[table]]. The first stands for the beginning of the text, with no path.
  struct Header {
    Path path;
    std::size_t begin = 0, behind = 0;  ///< Of its line; behind its line's end.
  };

  explicit TomlPlaces(std::string_view text);

  const std::vector<Value>& values() const { return values_; }
  const std::vector<Header>& headers() const { return headers_; }
  /// The value at `path`, or null. A [table] is none.
  const Value* value(const Path& path) const;
  /// How many elements the list of tables at `path` has; 0 if there is no such list.
  std::size_t elements(const Path& path) const;

 private:
  void read();
  void read_header();
  void read_value(const Path& path, std::size_t statement);
  void read_list(const Path& path, std::size_t statement);
  void read_inline_table(const Path& path, std::size_t statement);
  Path read_key();
  std::string read_name();
  void skip_blanks();
  void skip_line();
  void skip_between();
  char at() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool done() const { return at_ >= text_.size(); }

  struct List {
    Path path;
    std::size_t elements = 0;
  };
  List* list(const Path& path);

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Value> values_;
  std::vector<Header> headers_;
  std::vector<List> lists_;
};

/// Behind the end of the line in which `at` lies: at the next line's first byte, or at the end.
std::size_t behind_line(std::string_view text, std::size_t at);

}  // namespace onggi::toml
