#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace onggi::toml {

/// A place in the file; lines and columns from 1.
struct Place {
  std::uint32_t line = 1, column = 1;
  auto operator<=>(const Place&) const = default;
};

/// A TOML file as toml++ may read it: the same document, in ASCII.
///
/// Why: toml++ 3.3 and 3.4 ask of letters beyond ASCII, in several places, whether they are spaces,
/// by a table that calls most of its entries unreachable: undefined behaviour. It never meets one
/// here. In strings such a letter is written as \UXXXXXXXX (a 'literal' string becomes a "basic"
/// one), in comments as '?'. Elsewhere TOML has none.
///
/// Takes time and memory in proportion to the text. Allocates. Any thread.
class AsciiToml {
 public:
  /// `text` in UTF-8, with or without a byte order mark; `name` stands in fault(). Both are read
  /// here and not kept.
  AsciiToml(const std::string& text, const std::string& name);

  /// The document. With a fault(): the lines before its line, and a character that TOML allows
  /// nowhere, so that a parser that gets so far stops there.
  const std::string& text() const { return out_; }
  /// The first thing that toml++ must not meet: a letter outside strings and comments, bytes that
  /// are not UTF-8, or a name of more than 16 parts (toml++ takes down a table for each part by
  /// recursion: half a million fit into a file, and overflow the stack).
  const std::optional<Problem>& fault() const { return fault_; }
  std::uint32_t fault_line() const { return line_; }
  /// Where in the file a place of text() is.
  Place original(Place place) const;

 private:
  /// What stands for one letter of the file, and how far what follows is shifted by then.
  struct Shift {
    std::uint32_t line, begin, end;  ///< Columns of text(), from 1.
    std::uint32_t before, after;
  };
  bool outside(char c);
  bool comment();
  bool basic_string(std::size_t end);
  bool literal_string(std::size_t end);
  bool letter(bool in_string);
  void copy();
  void put(const std::string& stand_in, std::size_t bytes);
  void refuse(std::string what, std::string remedy);
  void refuse_letter(char32_t point);

  const std::string& in_;
  const std::string& name_;
  std::size_t at_ = 0;          ///< Of in_.
  std::size_t line_begin_ = 0;  ///< Of out_.
  std::uint32_t line_ = 1, column_ = 1, shift_ = 0;
  int parts_ = 0;  ///< Points in the name at hand.
  std::string out_;
  std::vector<Shift> shifts_;
  std::optional<Problem> fault_;
};

}  // namespace onggi::toml
