#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/ground/files/descriptor.h"
#include "kiosk/ground/web/byte_range.h"

namespace onggi::web {

class ReceivedFile;

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
  std::optional<std::uint64_t> length{};  ///< Content-Length: bytes of the body.
  /// The body, where it went into a file (IntoFile); whoever answers may keep it or move it away.
  std::shared_ptr<ReceivedFile> file{};
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

/// A body that is short enough for memory, as Ask::body.
struct IntoMemory {};

/// A body that is written to a file while it arrives, as Ask::file.
struct IntoFile {
  std::filesystem::path folder;  ///< Is there already, on the disk where the file shall stay.
  std::uint64_t most = 0;        ///< Bytes; a longer body is refused before it is read.
  std::uint64_t reserve = std::uint64_t{1} << 30;  ///< Bytes that stay free on that disk.
  /// Held as long as the file: a weak_ptr to it tells whoever answers that one is under way.
  std::shared_ptr<void> ticket{};
};

/// Where a body goes. An Answer refuses it before it is read: 503 where another one is under way.
using BodyPlace = std::variant<IntoMemory, IntoFile, Answer>;

/// Whoever answers. Uses no socket. One thread; all wait while it answers.
class Answering {
 public:
  virtual ~Answering() = default;
  virtual Answer to(const Ask& ask) = 0;
  /// The longest body of a request, bytes; a longer one is refused. Asked for once a connection.
  virtual std::size_t most_of_a_body() const { return 1024; }
  /// Where the body of a request goes. Asked once a request, with all of `head` but its body.
  virtual BodyPlace place_for_body(const Ask& head);
  /// The words with which a body does not become a file: `why` says what and what to do.
  virtual Answer refusal(int status, const Problem& why);
};

/// The value of `name` in a query: the text after a target's '?'. As it was sent; "" if it is not
/// there.
std::string asked_for(std::string_view target, std::string_view name);

/// `file`, or what `ask` wants of it.
Answer part_of(SentFile file, const std::string& type, const Ask& ask);

}  // namespace onggi::web
