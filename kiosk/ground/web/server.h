#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "kiosk/ground/web/call.h"
#include "kiosk/ground/web/message.h"

namespace onggi::web {

/// Where to listen, as somebody writes it: "127.0.0.1:8080", "[::1]:8080" or "::1:8080"; or
/// "unix:/run/onggi-console/page.sock".
struct Listening {
  std::string address;  ///< Without brackets.
  std::uint16_t port = 0;
  std::filesystem::path file{};  ///< Of a Unix socket; then there is no address.
};
/// Problem, exit 2, if `text` is none. Whether the machine has the address is not asked.
Result<Listening> listening(const std::string& text);

/// Answers browsers over HTTP/1.1 on one thread: small requests, no keep-alive. Writes no log of
/// requests.
class Server {
 public:
  struct Limits {
    /// Connections at once; fewer where the system allows fewer open files, for each may have a
    /// file. ConnectionShares says who goes when more come.
    std::size_t connections = 16384;
    Patience patience{};
  };
  /// Listens at `address` (an IP of this machine) and `port` (0: any free one). Problem, exit 1, if
  /// it cannot.
  static Result<std::unique_ptr<Server>> listen(const std::string& address, std::uint16_t port,
                                                Answering& answers, const Limits& limits);
  static Result<std::unique_ptr<Server>> listen(const std::string& address, std::uint16_t port,
                                                Answering& answers) {
    return listen(address, port, answers, Limits());
  }
  /// Listens at the Unix socket `file`, for a proxy of this machine: its user and group may
  /// connect, nobody else. A socket that no program serves any more is replaced, and the socket
  /// goes with the server. Problem, exit 1.
  static Result<std::unique_ptr<Server>> listen(const std::filesystem::path& file,
                                                Answering& answers, const Limits& limits);
  ~Server();

  std::uint16_t port() const;  ///< 0 at a Unix socket.
  /// Answers until stop(). Calls `look_after` at the start and once a minute; while it returns
  /// true, again, as soon as those who were waiting have had their turn.
  void run(const std::function<bool()>& look_after);
  /// Any thread, or a signal handler.
  void stop();

 private:
  struct Inside;
  explicit Server(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace onggi::web
