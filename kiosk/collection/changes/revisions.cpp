#include "kiosk/collection/changes/revisions.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <functional>
#include <span>

#include "kiosk/ground/files/crc32.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/durable_steps.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::changes {
namespace {

namespace fs = std::filesystem;
using toml::quoted_text;

constexpr int kLargest = 5 << 20;  // bytes: more than a TOML file may have

std::uint32_t check_sum(const std::string& text) {
  return files::crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string hex_of(std::uint32_t number) {
  std::array<char, 12> text{};
  std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(number));
  return text.data();
}

bool read_hex(toml::TomlReader::Table& table, const char* key, std::uint32_t& out) {
  std::string text;
  if (!table.text(key, text)) return false;
  return std::from_chars(text.data(), text.data() + text.size(), out, 16).ec == std::errc();
}

std::string text_of(const Revision& revision, const std::string& file) {
  std::string out =
      "# One change that onggi set made. onggi undo takes it back.\nfile = " + quoted_text(file) +
      "\nwhen = " + quoted_text(revision.when) + "\nat = " + std::to_string(revision.at) +
      "\nwas = " + quoted_text(revision.was) + "\nis = " + quoted_text(revision.is) +
      "\nbefore = \"" + hex_of(revision.before) + "\"\nafter = \"" + hex_of(revision.after) +
      "\"\n";
  for (const ChangedValue& value : revision.values)
    out += "[[value]]\nkey = " + quoted_text(value.key) + "\nwas = " + quoted_text(value.was) +
           "\nis = " + quoted_text(value.is) + "\nput = " + quoted_text(value.put) +
           (value.is_table ? "\ntable = true\n" : "\n");
  return out;
}

bool has_form(const fs::path& file) {
  return file.filename().string().size() == 13 &&
         files::begins_like(file.filename().string(), "99999999") && file.extension() == ".toml";
}

/// True if a letter of UTF-8 begins before `at` and ends behind it.
bool within_letter(const std::string& text, std::size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
}

/// A value as it is told: a long one is cut.
std::string cut(const std::string& value) {
  constexpr std::size_t kLongest = 120;
  return value.empty() ? "not written" : toml::shown(value, kLongest);
}

}  // namespace

std::optional<std::string> Revision::taken_from(const std::string& now) const {
  if (check_sum(now) != after || now.compare(at, is.size(), is) != 0) return std::nullopt;
  std::string old = now;
  old.replace(at, is.size(), was);
  if (check_sum(old) != before) return std::nullopt;
  return old;
}

bool Revision::not_carried_out(const std::string& now) const {
  return before != after && check_sum(now) == before;
}

Revision revision_of(const std::string& before, const std::string& after) {
  Revision out;
  const std::size_t most = std::min(before.size(), after.size());
  while (out.at < most && before[out.at] == after[out.at]) ++out.at;
  std::size_t same = 0;
  while (same < most - out.at && before[before.size() - 1 - same] == after[after.size() - 1 - same])
    ++same;
  // Whole letters, since both parts are kept as texts.
  while (out.at > 0 && (within_letter(before, out.at) || within_letter(after, out.at))) --out.at;
  while (same > 0 && within_letter(before, before.size() - same)) --same;
  out.was = before.substr(out.at, before.size() - out.at - same);
  out.is = after.substr(out.at, after.size() - out.at - same);
  out.before = check_sum(before);
  out.after = check_sum(after);
  return out;
}

std::string words_of(const Revision& revision) {
  std::string out;
  for (const ChangedValue& value : revision.values) {
    out += (out.empty() ? "" : "\n") + value.key;
    out += value.is_table ? (value.is.empty() ? ": taken out" : ": added")
                          : ": " + cut(value.was) + " -> " + cut(value.is);
  }
  return out;
}

std::string change_words(const ChangedValue& value) {
  if (value.is_table) return value.key + (value.is.empty() ? " was taken out." : " was added.");
  return value.key +
         (value.is.empty() ? " is not written any more" : " is " + cut(value.is) + " now") +
         ". It was " + cut(value.was) + ".";
}

std::string undo_words(const ChangedValue& value, const std::string& when) {
  if (value.is_table)
    return value.key +
           (value.was.empty() ? " is taken out again. It was added "
                              : " is there again. It was taken out ") +
           when + ".";
  return value.key +
         (value.was.empty() ? " is not written any more" : " is " + cut(value.was) + " again") +
         ". It was " + cut(value.is) + " since " + when + ".";
}

Revisions::Revisions(const fs::path& file) {
  std::error_code ignored;
  const fs::path exhibit = files::site_exhibit(file);
  site_ = files::real_path(exhibit.empty() ? fs::absolute(file, ignored).parent_path()
                                           : exhibit.parent_path().parent_path());
  folder_ = site_ / "revisions";
}

