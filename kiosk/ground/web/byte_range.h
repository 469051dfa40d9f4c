#pragma once

#include <cstdint>
#include <string_view>

namespace onggi::web {

/// Bytes [from, from + length) of a file.
struct Span {
  std::uint64_t from = 0, length = 0;
  friend bool operator==(const Span&, const Span&) = default;
};

/// What a Range header asks of a file (RFC 9110, 14).
struct ByteRange {
  enum class Kind {
    whole,   ///< The whole file: no header, one that is not understood, or several spans at once.
    span,    ///< Part of it.
    beyond,  ///< Bytes that the file does not have.
  };
  Kind kind = Kind::whole;
  Span span{};  ///< Inside the file; all of it where `kind` is whole.
};

/// `header` ("bytes=500-", "bytes=0-99", "bytes=-100") of a file of `size` bytes. Total: any text.
ByteRange byte_range(std::string_view header, std::uint64_t size);

}  // namespace onggi::web
