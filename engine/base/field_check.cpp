#include "engine/base/field_check.h"

#include <cmath>
#include <cstdio>

namespace onggi {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

void FieldCheck::range(const char* field, double value, double low, double high, const char* unit) {
  if (first_ || (std::isfinite(value) && low <= value && value <= high)) return;
  const std::string tail = *unit != '\0' ? std::string(" ") + unit : std::string();
  const std::string span = number_text(low) + " to " + number_text(high) + tail;
  std::string written = number_text(value);
  if (written == number_text(low) || written == number_text(high)) {
    // As many digits as tell it from the bound that it breaks.
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.17g", value);
    written = digits;
  }
  require(false, field, "is " + written + tail + ", outside " + span + ".",
          "Write a number from " + span + ".");
}

void FieldCheck::require(bool kept, const char* field, std::string what, std::string remedy) {
  if (first_ || kept) return;
  const std::string name = where_.empty() ? field : where_ + "." + field;
  first_ = Problem{name, name + " " + std::move(what), std::move(remedy)};
}

Result<void> FieldCheck::result() const {
  if (first_) return tl::unexpected<Problem>(*first_);
  return {};
}

}  // namespace onggi
