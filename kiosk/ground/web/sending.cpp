#include "kiosk/ground/web/sending.h"

#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/sendfile.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <cerrno>
#include <span>

namespace onggi::web {

namespace {

constexpr int kMostThatWaits = 65536;

/// True where the socket takes nothing more just now.
bool full(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

Sending::Step Sending::step(int socket) {
  std::int64_t n = 0;
  if (said_ < text_.size()) {
    n = ::send(socket, text_.data() + said_, std::min(text_.size() - said_, kPiece),
               MSG_NOSIGNAL | MSG_DONTWAIT | (left_ > 0 ? MSG_MORE : 0));
    if (n > 0) said_ += static_cast<std::size_t>(n);
    if (said_ == text_.size()) std::string().swap(text_), said_ = 0;
  } else if (left_ > 0) {
    n = send_part(socket);
    if (n == 0) return Step::broken;
    if (n > 0) at_ += static_cast<std::uint64_t>(n), left_ -= static_cast<std::uint64_t>(n);
  }
  if (n < 0) return full(errno) ? Step::more : Step::broken;
  given_ += static_cast<std::uint64_t>(n);
  return text_.empty() && left_ == 0 ? Step::all : Step::more;
}

/// Bytes that the socket took; 0 if the file is shorter than it was, below 0 with errno set.
std::int64_t Sending::send_part(int socket) {
  const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(left_, kPiece));
  auto at = static_cast<off_t>(at_);
  if (!file_.made) return ::sendfile(socket, file_.file.get(), &at, size);
  std::array<std::byte, kPiece> piece;
  if (!file_.made(file_.file, at_, std::span(piece).first(size))) return 0;
  return ::send(socket, piece.data(), size, MSG_NOSIGNAL | MSG_DONTWAIT);
}

bool Sending::deleted() const {
  struct stat info {};
  return file_.file.open() && ::fstat(file_.file.get(), &info) == 0 && info.st_nlink == 0;
}

std::optional<std::size_t> unconfirmed(int socket) {
  int bytes = 0;
  if (::ioctl(socket, SIOCOUTQ, &bytes) != 0 || bytes < 0) return {};
  return static_cast<std::size_t>(bytes);
}

void keep_small(int socket) {
  // If the system knows no such wish, more waits there, and nothing else changes.
  static_cast<void>(
      ::setsockopt(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kMostThatWaits, sizeof kMostThatWaits));
}

}  // namespace onggi::web
