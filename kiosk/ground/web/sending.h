#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "kiosk/ground/web/message.h"

namespace onggi::web {

/// An answer on its way into a socket: text, then part of a file. The file's bytes go from the
/// disk's cache to the socket (sendfile) and are never in this process; bytes that are made of it
/// are made a piece at a time. One thread.
class Sending {
 public:
  /// Bytes of one step(), at most: phones take turns.
  static constexpr std::size_t kPiece = 16384;

  Sending(std::string text, SentFile file, Span span)
      : text_(std::move(text)), file_(std::move(file)), at_(span.from), left_(span.length) {}

  enum class Step {
    more,    ///< Wait until the socket takes more.
    all,     ///< Everything was given to the socket.
    broken,  ///< The phone is gone, or the file is shorter than it was.
  };
  /// Gives the next piece to `socket`, without waiting.
  Step step(int socket);
  /// True if the file has been deleted meanwhile.
  bool deleted() const;
  /// Bytes that were given to the socket so far.
  std::uint64_t given() const { return given_; }
  /// Bytes of the answer that this process holds.
  std::size_t held() const { return text_.capacity(); }

 private:
  std::int64_t send_part(int socket);

  std::string text_;
  std::size_t said_ = 0;  // bytes of text_
  SentFile file_;
  std::uint64_t at_, left_;  // of what is sent
  std::uint64_t given_ = 0;
};

/// Bytes given to `socket` that the phone has not confirmed; nothing where the system cannot say.
std::optional<std::size_t> unconfirmed(int socket);

/// Keeps what waits in the system for `socket` small: 64 KiB that are not on their way yet.
void keep_small(int socket);

}  // namespace onggi::web
