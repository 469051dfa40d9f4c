#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/fields/field.h"

namespace onggi::changes {

/// What adds a whole table, in place of a value: an effect (slump), a mission (mission.litre_jar).
inline constexpr const char* kNewTable = "{}";

/// What somebody wants of one key of a file, or of one of its optional tables.
struct Change {
  std::string key;                   ///< As a person types it: "idle.warn_after".
  std::optional<std::string> value;  ///< Likewise (typed_value()), or kNewTable; none: it is taken
                                     ///< out.
};

/// One value that a change set, as the file writes it.
struct ChangedValue {
  std::string key;        ///< "idle.warn_after", "step.open.after".
  std::string was;        ///< "60", of a table all its lines; "": it was not written.
  std::string is;         ///< "90", kNewTable; "": it is not written any more.
  std::string put;        ///< The bytes that were added for it; "": it was written.
  bool is_table = false;  ///< `key` is a table or an element of a list.
};

/// A text of a file with some of its values changed, and nothing written yet.
struct Draft {
  std::string text;
  std::vector<ChangedValue> values;  ///< Those that differ from what stood there.
  bool restarts_console = false;     ///< One of them is only read when onggi-console starts.
};

/// Makes `change` in `draft`, whose keys are `list` (null: not known). Every other byte stays.
/// Problem, called `name`, for a key or a value that cannot be: then `draft` stays as it was.
Result<void> make_change(Draft& draft, const fields::FieldList* list, const Change& change,
                         const std::string& name);

/// "name:line:", where the value or table `key` stands in `text`; "" where it does not.
std::string line_of_key(const std::string& text, const std::string& name, const std::string& key);

/// The same for the same bytes, another for others: so a change meets the file that it was meant
/// for. Two texts of one size have the same with a chance of 2^-32.
std::string tag_of(const std::string& text);

}  // namespace onggi::changes
