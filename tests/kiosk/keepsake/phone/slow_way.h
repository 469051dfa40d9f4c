#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "tests/kiosk/keepsake/phone/phone_client.h"

namespace onggi::phone::test {

/// A slow and lossy way between phones and the server at `port`, on a thread for each connection:
/// the answer goes on in bursts of random length with a pause after each, and the way breaks after
/// a random number of bytes. Same seed, same breaks for the same order of connections.
class SlowWay {
 public:
  struct Loss {
    std::size_t burst = 32768;                  ///< Bytes at once, at most.
    std::chrono::microseconds pause{200};       ///< After each burst.
    std::size_t breaks_after = ~std::size_t{};  ///< Bytes, at most, at least one.
  };
  SlowWay(std::uint16_t to, const Loss& loss, unsigned seed)
      : to_(to),
        loss_(loss),
        random_(seed),
        door_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof own;
    if (bind(door_, reinterpret_cast<sockaddr*>(&own), size) == 0 && listen(door_, 64) == 0 &&
        getsockname(door_, reinterpret_cast<sockaddr*>(&own), &size) == 0)
      port_ = ntohs(own.sin_port);
    opens_ = std::thread([this] { open(); });
  }
  ~SlowWay() {
    shutdown(door_, SHUT_RDWR);
    opens_.join();
    for (std::thread& way : ways_) way.join();
    ::close(door_);
  }
  SlowWay(const SlowWay&) = delete;
  SlowWay& operator=(const SlowWay&) = delete;
  std::uint16_t port() const { return port_; }
  /// Bytes of answers that the server sent into it, breaks or not.
  std::size_t carried() const { return carried_; }

 private:
  void open() {
    for (int phone = -1; (phone = ::accept4(door_, nullptr, nullptr, SOCK_CLOEXEC)) >= 0;) {
      const unsigned seed = static_cast<unsigned>(random_());
      ways_.emplace_back([this, phone, seed] { carry(phone, seed); });
    }
  }
  void carry(int phone, unsigned seed) {
    std::mt19937 random(seed);
    PhoneConnection server(to_);
    std::string asked(16384, '\0');
    const ssize_t n = ::recv(phone, asked.data(), asked.size(), 0);
    asked.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    std::size_t left = loss_.breaks_after == ~std::size_t{} ? loss_.breaks_after
                                                            : 1 + random() % loss_.breaks_after;
    if (server.say(asked)) {
      for (std::string some; left > 0;) {
        some = server.some(std::min<std::size_t>(left, 1 + random() % loss_.burst));
        if (some.empty()) break;
        carried_ += some.size();
        left -= some.size();
        if (::send(phone, some.data(), some.size(), MSG_NOSIGNAL) < 0) break;
        std::this_thread::sleep_for(loss_.pause);
      }
    }
    ::close(phone);
  }

  std::uint16_t to_, port_ = 0;
  Loss loss_;
  std::mt19937 random_;
  int door_;
  std::atomic<std::size_t> carried_{0};
  std::thread opens_;
  std::vector<std::thread> ways_;
};

}  // namespace onggi::phone::test
