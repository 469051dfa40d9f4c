#include "kiosk/ground/web/call.h"

#include <sys/socket.h>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>

namespace onggi::web {

namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::uint32_t kMostOfAHead = 8192;

std::string quoted(const std::string& text) { return '"' + text + '"'; }

/// The head of `given`, as it is sent.
std::string head_of(const Answer& given) {
  http::response<http::empty_body> head;
  head.version(11);
  head.result(static_cast<unsigned>(given.status));
  if (!given.type.empty()) head.set(http::field::content_type, given.type);
  head.set(http::field::cache_control, "no-store");
  head.set("X-Robots-Tag", "noindex, nofollow");
  head.set("X-Content-Type-Options", "nosniff");
  head.set("Referrer-Policy", "no-referrer");
  head.set("Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
           "connect-src 'self'; form-action 'self'; frame-ancestors 'none'; base-uri "
           "'none'");
  if (!given.file_name.empty())
    head.set(http::field::content_disposition, "attachment; filename=" + quoted(given.file_name));
  if (given.file) {
    const std::string of = '/' + std::to_string(given.file->size);
    head.set(http::field::accept_ranges, "bytes");
    head.set(http::field::etag, quoted(given.file->tag));
    if (given.status == 206)
      head.set(http::field::content_range,
               "bytes " + std::to_string(given.span.from) + '-' +
                   std::to_string(given.span.from + given.span.length - 1) + of);
    if (given.status == 416) head.set(http::field::content_range, "bytes *" + of);
  }
  for (const auto& [name, value] : given.fields) head.set(name, value);
  head.keep_alive(false);
  // RFC 9110, 8.6: an answer without content has no length, and phones check that.
  if (given.status != 204 && given.status != 304)
    head.content_length(given.body.size() + given.span.length);
  std::ostringstream text;
  text << head;
  return std::move(text).str();
}

/// `text` if it is an IP address; else "".
template <class Text>
std::string address_in(const Text& text) {
  error_code error;
  const auto address = asio::ip::make_address(std::string(text), error);
  return error ? "" : address.to_string();
}

}  // namespace

std::string address_of(const Socket& socket) {
  error_code error;
  const Socket::endpoint_type other = socket.remote_endpoint(error);
  const int family = other.data()->sa_family;
  Tcp::endpoint end;
  if (error || (family != AF_INET && family != AF_INET6) || other.size() > end.capacity())
    return {};
  std::memcpy(end.data(), other.data(), other.size());
  const asio::ip::address address = end.address();
  if (address.is_v6() && address.to_v6().is_v4_mapped())
    return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string();
  return address.to_string();
}

bool is_from_proxy(const Socket& socket) {
  error_code error;
  const Socket::endpoint_type own = socket.local_endpoint(error);
  return !error && own.data()->sa_family == AF_UNIX;
}

Call::Call(Socket socket, Answering& answers, const Patience& patience,
           std::function<void(Work)> in_turn, Work asked, Work closed)
    : socket_(std::move(socket)),
      timer_(socket_.get_executor()),
      buffer_(2 * kMostOfAHead),
      answers_(answers),
      patience_(patience),
      in_turn_(std::move(in_turn)),
      asked_(std::move(asked)),
      closed_(std::move(closed)) {
  parser_.header_limit(kMostOfAHead);
  parser_.body_limit(answers_.most_of_a_body());
}

Call::~Call() { closed_(); }

void Call::begin() {
  timer_.expires_after(patience_.asking);
  // The timer alone keeps no call.
  timer_.async_wait([weak = weak_from_this()](error_code error) {
    // The request may come while this waits for its turn.
    if (const auto self = weak.lock(); self && !error)
      self->in_turn_([self] {
        if (!self->sending_) self->end();
      });
  });
  http::async_read(
      socket_, buffer_, parser_, [self = shared_from_this()](error_code error, std::size_t) {
        if (!error) self->in_turn_([self] { self->answer(); });
        if (error == http::error::header_limit)
          self->in_turn_([self] {
            self->refuse(431, "The head of this request is longer than " +
                                  std::to_string(kMostOfAHead) +
                                  " bytes. Ask with fewer or shorter fields.\n");
          });
        if (error == http::error::body_limit)
          self->in_turn_([self] {
            self->refuse(413, "This request is longer than " +
                                  std::to_string(self->answers_.most_of_a_body()) + " bytes.\n");
          });
      });
}

