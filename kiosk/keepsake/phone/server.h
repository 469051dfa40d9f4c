#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/result.h"
#include "kiosk/keepsake/phone/answers.h"

namespace onggi::phone {

/// Answers phones over HTTP/1.1 on one thread: small requests, no keeping alive, ten seconds for
/// each, and 64 at once at most. Writes no log of who asked.
class Server {
 public:
  /// Listens at `address` (an IP of this machine's) and `port` (0: any that is free). Problem, exit
  /// 1, where it cannot.
  static Result<std::unique_ptr<Server>> listen(const std::string& address, std::uint16_t port,
                                                const Answers& answers);
  ~Server();

  std::uint16_t port() const;
  /// Answers until stop(). `minutely` is called once a minute, and at the start.
  void run(const std::function<void()>& minutely);
  /// Any thread, or a signal.
  void stop();

 private:
  struct Inside;
  explicit Server(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace onggi::phone
