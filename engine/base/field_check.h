#pragma once

#include <optional>
#include <string>

#include "engine/base/result.h"

namespace onggi {

/// Checks the fields of one definition and keeps the first Problem: "clay.rows is 4, outside
/// 8..20000." Allocates only for the Problem.
class FieldCheck {
 public:
  /// `where` comes before every field's name: "clay" gives "clay.rows".
  explicit FieldCheck(std::string where) : where_(std::move(where)) {}

  /// low <= value <= high, and finite. `unit` may be empty: "m", "s", "N".
  void range(const char* field, double value, double low, double high, const char* unit);
  /// Checks a condition that is more than a range.
  void require(bool kept, const char* field, std::string what, std::string remedy);

  Result<void> result() const;

 private:
  std::string where_;
  std::optional<Problem> first_;
};

/// A number as a person writes it: up to six digits, no trailing zeros.
std::string number_text(double value);

}  // namespace onggi
