#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/web/byte_range.h"

namespace onggi::web {

/// A browser's request. A field that was not sent is empty.
struct Ask {
  std::string method, target;  ///< "GET", "/k/TOKEN?lang=ko"
  std::string languages{};     ///< Accept-Language
  std::string range{};         ///< Range: of a file alone,
  std::string if_range{};      ///< and only if the file still has this tag (If-Range).
  std::string host{};          ///< Host
  std::string origin{};        ///< Origin: the page that asks.
  std::string cookie{};        ///< Cookie
  std::string type{};          ///< Content-Type
  std::string if_none_match{};
  std::string body{};
  std::string from{};  ///< The address that it comes from, "127.0.0.1"; a proxy at a Unix socket
                       ///< says it as X-Real-IP.
};

/// Bytes that are sent from a file, or made of it, a piece at a time.
struct SentFile {
  files::Descriptor file;
  std::uint64_t size = 0;  ///< Bytes when it was opened.
  std::string tag{};       ///< The same for the same bytes, another for others.
  /// Fills `into` with the bytes from `from` on; false if the file has changed. Empty: the file's
  /// own bytes.
  std::function<bool(const files::Descriptor& file, std::uint64_t from, std::span<std::byte> into)>
      made{};
};

/// The answer to it.
struct Answer {
  int status = 404;
  std::string type = "text/html; charset=utf-8";
  std::string body{};
  std::string file_name{};         ///< If not empty: the file is saved under this name.
  std::optional<SentFile> file{};  ///< Its bytes follow the body:
  Span span{};                     ///< these.
  std::vector<std::pair<std::string, std::string>> fields{};  ///< Further fields of the head.
};

/// Whoever answers. Uses no socket. One thread; all wait while it answers.
class Answering {
 public:
  virtual ~Answering() = default;
  virtual Answer to(const Ask& ask) = 0;
  /// The longest body of a request, bytes; a longer one is refused. Asked for once a connection.
  virtual std::size_t most_of_a_body() const { return 1024; }
};

/// The value of `name` in a query: the text after a target's '?'. As it was sent; "" if it is not
/// there.
std::string asked_for(std::string_view target, std::string_view name);

/// `file`, or what `ask` wants of it.
Answer part_of(SentFile file, const std::string& type, const Ask& ask);

}  // namespace onggi::web