void Call::end() {
  error_code ignored;
  timer_.cancel();
  socket_.close(ignored);
}

void Call::answer() {
  if (!socket_.is_open()) return;
  asked_();
  const auto& request = parser_.get();
  Ask ask;
  ask.method = std::string(request.method_string());
  ask.target = std::string(request.target());
  ask.languages = std::string(request[http::field::accept_language]);
  ask.range = std::string(request[http::field::range]);
  ask.if_range = std::string(request[http::field::if_range]);
  ask.host = std::string(request[http::field::host]);
  ask.origin = std::string(request[http::field::origin]);
  ask.cookie = std::string(request[http::field::cookie]);
  ask.type = std::string(request[http::field::content_type]);
  ask.if_none_match = std::string(request[http::field::if_none_match]);
  ask.body = request.body();
  // Elsewhere anybody could write any address.
  ask.from = is_from_proxy(socket_) ? address_in(request["X-Real-IP"]) : address_of(socket_);
  // HEAD asks for the head of the answer to GET.
  send(answers_.to(ask), ask.method != "HEAD");
}

void Call::refuse(int status, const std::string& what) {
  if (!socket_.is_open()) return;
  send({.status = status, .type = "text/plain; charset=utf-8", .body = what}, true);
}

void Call::send(Answer given, bool content) {
  std::string text = head_of(given);
  if (content) text += given.body;
  SentFile file;
  if (given.file) file = std::move(*given.file);
  sending_.emplace(std::move(text), std::move(file), content ? given.span : Span{});
  error_code error;
  socket_.native_non_blocking(true, error);
  keep_small(socket_.native_handle());
  moved_ = Clock::now();
  watch();
  send_on();
}

void Call::send_on() {
  if (!socket_.is_open()) return;
  const int socket = socket_.native_handle();
  const std::uint64_t before = sending_->given();
  const Sending::Step step = sending_->step(socket);
  if (step == Sending::Step::broken) return end();
  if (step == Sending::Step::all) {
    error_code ignored;
    socket_.shutdown(Socket::shutdown_send, ignored);
    // What a phone said beyond its request is taken: a connection that is closed with words unread
    // tells the phone to forget what is still on its way. One that goes on talking is not heard
    // out, because all others wait meanwhile.
    char rest[1024];
    for (int n = 0; n < 64 && ::recv(socket, rest, sizeof rest, MSG_DONTWAIT) > 0; ++n) {
    }
    return end();
  }
  if (sending_->given() != before) {
    moved_ = Clock::now();
    unconfirmed_ = unconfirmed(socket).value_or(0);
    if (!deleted_ && sending_->deleted()) deleted_ = moved_;
  }
  if (deleted_ && Clock::now() - *deleted_ > patience_.progress) return end();
  socket_.async_wait(Socket::wait_write, [self = shared_from_this()](error_code error) {
    if (!error) self->in_turn_([self] { self->send_on(); });
  });
}

void Call::watch() {
  timer_.expires_at(moved_ + patience_.progress);
  timer_.async_wait([weak = weak_from_this()](error_code error) {
    if (const auto self = weak.lock(); self && !error)
      self->in_turn_([self] { self->end_if_nothing_moves(); });
  });
}

void Call::end_if_nothing_moves() {
  if (!socket_.is_open()) return;
  // The socket may be full while what is in it still arrives, slowly.
  const auto now = Clock::now();
  const std::size_t left = unconfirmed(socket_.native_handle()).value_or(0);
  if (left < unconfirmed_) {
    unconfirmed_ = left;
    moved_ = now;
  }
  if (now - moved_ >= patience_.progress) return end();
  watch();
}

}  // namespace onggi::web
