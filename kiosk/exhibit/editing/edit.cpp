#include "kiosk/exhibit/editing/edit.h"

#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <span>

#include "kiosk/collection/changes/draft.h"
#include "kiosk/collection/changes/typed_value.h"
#include "kiosk/exhibit/composition/file_kind.h"
#include "kiosk/exhibit/editing/edit_check.h"
#include "kiosk/exhibit/editing/file_fields.h"
#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/durable_steps.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/ground/toml/toml_splice.h"
#include "kiosk/ground/toml/toml_tables.h"
#include "kiosk/ground/toml/toml_text.h"

namespace onggi::editing {
namespace {

namespace fs = std::filesystem;
using changes::ChangedValue;
using changes::Draft;
using changes::Revision;
using changes::Revisions;

/// The Problem of a change that is refused: the fault of a value itself comes first. A line that
/// was only thought of cannot be looked at, so its key is named.
Problem refusal(const std::vector<Problem>& faults, const fs::path& file, const Draft& draft) {
  Problem out = faults.front();
  const ChangedValue* of = nullptr;
  for (const ChangedValue& value : draft.values) {
    const std::string line = changes::line_of_key(draft.text, file.string(), value.key);
    const auto own = std::ranges::find_if(faults, [&line](const Problem& fault) {
      return !line.empty() && fault.where.starts_with(line);
    });
    if (own == faults.end()) continue;
    out = *own;
    of = &value;
    break;
  }
  // Behind a line that was added the others have moved, too.
  if (of == nullptr)
    for (const ChangedValue& value : draft.values)
      if (!value.put.empty() && out.where.starts_with(file.string() + ":")) of = &value;
  if (of != nullptr && !of->put.empty()) out.where = file.string() + ", " + of->key;
  out.what += " So nothing was changed.";
  return out;
}

/// Removes what killed writers of `file` left beside it: ".NAME.PROCESS-N.part".
void remove_leftovers(const fs::path& file) {
  const std::string start = "." + file.filename().string() + ".";
  std::error_code gone;
  for (fs::directory_iterator it(file.parent_path(), gone), end; !gone && it != end;
       it.increment(gone)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(".part")) continue;
    pid_t process = 0;
    std::from_chars(name.data() + start.size(), name.data() + name.size(), process);
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) fs::remove(it->path(), gone);
  }
}

/// What the disk did not allow, for somebody at a terminal.
Problem nothing_written(Problem fault) {
  fault.what += " The file is as it was.";
  if (fault.remedy.starts_with("Let user number"))
    fault.remedy = "Write sudo before the command. Or: " + fault.remedy;
  return fault;
}

/// Writes `text` in the place of `before`, and nothing if the file is not `before` any more.
Result<void> replace(const fs::path& file, const std::string& before, const std::string& text) {
  const auto now = toml::read_toml_text(file);
  if (!now) return tl::unexpected(now.error());
  if (*now != before)
    return problem(file.string(),
                   "Somebody else changed this file at the same moment. So nothing was changed.",
                   "Look at the file, and try again.", kAnotherFile);
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (!error) remove_leftovers(real);
  auto written = files::write_durably(file, std::as_bytes(std::span(text)));
  if (!written) return tl::unexpected(nothing_written(std::move(written.error())));
  files::step_done("file replaced");
  return {};
}

/// Takes `part` out of `text`; false where it does not stand there exactly once.
bool erase_once(std::string& text, const std::string& part) {
  const std::size_t found = text.find(part);
  if (part.empty() || found == std::string::npos || text.find(part, found + 1) != std::string::npos)
    return false;
  text.erase(found, part.size());
  return true;
}

std::string without_empty_lines(const std::string& lines) {
  const std::size_t first = std::min(lines.find_first_not_of("\r\n"), lines.size());
  return lines.substr(first, lines.find_last_not_of("\r\n") + 1 - first);
}

/// Puts back a table that was taken out, at the end, or takes out an added one in which a hand has
/// written nothing. False where that cannot be.
bool put_table_back(const ChangedValue& value, std::string& text) {
  const bool there = !changes::line_of_key(text, "", value.key).empty();
  if (there == value.is.empty()) return false;
  if (there) {
    const auto key = changes::typed_key(text, toml::TomlPlaces(text), value.key, "");
    if (!key) return false;
    const auto out = toml::without_table(text, key->path, "");
    if (!out || without_empty_lines(out->was) != without_empty_lines(value.put)) return false;
    text = out->text;
    return true;
  }
  text += (text.empty() || text.ends_with('\n') ? "\n" : "\n\n") + value.was;
  return toml::TomlReader::of_text(text, "").ok();
}

/// The value of `revision` put back into `now`, which has changed elsewhere since. None where it
/// does not stand there as it was set.
std::optional<std::string> put_back(const Revision& revision, const std::string& now) {
  std::string text = now;
  for (auto value = revision.values.rbegin(); value != revision.values.rend(); ++value) {
    if (value->is_table) {
      if (!put_table_back(*value, text)) return std::nullopt;
      continue;
    }
    const toml::TomlPlaces places(text);
    const auto key = changes::typed_key(text, places, value->key, "");
    const toml::TomlPlaces::Value* there = key ? places.value(key->path) : nullptr;
    if (value->is.empty()) {  // it was taken out
      if (!key || there != nullptr) return std::nullopt;
      auto back = toml::with_value(text, key->path, value->was, "");
      if (!back) return std::nullopt;
      text = std::move(back->text);
      continue;
    }
    if (there == nullptr || text.substr(there->begin, there->end - there->begin) != value->is)
      return std::nullopt;
    if (!value->was.empty()) {
      text.replace(there->begin, there->end - there->begin, value->was);
      continue;
    }
    if (!erase_once(text, value->put)) return std::nullopt;
    if (toml::TomlPlaces(text).value(key->path) != nullptr) return std::nullopt;
  }
  return text;
}

