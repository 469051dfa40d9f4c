#include "kiosk/ground/web/receiving.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/free_space.h"

namespace onggi::web {

namespace {

constexpr std::uint64_t kMegabyte = 1u << 20;

/// `bytes` in words; `up` rounds up.
std::string size_words(std::uint64_t bytes, bool up) {
  if (bytes < kMegabyte) return std::to_string(bytes) + " bytes";
  return std::to_string(bytes / kMegabyte + (up && bytes % kMegabyte != 0 ? 1 : 0)) + " MB";
}

std::optional<Refusal> refusal_of(const IntoFile& into, std::optional<std::uint64_t> length) {
  if (!length)
    return Refusal{411, {"", "The size of this file was not said.", "Send it with its length."}};
  if (*length > into.most)
    return Refusal{413,
                   {"", "This file has " + size_words(*length, true) + ", which is too large.",
                    "Send at most " + size_words(into.most, false) + "."}};
  const std::uint64_t free = files::free_bytes(into.folder);
  const std::uint64_t room = free - std::min(free, into.reserve);
  if (*length > room)
    return Refusal{507,
                   {"",
                    "This file has " + size_words(*length, true) + ", and the disk has room for " +
                        size_words(room, false) + ".",
                    "Free some space on the kiosk's disk, or send a smaller file.", 1}};
  return {};
}

Refusal disk_refusal(Problem why) { return {500, std::move(why)}; }

}  // namespace

tl::expected<Receiving, Refusal> Receiving::begin(const IntoFile& into,
                                                  std::optional<std::uint64_t> length,
                                                  std::span<const std::byte> first) {
  if (auto refused = refusal_of(into, length)) return tl::unexpected(std::move(*refused));
  auto file = ReceivedFile::make(into);
  if (!file) return tl::unexpected(disk_refusal(std::move(file.error())));
  Receiving receiving(std::move(*file), *length);
  const auto own = static_cast<std::size_t>(std::min<std::uint64_t>(first.size(), *length));
  if (receiving.keep(first.first(own)) == Step::failed) return tl::unexpected(receiving.failure());
  return receiving;
}

Receiving::Step Receiving::step(int socket) {
  const std::uint64_t left = length_ - file_->size();
  if (left == 0) return Step::all;
  std::array<std::byte, kPiece> piece;
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece));
  const ssize_t n = ::recv(socket, piece.data(), wanted, MSG_DONTWAIT);
  if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return Step::more;
  if (n <= 0) return Step::broken;
  return keep(std::span(piece).first(static_cast<std::size_t>(n)));
}

Receiving::Step Receiving::keep(std::span<const std::byte> bytes) {
  if (!file_->append(bytes)) {
    error_ = errno;
    return Step::failed;
  }
  return file_->size() == length_ ? Step::all : Step::more;
}

Refusal Receiving::failure() const {
  if (error_ == ENOSPC || error_ == EDQUOT)
    return {507,
            {"", "The disk became full before this file was whole, so nothing of it was kept.",
             "Free some space on the kiosk's disk, and send the file again.", 1}};
  return disk_refusal(files::disk_problem(file_->path(), "write", error_));
}

}  // namespace onggi::web