Result<void> Revisions::lock() {
  if (auto made = files::make_folder(folder_); !made) return made;
  const fs::path file = folder_ / "lock";
  lock_ = files::Descriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0664));
  if (!lock_.open()) return tl::unexpected(files::disk_problem(file, "write", errno));
  // Whoever of the folder's group comes next takes the same lock, also where root made it.
  struct stat above {};
  if (::stat(folder_.c_str(), &above) == 0 && (above.st_mode & S_IWGRP) != 0)
    static_cast<void>(::fchmod(lock_.get(), 0664));
  while (::flock(lock_.get(), LOCK_EX) != 0)
    if (errno != EINTR) return tl::unexpected(files::disk_problem(file, "write", errno));
  std::error_code ignored;
  if (!fs::exists(folder_ / ".gitignore", ignored)) {
    const std::string all = "*\n";
    if (auto put = files::write_durably(folder_ / ".gitignore", std::as_bytes(std::span(all)));
        !put)
      return put;
  }
  // Whoever wrote these is gone, or it would hold the lock.
  for (const auto& entry : fs::directory_iterator(folder_, ignored))
    if (entry.path().extension() == ".part") fs::remove(entry.path(), ignored);
  return {};
}

std::vector<fs::path> Revisions::kept() const {
  std::vector<fs::path> out;
  std::error_code gone;
  for (fs::directory_iterator it(folder_, gone), end; !gone && it != end; it.increment(gone))
    if (has_form(it->path())) out.push_back(it->path());
  std::ranges::sort(out, std::greater<>());
  return out;
}

std::optional<Revision> Revisions::read_one(const fs::path& file) const {
  toml::TomlReader reader(file);
  if (!reader.ok()) return std::nullopt;
  auto root = reader.root();
  Revision out;
  std::string name;
  int at = 0;
  bool good = root.text("file", name) && root.text("when", out.when) &&
              root.integer("at", at, 0, kLargest) && root.text("was", out.was) &&
              root.text("is", out.is) && read_hex(root, "before", out.before) &&
              read_hex(root, "after", out.after);
  out.at = static_cast<std::size_t>(at);
  out.file = (site_ / name).lexically_normal();
  for (auto& table : root.children("value")) {
    ChangedValue value;
    good = table.text("key", value.key) && table.text("was", value.was) &&
           table.text("is", value.is) && table.text("put", value.put) && good;
    table.boolean("table", value.is_table);
    out.values.push_back(std::move(value));
  }
  if (!good || out.values.empty()) return std::nullopt;
  out.kept_in = file;
  return out;
}

std::vector<Revision> Revisions::read() const {
  std::vector<Revision> out;
  for (const fs::path& file : kept()) {
    auto revision = read_one(file);
    if (!revision) continue;
    // It is kept before its file is replaced, and forgotten after it is put back.
    if (const auto now = toml::read_toml_text(revision->file);
        out.empty() && now && revision->not_carried_out(*now))
      continue;
    out.push_back(std::move(*revision));
  }
  return out;
}

std::string Revisions::next_id() const {
  const auto all = kept();
  const int number = all.empty() ? 1 : std::stoi(all.front().stem().string()) + 1;
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "%08d", number);
  return name.data();
}

Result<void> Revisions::keep(Revision& revision) const {
  revision.when = files::local_time(files::wall_now(), "%Y-%m-%d %H:%M");
  revision.kept_in = folder_ / (next_id() + ".toml");
  const fs::path real = files::real_path(revision.file), near = real.lexically_relative(site_);
  const bool within = !near.empty() && *near.begin() != "..";
  const std::string text = text_of(revision, (within ? near : real).string());
  if (auto put = files::write_durably(revision.kept_in, std::as_bytes(std::span(text))); !put)
    return put;
  if (!read_one(revision.kept_in)) {
    static_cast<void>(forget(revision));
    return problem(revision.kept_in.string(), "The change could not be kept, so it was not made.",
                   "Change the file in an editor, and report this.", 1);
  }
  files::step_done("revision kept");
  return {};
}

Result<void> Revisions::forget(const Revision& revision) const {
  if (::unlink(revision.kept_in.c_str()) != 0 && errno != ENOENT)
    return tl::unexpected(files::disk_problem(revision.kept_in, "write", errno));
  files::step_done("revision forgotten");
  return {};
}

void Revisions::tidy() const {
  const std::vector<Revision> all = read();
  std::error_code ignored;
  // Those that were not carried out are newer than the newest of `all`.
  for (const fs::path& file : kept()) {
    const bool known =
        std::ranges::any_of(all, [&](const Revision& r) { return r.kept_in == file; });
    const bool newer = all.empty() || file > all.front().kept_in;
    if (!known && newer && read_one(file)) fs::remove(file, ignored);
  }
  for (std::size_t n = kKept; n < all.size(); ++n) fs::remove(all[n].kept_in, ignored);
}

}  // namespace onggi::changes
