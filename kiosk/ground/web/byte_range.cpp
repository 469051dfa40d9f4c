#include "kiosk/ground/web/byte_range.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <system_error>

namespace onggi::web {

namespace {

constexpr std::string_view kUnit = "bytes=";

/// A number of digits alone; one that is too large is the largest.
std::optional<std::uint64_t> number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size()) return {};
  if (error == std::errc::result_out_of_range) return std::numeric_limits<std::uint64_t>::max();
  if (error != std::errc()) return {};
  return value;
}

}  // namespace

ByteRange byte_range(std::string_view header, std::uint64_t size) {
  const ByteRange whole{ByteRange::Kind::whole, {0, size}};
  if (!header.starts_with(kUnit)) return whole;
  header.remove_prefix(kUnit.size());
  const auto dash = header.find('-');
  if (dash == std::string_view::npos) return whole;
  const std::string_view left = header.substr(0, dash), right = header.substr(dash + 1);
  const auto first = number(left), last = number(right);
  if ((!first && !left.empty()) || (!last && !right.empty()) || (!first && !last)) return whole;
  if (first && last && *last < *first) return whole;
  Span span;
  if (first)
    span = {*first, *first < size ? std::min(last.value_or(size - 1), size - 1) - *first + 1 : 0};
  else
    span = {size - std::min(*last, size), std::min(*last, size)};
  if (span.length == 0) return {ByteRange::Kind::beyond, {}};
  return {ByteRange::Kind::span, span};
}

}  // namespace onggi::web
