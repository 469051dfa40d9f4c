#include "kiosk/ground/toml/toml_reader.h"

#include <algorithm>

#include "engine/base/nearest_name.h"
#include "kiosk/ground/toml/toml_reader_impl.h"
#include "kiosk/ground/toml/written_twice.h"

namespace onggi::toml {

TomlReader::Table TomlReader::Impl::table(const std::string& path, const ::toml::table* node,
                                          Place at) {
  auto& slot = tables[path];
  if (!slot) {
    slot = std::make_shared<Table::Impl>();
    slot->file = this;
    slot->node = node;
    slot->path = path;
    slot->place = at;
  }
  Table out;
  out.impl_ = slot;
  return out;
}

TomlReader::TomlReader() : impl_(std::make_shared<Impl>()) {}

TomlReader::TomlReader(const std::filesystem::path& file) : TomlReader() {
  impl_->name = file.string();
  if (const Result<std::string> text = read_toml_text(file))
    parse(*text);
  else
    impl_->problems.push_back(text.error());
}

TomlReader TomlReader::of_text(const std::string& text, const std::string& name) {
  TomlReader reader;
  reader.impl_->name = name;
  reader.parse(text);
  return reader;
}

void TomlReader::parse(const std::string& text) {
  const AsciiToml& file = impl_->text.emplace(text, impl_->name);
  ::toml::parse_result parsed = ::toml::parse(file.text(), std::string_view(impl_->name));
  const auto& fault = file.fault();
  if (parsed && !fault) {
    impl_->root = std::move(parsed).table();
    impl_->ok = true;
    return;
  }
  // The first mistake is told. What is not closed before a fault's line may be closed after it.
  const Place at = parsed ? Place{} : impl_->place(parsed.error().source());
  if (parsed || (fault && at.line >= file.fault_line())) {
    impl_->problems.push_back(*fault);
    return;
  }
  if (auto twice = written_twice(parsed.error().description(), text, at.line)) {
    impl_->problems.push_back({impl_->where(at), std::move(twice->what), std::move(twice->remedy)});
    return;
  }
  const std::string line = line_of(text, at.line);
  impl_->problems.push_back(
      {impl_->where(at),
       "This cannot be read as TOML (" + shown(parsed.error().description(), 160) + ")" +
           (line.empty() ? "." : ", in the line: " + line),
       "Write `key = value`: text in \"quotes\", commas between the elements of a list, "
       "every bracket and quote closed, each key once in its [table]."});
}

TomlReader::~TomlReader() = default;
TomlReader::TomlReader(TomlReader&&) noexcept = default;

bool TomlReader::ok() const { return impl_->ok; }
const std::vector<Problem>& TomlReader::problems() const { return impl_->problems; }
std::vector<Problem> TomlReader::problems_since(const std::vector<Problem>& before) const {
  // Compare by their text: new Problems are inserted between old ones, in line order.
  std::vector<Problem> out;
  for (const Problem& p : impl_->problems)
    if (std::none_of(before.begin(), before.end(), [&p](const Problem& old) {
          return old.where == p.where && old.what == p.what;
        }))
      out.push_back(p);
  return out;
}
int TomlReader::keys_checked() const { return impl_->keys_checked; }
TomlReader::Table TomlReader::root() {
  return impl_->table("", impl_->ok ? &impl_->root : nullptr, Place{});
}

bool TomlReader::Table::present() const { return impl_->node != nullptr; }

bool TomlReader::Table::has(std::string_view key) const {
  return present() && impl_->node->contains(key);
}

bool TomlReader::Table::has_table(std::string_view key) const {
  return present() && impl_->node->get_as<::toml::table>(key) != nullptr;
}

std::vector<std::string> TomlReader::Table::keys() const {
  std::vector<std::pair<Place, std::string>> found;
  if (present()) {
    for (const auto& [key, value] : *impl_->node)
      found.emplace_back(impl_->file->place(key.source()), key.str());
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> out;
  for (auto& [place, key] : found) out.push_back(std::move(key));
  return out;
}

TomlReader::Table TomlReader::Table::child(std::string_view name) {
  const ::toml::node* value = impl_->ask(name);
  const ::toml::table* table = value == nullptr ? nullptr : value->as_table();
  if (value != nullptr && table == nullptr) {
    const std::string full = impl_->full(name);
    impl_->wrong_type(name, *value, "a table",
                      "Write [" + full + "] on a line of its own, and its keys below it.");
  }
  return impl_->file->table(impl_->full(name), table,
                            value == nullptr ? impl_->place : impl_->file->place(value->source()));
}

std::vector<TomlReader::Table> TomlReader::Table::children(std::string_view name) {
  const std::string full = impl_->full(name);
  const std::string remedy = "Write [[" + full + "]] on a line of its own before each of them.";
  std::vector<Table> out;
  const ::toml::array* list = impl_->ask_list(name, "a list of tables", remedy);
  for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) {
    const ::toml::node& value = (*list)[i];
    if (const ::toml::table* table = value.as_table()) {
      out.push_back(impl_->file->table(impl_->full(impl_->element(name, i)), table,
                                       impl_->file->place(value.source())));
    } else {
      impl_->wrong_type(impl_->element(name, i), value, "a table", remedy);
    }
  }
  return out;
}

void TomlReader::Table::complain(std::string_view key, std::string what, std::string remedy) {
  impl_->file->note(impl_->place_of_key(key), std::move(what), std::move(remedy));
}

void TomlReader::Table::complain_at(std::string_view key, std::size_t index, std::string what,
                                    std::string remedy) {
  const ::toml::array* list = present() ? impl_->node->get_as<::toml::array>(key) : nullptr;
  const Place at = list != nullptr && index < list->size()
                       ? impl_->file->place((*list)[index].source())
                       : impl_->place_of_key(key);
  impl_->file->note(at, std::move(what), std::move(remedy));
}

void TomlReader::Table::require(std::string_view key, std::string remedy) {
  if (impl_->ask(key) != nullptr) return;
  impl_->file->note(impl_->place, impl_->full(key) + " is missing.", std::move(remedy));
}

void TomlReader::Table::finish() {
  if (!present() || impl_->finished) return;
  impl_->finished = true;
  for (const auto& [key, value] : *impl_->node) {
    const std::string name(key.str());
    if (std::find(impl_->asked.begin(), impl_->asked.end(), name) != impl_->asked.end()) continue;
    const std::string full = shown(impl_->full(name), 120);
    const std::string what = value.is_table() ? "[" + full + "] is not a table of this file."
                                              : full + " is not a key of this file.";
    impl_->file->note(impl_->file->place(key.source()), what, impl_->right_name(name));
  }
}

std::string TomlReader::Table::Impl::right_name(const std::string& wrong) const {
  // First among those that the table lacks: a key that is there is hardly meant again.
  std::vector<std::string> lacking;
  for (const std::string& key : asked)
    if (node == nullptr || !node->contains(key)) lacking.push_back(key);
  for (const std::vector<std::string>& names : {lacking, asked})
    if (const std::string near = nearest_name(wrong, names); !near.empty())
      return "Did you mean " + near + "?";
  // The key may belong to another table, for example after it slipped under a wrong [table].
  for (const auto& [other_path, other] : file->tables) {
    if (other.get() == this) continue;
    if (std::find(other->asked.begin(), other->asked.end(), wrong) == other->asked.end()) continue;
    return other_path.empty() ? "Move it above the first [table]."
                              : "Move it below the line [" + other_path + "].";
  }
  return "Remove it, or write one of: " + joined(asked) + ".";
}

}  // namespace onggi::toml
