#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "kiosk/keepsake/phone/answers.h"

namespace onggi::phone {

/// Answers phones over HTTP/1.1 on one thread: small requests, no keep-alive, at most ten seconds
/// each and 64 at once. Writes no log of requests.
class Server {
 public:
  /// Listens at `address` (an IP of this machine) and `port` (0: any free one). Problem, exit 1, if
  /// it cannot.
  static Result<std::unique_ptr<Server>> listen(const std::string& address, std::uint16_t port,
                                                const Answers& answers);
  ~Server();

  std::uint16_t port() const;
  /// Answers until stop(). Calls `minutely` at the start and once a minute.
  void run(const std::function<void()>& minutely);
  /// Any thread, or a signal handler.
  void stop();

 private:
  struct Inside;
  explicit Server(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace onggi::phone
