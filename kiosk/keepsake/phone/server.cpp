#include "kiosk/keepsake/phone/server.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <csignal>
#include <optional>
#include <utility>

namespace onggi::phone {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::chrono::seconds kPatience{10};
constexpr std::uint32_t kMostOfAHead = 8192;
constexpr std::uint64_t kMostOfABody = 1024;
constexpr int kMostAtOnce = 64;

/// One request and its answer.
class Call : public std::enable_shared_from_this<Call> {
 public:
  Call(Tcp::socket socket, const Answers& answers, int& open)
      : stream_(std::move(socket)), answers_(answers), open_(open) {
    ++open_;
    parser_.header_limit(kMostOfAHead);
    parser_.body_limit(kMostOfABody);
  }
  ~Call() { --open_; }
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void begin() {
    stream_.expires_after(kPatience);
    http::async_read(stream_, buffer_, parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (!error) self->answer();
                     });
  }

 private:
  void answer() {
    const auto& request = parser_.get();
    Ask ask;
    ask.method = std::string(request.method_string());
    ask.target = std::string(request.target());
    ask.languages = std::string(request[http::field::accept_language]);
    Answer given = answers_.to(ask);
    response_.version(11);
    response_.result(static_cast<unsigned>(given.status));
    if (!given.type.empty()) response_.set(http::field::content_type, given.type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Robots-Tag", "noindex, nofollow");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Content-Security-Policy",
                  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
                  "connect-src 'self'; form-action 'self'; frame-ancestors 'none'; base-uri "
                  "'none'");
    if (!given.file_name.empty())
      response_.set(http::field::content_disposition,
                    "attachment; filename=\"" + given.file_name + "\"");
    response_.keep_alive(false);
    response_.body() = std::move(given.body);
    response_.prepare_payload();
    // RFC 9110, 8.6: an answer without content has no length, and phones check that.
    if (given.status == 204) response_.erase(http::field::content_length);
    stream_.expires_after(kPatience);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](error_code error, std::size_t) {
                        if (!error)
                          self->stream_.socket().shutdown(Tcp::socket::shutdown_send, error);
                      });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{2 * kMostOfAHead};
  http::request_parser<http::string_body> parser_;
  http::response<http::string_body> response_;
  const Answers& answers_;
  int& open_;
};

}  // namespace

struct Server::Inside {
  explicit Inside(const Answers& of) : answers(of) {}
  asio::io_context context{1};
  Tcp::acceptor acceptor{context};
  asio::steady_timer timer{context};
  const Answers& answers;
  int open = 0;

  void accept() {
    acceptor.async_accept([this](error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      // Close a connection beyond the limit; the phone can ask again.
      if (!error && open < kMostAtOnce)
        std::make_shared<Call>(std::move(socket), answers, open)->begin();
      accept();
    });
  }
  void every_minute(const std::function<void()>& work) {
    work();
    timer.expires_after(std::chrono::minutes(1));
    timer.async_wait([this, &work](error_code error) {
      if (!error) every_minute(work);
    });
  }
};

Server::Server(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Server::~Server() = default;

Result<std::unique_ptr<Server>> Server::listen(const std::string& address, std::uint16_t port,
                                               const Answers& answers) {
  const std::string where = address + ':' + std::to_string(port);
  error_code error;
  const auto ip = asio::ip::make_address(address, error);
  if (error)
    return problem(where, "This is not an IP address.", "Write one such as 127.0.0.1:8080.");
  auto inside = std::make_unique<Inside>(answers);
  const Tcp::endpoint end(ip, port);
  inside->acceptor.open(end.protocol(), error);
  if (!error) inside->acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
  if (!error) inside->acceptor.bind(end, error);
  if (!error) inside->acceptor.listen(kMostAtOnce, error);
  if (error)
    return problem(where, "The server for phones cannot start: " + error.message() + ".",
                   "Name an address of this machine and a free port.", 1);
  return std::unique_ptr<Server>(new Server(std::move(inside)));
}

std::uint16_t Server::port() const { return inside_->acceptor.local_endpoint().port(); }

void Server::run(const std::function<void()>& minutely) {
  asio::signal_set signals(inside_->context, SIGINT, SIGTERM);
  signals.async_wait([this](error_code error, int) {
    if (!error) stop();
  });
  inside_->accept();
  inside_->every_minute(minutely);
  inside_->context.run();
}

void Server::stop() { inside_->context.stop(); }

}  // namespace onggi::phone
