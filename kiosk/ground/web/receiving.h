#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "engine/base/result.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/ground/web/received_file.h"

namespace onggi::web {

/// Why a body does not become a file.
struct Refusal {
  int status = 507;  ///< 411: no length; 413: too long; 507: no room; 500: the disk refuses.
  Problem why;
};

/// A body on its way from a socket into a file. One piece of it is in this process at a time. A
/// piece goes into the system's cache in a fraction of a millisecond, and all others have their
/// turn before the next one; only where the disk lags far behind does the system hold the writer
/// back. One thread.
class Receiving {
 public:
  /// Bytes of one step(), at most: phones take turns.
  static constexpr std::size_t kPiece = 65536;

  /// Opens the file for a body of `length` bytes, of which `first` came with the head: at most
  /// `length` of them are taken. Refusal, and no file, where the length was not said, where it is
  /// more than `into.most`, and where the disk has not the room.
  static tl::expected<Receiving, Refusal> begin(const IntoFile& into,
                                                std::optional<std::uint64_t> length,
                                                std::span<const std::byte> first);

  enum class Step {
    more,    ///< Wait until the socket has more.
    all,     ///< The file is whole.
    broken,  ///< The browser is gone.
    failed,  ///< The disk refuses: failure() says why.
  };
  /// Takes the next piece from `socket`, without waiting.
  Step step(int socket);
  /// Why the last step failed.
  Refusal failure() const;
  /// Bytes that arrived so far.
  std::uint64_t received() const { return file_->size(); }
  /// The file, once it is whole. Call it last.
  std::shared_ptr<ReceivedFile> take() { return std::move(file_); }

 private:
  Receiving(std::shared_ptr<ReceivedFile> file, std::uint64_t length)
      : file_(std::move(file)), length_(length) {}
  Step keep(std::span<const std::byte> bytes);

  std::shared_ptr<ReceivedFile> file_;  // removed with this, unless taken
  std::uint64_t length_;
  int error_ = 0;  // errno of what the disk refused
};

}  // namespace onggi::web
