#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <utility>

namespace onggi::phone::test {

/// One connection of a phone, over a real socket of this machine.
class PhoneConnection {
 public:
  /// From the loopback's address `from`; `room`: bytes that the system may keep for it, 0: as
  /// usual.
  explicit PhoneConnection(std::uint16_t port, const char* from = "127.0.0.1", int room = 0)
      : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (room > 0) setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    sockaddr_in own = place(from, 0), to = place("127.0.0.1", port);
    good_ = bind(socket_, reinterpret_cast<sockaddr*>(&own), sizeof own) == 0 &&
            connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) == 0;
  }
  PhoneConnection(PhoneConnection&& other) noexcept
      : socket_(std::exchange(other.socket_, -1)), good_(other.good_) {}
  ~PhoneConnection() {
    if (socket_ >= 0) ::close(socket_);
  }
  bool say(const std::string& words) {
    return good_ && ::send(socket_, words.data(), words.size(), MSG_NOSIGNAL) ==
                        static_cast<ssize_t>(words.size());
  }
  /// Up to `most` bytes, once there are some; "" where the other end has closed.
  std::string some(std::size_t most) {
    std::string heard(most, '\0');
    const ssize_t n = ::recv(socket_, heard.data(), most, 0);
    heard.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return heard;
  }
  std::string to_the_end() {
    std::string heard;
    for (std::string more; !(more = some(1 << 16)).empty();) heard += more;
    return heard;
  }
  /// True if the other end has closed within `patience` ms; says nothing of what it sent.
  bool closed(int patience) const {
    pollfd asked{socket_, POLLIN, 0};
    char byte = 0;
    return poll(&asked, 1, patience) == 1 && ::recv(socket_, &byte, 1, MSG_PEEK) <= 0;
  }

 private:
  static sockaddr_in place(const char* address, std::uint16_t port) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(port);
    inet_pton(AF_INET, address, &place.sin_addr);
    return place;
  }
  int socket_;
  bool good_ = false;
};

/// A request; `more`: whole lines of its head.
inline std::string request(const std::string& target, const std::string& method = "GET",
                           const std::string& more = {}) {
  return method + ' ' + target + " HTTP/1.1\r\nHost: kiosk\r\n" + more + "\r\n";
}

/// Says `words` to the server at `port` and hears it to the end.
inline std::string hear(std::uint16_t port, const std::string& words) {
  PhoneConnection phone(port);
  return phone.say(words) ? phone.to_the_end() : std::string();
}

inline std::string head_of(const std::string& answer) {
  return answer.substr(0, answer.find("\r\n\r\n"));
}
inline std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

}  // namespace onggi::phone::test
