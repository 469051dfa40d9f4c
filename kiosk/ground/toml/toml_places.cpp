#include "kiosk/ground/toml/toml_places.h"

#include <algorithm>

#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::toml {
namespace {

constexpr int kDeepest = 100;  // toml++ here refuses more than 64

/// What a quoted name says.
std::string said_by(std::string_view quoted) {
  std::string name;
  if (TomlReader reader = TomlReader::of_text("name = " + std::string(quoted), "name"); reader.ok())
    reader.root().text("name", name);
  return name;
}

}  // namespace

std::size_t behind_line(std::string_view text, std::size_t at) {
  const std::size_t end = text.find('\n', at);
  return end == std::string_view::npos ? text.size() : end + 1;
}

TomlPlaces::TomlPlaces(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  headers_.push_back({{}, at_, at_});
  read();
}

const TomlPlaces::Value* TomlPlaces::value(const Path& path) const {
  const auto found = std::ranges::find(values_, path, &Value::path);
  return found == values_.end() ? nullptr : &*found;
}

std::size_t TomlPlaces::elements(const Path& path) const {
  const auto found = std::ranges::find(lists_, path, &List::path);
  return found == lists_.end() ? 0 : found->elements;
}

TomlPlaces::List* TomlPlaces::list(const Path& path) {
  const auto found = std::ranges::find(lists_, path, &List::path);
  return found == lists_.end() ? nullptr : &*found;
}

void TomlPlaces::read() {
  while (!done()) {
    const std::size_t before = at_;
    skip_between();
    if (done()) return;
    if (at() == '[') {
      read_header();
    } else {
      const std::size_t statement = at_;
      Path path = headers_.back().path;
      for (std::string& name : read_key()) path.push_back(std::move(name));
      if (at() == '=') {
        ++at_;
        skip_blanks();
        read_value(path, statement);
      }
      skip_line();
    }
    if (at_ == before) ++at_;  // not TOML, so go on anyhow
  }
}

void TomlPlaces::read_header() {
  const std::size_t begin = at_++;
  const bool of_list = at() == '[';
  if (of_list) ++at_;
  const Path written = read_key();
  // A name of a list means its last element so far.
  Path path;
  for (std::size_t n = 0; n < written.size(); ++n) {
    path.push_back(written[n]);
    const bool last = n + 1 == written.size();
    List* known = list(path);
    if (last && of_list && known == nullptr) {
      lists_.push_back({path, 0});
      known = &lists_.back();
    }
    if (last && of_list) ++known->elements;
    if (known != nullptr) path.push_back(std::to_string(known->elements));
  }
  skip_line();
  headers_.push_back({path, begin, at_});
}

void TomlPlaces::read_value(const Path& path, std::size_t statement) {
  const std::size_t index = values_.size(), begin = at_;
  Kind kind = Kind::plain;
  values_.push_back({path, kind, begin, begin, statement, headers_.size() - 1});
  if (at() == '"' || at() == '\'') {
    at_ = behind_string(text_, at_);
  } else if (at() == '[' && depth_ < kDeepest) {
    kind = Kind::list;
    read_list(path, statement);
  } else if (at() == '{' && depth_ < kDeepest) {
    kind = Kind::table;
    read_inline_table(path, statement);
  } else {
    at_ = std::min(text_.find_first_of(",]}#\r\n", at_), text_.size());
    while (at_ > begin && (text_[at_ - 1] == ' ' || text_[at_ - 1] == '\t')) --at_;
  }
  values_[index].kind = kind;
  values_[index].end = at_;
}

void TomlPlaces::read_list(const Path& path, std::size_t statement) {
  ++at_;
  ++depth_;
  for (std::size_t n = 1; !done(); ++n) {
    skip_between();
    if (done() || at() == ']') break;
    const std::size_t before = at_, first = values_.size();
    Path element = path;
    element.push_back(std::to_string(n));
    const bool table = at() == '{';
    read_value(element, statement);
    if (table) {
      // Elements that are tables can be named; of other lists the whole is one value.
      if (List* known = list(path))
        known->elements = n;
      else
        lists_.push_back({path, n});
    } else {
      values_.erase(values_.begin() + static_cast<std::ptrdiff_t>(first), values_.end());
    }
    skip_between();
    if (at() == ',') ++at_;
    if (at_ == before) ++at_;
  }
  if (!done()) ++at_;
  --depth_;
}

void TomlPlaces::read_inline_table(const Path& path, std::size_t statement) {
  ++at_;
  ++depth_;
  while (!done()) {
    skip_between();
    if (done() || at() == '}') break;
    const std::size_t before = at_;
    Path inner = path;
    for (std::string& name : read_key()) inner.push_back(std::move(name));
    if (at() == '=') {
      ++at_;
      skip_blanks();
      read_value(inner, statement);
    }
    skip_between();
    if (at() == ',') ++at_;
    if (at_ == before) ++at_;
  }
  if (!done()) ++at_;
  --depth_;
}

/// The names before '=' or ']'.
Path TomlPlaces::read_key() {
  Path names;
  for (;;) {
    skip_blanks();
    const std::size_t before = at_;
    names.push_back(read_name());
    skip_blanks();
    if (at() != '.' || at_ == before) return names;
    ++at_;
  }
}

std::string TomlPlaces::read_name() {
  const std::size_t begin = at_;
  if (at() == '"' || at() == '\'') {
    at_ = behind_string(text_, at_);
    return said_by(text_.substr(begin, at_ - begin));
  }
  at_ = std::min(text_.find_first_of(" \t.=]},#\r\n", at_), text_.size());
  return std::string(text_.substr(begin, at_ - begin));
}

void TomlPlaces::skip_blanks() {
  while (at() == ' ' || at() == '\t') ++at_;
}

void TomlPlaces::skip_line() { at_ = behind_line(text_, at_); }

/// Blanks, ends of lines and comments.
void TomlPlaces::skip_between() {
  for (;;) {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    if (at() != '#') return;
    skip_line();
  }
}

}  // namespace onggi::toml
