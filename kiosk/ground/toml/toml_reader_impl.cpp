#include "kiosk/ground/toml/toml_reader_impl.h"

#include <charconv>
#include <cmath>

namespace onggi::toml {
namespace {

/// The shortest digits that read back as the same number.
std::string digits(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return std::string(buffer, end.ptr);
}

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : number + " " + std::string(unit);
}

/// A value in plain words: `the text "fast"`, `a list of 3`.
std::string in_words(const ::toml::node& node) {
  if (const auto* text = as<std::string>(node)) return "the text \"" + shown(*text, 40) + "\"";
  if (const auto* whole = as<std::int64_t>(node)) return std::to_string(*whole);
  if (const auto* number = as<double>(node)) return digits(*number);
  if (const auto* yes = as<bool>(node)) return *yes ? "true" : "false";
  if (const auto* list = node.as_array()) return "a list of " + std::to_string(list->size());
  if (node.is_table()) return "a table";
  return "a date or time";
}

/// Any finite number, whole or not.
bool finite_number(const ::toml::node& node, double& out) {
  if (const auto* whole = as<std::int64_t>(node)) {
    out = static_cast<double>(*whole);
    return true;
  }
  const auto* number = as<double>(node);
  if (number == nullptr || !std::isfinite(*number)) return false;
  out = *number;
  return true;
}

std::string span_words(const std::string& kind, double low, double high, std::string_view unit) {
  const bool from = std::isfinite(low), to = std::isfinite(high);
  if (from && to)
    return "Write " + kind + " from " + digits(low) + " to " + with_unit(digits(high), unit) +
           ", without quotes.";
  if (from) return "Write " + kind + " of at least " + with_unit(digits(low), unit) + ".";
  if (to) return "Write " + kind + " of at most " + with_unit(digits(high), unit) + ".";
  return "Write " + kind + ", without quotes.";
}

}  // namespace

void TomlReader::Table::Impl::wrong_type(std::string_view key, const ::toml::node& value,
                                         const std::string& wanted, std::string remedy) {
  file->note(file->place(value.source()),
             full(key) + " is " + in_words(value) + ", but must be " + wanted + ".",
             std::move(remedy));
}

void TomlReader::Table::Impl::out_of_range(std::string_view key, const ::toml::node& value,
                                           double low, double high, std::string_view unit,
                                           const std::string& remedy) {
  double number = 0.0;
  finite_number(value, number);
  const bool small = number < low;
  file->note(file->place(value.source()),
             full(key) + " is " + with_unit(in_words(value), unit) + ", but the " +
                 (small ? "smallest" : "largest") + " allowed value is " +
                 with_unit(digits(small ? low : high), unit) + ".",
             remedy);
}

const ::toml::array* TomlReader::Table::Impl::ask_list(std::string_view key,
                                                       const std::string& wanted,
                                                       const std::string& remedy) {
  const ::toml::node* value = ask(key);
  if (value == nullptr) return nullptr;
  if (const ::toml::array* list = value->as_array()) return list;
  wrong_type(key, *value, wanted, remedy);
  return nullptr;
}

bool TomlReader::Table::number(std::string_view key, double& out, double low, double high,
                               std::string_view unit) {
  const ::toml::node* value = impl_->ask(key);
  if (value == nullptr) return false;
  const std::string remedy = span_words("a number", low, high, unit);
  double number = 0.0;
  if (!finite_number(*value, number)) {
    impl_->wrong_type(key, *value, "a number", remedy);
    return false;
  }
  if (number < low || number > high) {
    impl_->out_of_range(key, *value, low, high, unit, remedy);
    return false;
  }
  out = number;
  return true;
}

bool TomlReader::Table::integer(std::string_view key, int& out, int low, int high,
                                std::string_view unit) {
  const ::toml::node* value = impl_->ask(key);
  if (value == nullptr) return false;
  const std::string remedy = span_words("a whole number", low, high, unit);
  const auto* whole = as<std::int64_t>(*value);
  if (whole == nullptr) {
    impl_->wrong_type(key, *value, "a whole number", remedy);
    return false;
  }
  if (*whole < low || *whole > high) {
    impl_->out_of_range(key, *value, low, high, unit, remedy);
    return false;
  }
  out = static_cast<int>(*whole);
  return true;
}

bool TomlReader::Table::boolean(std::string_view key, bool& out) {
  const ::toml::node* value = impl_->ask(key);
  if (value == nullptr) return false;
  const auto* yes = as<bool>(*value);
  if (yes == nullptr) {
    impl_->wrong_type(key, *value, "true or false", "Write true or false, without quotes.");
    return false;
  }
  out = *yes;
  return true;
}

bool TomlReader::Table::text(std::string_view key, std::string& out) {
  const ::toml::node* value = impl_->ask(key);
  if (value == nullptr) return false;
  const auto* text = as<std::string>(*value);
  if (text == nullptr) {
    impl_->wrong_type(key, *value, "a text", "Write the text in \"quotes\".");
    return false;
  }
  out = *text;
  return true;
}

bool TomlReader::Table::texts(std::string_view key, std::vector<std::string>& out) {
  const std::string remedy = "Write a list of texts: [\"one\", \"two\"].";
  const ::toml::array* list = impl_->ask_list(key, "a list of texts", remedy);
  if (list == nullptr) return false;
  std::vector<std::string> read;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const auto* text = as<std::string>((*list)[i]);
    if (text == nullptr) {
      impl_->wrong_type(impl_->element(key, i), (*list)[i], "a text", remedy);
    } else {
      read.push_back(*text);
    }
  }
  if (read.size() != list->size()) return false;
  out = std::move(read);
  return true;
}

bool TomlReader::Table::numbers(std::string_view key, std::vector<double>& out) {
  const std::string remedy = "Write a list of numbers: [1.0, 2.5].";
  const ::toml::array* list = impl_->ask_list(key, "a list of numbers", remedy);
  if (list == nullptr) return false;
  std::vector<double> read(list->size());
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    if (!finite_number((*list)[i], read[i])) {
      impl_->wrong_type(impl_->element(key, i), (*list)[i], "a number", remedy);
      good = false;
    }
  }
  if (good) out = std::move(read);
  return good;
}

bool TomlReader::Table::points(std::string_view key, std::vector<OutlinePoint>& out,
                               std::string_view axes) {
  const std::string two(axes), remedy = "Write a list of points, each [" + two + "], or [" + two +
                                        ", \"corner\"] where the line turns sharply.";
  const ::toml::array* list = impl_->ask_list(key, "a list of points", remedy);
  if (list == nullptr) return false;
  std::vector<OutlinePoint> read(list->size());
  bool good = true;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const ::toml::array* point = (*list)[i].as_array();
    if (point == nullptr || point->size() < 2 || point->size() > 3 ||
        !finite_number((*point)[0], read[i].radius) ||
        !finite_number((*point)[1], read[i].height)) {
      impl_->wrong_type(impl_->element(key, i), (*list)[i], "a point", remedy);
      good = false;
    } else if (point->size() == 3) {
      const auto* word = as<std::string>((*point)[2]);
      read[i].corner = word != nullptr && *word == "corner";
      if (!read[i].corner) {
        impl_->wrong_type(impl_->element(key, i) + "[2]", (*point)[2], "the word \"corner\"",
                          remedy);
        good = false;
      }
    }
  }
  if (good) out = std::move(read);
  return good;
}

}  // namespace onggi::toml