/// The file's text `before` with `changes`.
Result<Draft> draft_of(const fs::path& file, const std::string& before,
                       const std::vector<changes::Change>& changes) {
  if (const toml::TomlReader reader = toml::TomlReader::of_text(before, file.string());
      !reader.ok())
    return tl::unexpected(reader.problems().front());
  const fields::FieldList* list = fields_of(exhibit::kind_of_toml(file));
  Draft draft{before, {}, false};
  for (const changes::Change& change : changes)
    if (auto made = changes::make_change(draft, list, change, file.string()); !made)
      return tl::unexpected(made.error());
  return draft;
}

/// The newest one, if it is called `id`.
Result<Revision> newest_of(const Revisions& revisions, const std::string& id = "") {
  const auto all = revisions.read();
  if (!id.empty() && (all.empty() || all.front().kept_in.stem().string() != id))
    return problem("onggi undo", "Another change was made or taken back meanwhile.",
                   "Look at the list again.", kAnotherFile);
  if (all.empty())
    return problem("onggi undo", "There is no change to take back.",
                   "onggi undo takes back what onggi set changed.");
  return all.front();
}

}  // namespace

Result<Draft> with_changes(const fs::path& file, const std::vector<changes::Change>& changes) {
  const auto before = toml::read_toml_text(file);
  if (!before) return tl::unexpected(before.error());
  return draft_of(file, *before, changes);
}

Result<Edited> set_values(const fs::path& file, const std::vector<changes::Change>& changes,
                          const std::string& tag) {
  const auto before = toml::read_toml_text(file);
  if (!before) return tl::unexpected(before.error());
  if (!tag.empty() && tag != changes::tag_of(*before))
    return problem(file.string(),
                   "Somebody else has changed this file since you looked at it. So nothing was "
                   "changed.",
                   "Look at it again, and make your change once more.", kAnotherFile);
  const auto draft = draft_of(file, *before, changes);
  if (!draft) return tl::unexpected(draft.error());
  Edited out{changes::revision_of(*before, draft->text), draft->restarts_console};
  if (draft->text == *before) return out;
  if (const auto faults = new_faults(file, draft->text); !faults.empty())
    return tl::unexpected(refusal(faults, file, *draft));
  out.revision.file = file;
  out.revision.values = draft->values;
  Revisions revisions(file);
  if (auto locked = revisions.lock(); !locked)
    return tl::unexpected(nothing_written(std::move(locked.error())));
  revisions.tidy();
  if (auto kept = revisions.keep(out.revision); !kept)
    return tl::unexpected(nothing_written(std::move(kept.error())));
  if (auto written = replace(file, *before, draft->text); !written) {
    static_cast<void>(revisions.forget(out.revision));
    return tl::unexpected(written.error());
  }
  revisions.tidy();
  return out;
}

Result<Undone> undo(const fs::path& file, const std::string& id) {
  Revisions revisions(file);
  if (auto none = newest_of(revisions, id); !none) return tl::unexpected(none.error());
  if (auto locked = revisions.lock(); !locked)
    return tl::unexpected(nothing_written(std::move(locked.error())));
  auto newest = newest_of(revisions, id);
  if (!newest) return tl::unexpected(newest.error());
  Undone out{*newest, false};
  const auto now = toml::read_toml_text(newest->file);
  if (!now) return tl::unexpected(now.error());
  auto old = newest->taken_from(*now);
  if (!old) {
    old = put_back(*newest, *now);
    out.kept_others = true;
  }
  if (!old)
    return problem(newest->file.string(),
                   "This file was changed by hand after " + newest->when +
                       ", and what was set then does not stand there any more: " +
                       changes::words_of(*newest) + ". So nothing was changed.",
                   "Set the value that you want: onggi set FILE KEY VALUE. To go on to the change "
                   "before: onggi undo --forget, then onggi undo.");
  if (auto faults = new_faults(newest->file, *old); !faults.empty()) {
    faults.front().what += " So nothing was taken back.";
    return tl::unexpected(std::move(faults.front()));
  }
  if (auto written = replace(newest->file, *now, *old); !written)
    return tl::unexpected(written.error());
  if (auto forgotten = revisions.forget(*newest); !forgotten)
    return tl::unexpected(forgotten.error());
  revisions.tidy();
  return out;
}

Result<Revision> forget_newest(const fs::path& file, const std::string& id) {
  Revisions revisions(file);
  if (auto none = newest_of(revisions, id); !none) return none;
  if (auto locked = revisions.lock(); !locked)
    return tl::unexpected(nothing_written(std::move(locked.error())));
  auto newest = newest_of(revisions, id);
  if (!newest) return newest;
  if (auto forgotten = revisions.forget(*newest); !forgotten)
    return tl::unexpected(forgotten.error());
  return newest;
}

}  // namespace onggi::editing
