#pragma once

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "kiosk/ground/web/received_file.h"
#include "kiosk/ground/web/server.h"
#include "tests/kiosk/keepsake/phone/phone_client.h"

namespace onggi::web::test {

/// Takes files at /file, one at a time; keeps them if told so. Answers "hello" to all else.
class Taker final : public Answering {
 public:
  explicit Taker(std::filesystem::path folder) { into.folder = std::move(folder); }
  BodyPlace place_for_body(const Ask& head) override {
    if (head.target != "/file" || head.method != "POST") return IntoMemory{};
    if (!under_way.expired()) return refusal(503, {"", "One is under way.", "Wait."});
    IntoFile place = into;
    place.ticket = std::make_shared<int>(0);
    under_way = place.ticket;
    return place;
  }
  Answer to(const Ask& ask) override {
    if (!ask.file) return {.status = 200, .type = "text/plain", .body = "hello " + ask.body};
    const bool good = keep_as.empty() || ask.file->move_to(keep_as);
    return {.status = good ? 200 : 500,
            .type = "text/plain",
            .body = "took " + std::to_string(ask.file->size())};
  }

  IntoFile into{.folder = {}, .most = std::uint64_t{1} << 30, .reserve = 0};
  std::filesystem::path keep_as;
  std::weak_ptr<void> under_way;
};

/// A server for the life of this, at a port of this machine.
class Serving {
 public:
  explicit Serving(Answering& answers, const Patience& patience = {})
      : server_(Server::listen("127.0.0.1", 0, answers, {.connections = 64, .patience = patience})
                    .value()),
        port_(server_->port()),
        runs_([this] { server_->run([] { return false; }); }) {}
  ~Serving() {
    server_->stop();
    runs_.join();
  }
  Serving(const Serving&) = delete;
  Serving& operator=(const Serving&) = delete;
  std::uint16_t port() const { return port_; }

 private:
  std::unique_ptr<Server> server_;
  std::uint16_t port_;
  std::thread runs_;
};

/// The head of a request that sends a file of `length` bytes.
inline std::string file_head(std::uint64_t length, const std::string& more = {}) {
  return phone::test::request("/file", "POST",
                              "Content-Length: " + std::to_string(length) + "\r\n" + more);
}

/// Says `megabytes` of zeros; false where the other end has closed.
inline bool say_megabytes(phone::test::PhoneConnection& browser, int megabytes) {
  const std::string one(1 << 20, '\0');
  for (int n = 0; n < megabytes; ++n)
    if (!browser.say(one)) return false;
  return true;
}

/// True once `what` is, within ten seconds.
inline bool soon(const std::function<bool()>& what) {
  for (int n = 0; n < 1000 && !what(); ++n)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return what();
}

}  // namespace onggi::web::test
