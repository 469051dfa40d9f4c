#include "kiosk/ground/web/call.h"

#include <sys/socket.h>

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <cerrno>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

namespace onggi::web {

namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::uint32_t kMostOfAHead = 8192;
// Of a body that was refused.
constexpr std::uint64_t kMostHeardOut = 1u << 30;

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

/// All of `request` but its body and where it comes from.
template <class Request>
Ask ask_of(const Request& request) {
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
  return ask;
}

/// A browser that asks whether to go on is told so.
template <class Request>
void say_go_on(const Request& request, int socket) {
  if (!boost::beast::iequals(request[http::field::expect], "100-continue")) return;
  constexpr std::string_view kGoOn = "HTTP/1.1 100 Continue\r\n\r\n";
  // Nothing was sent before, so the socket has room for these bytes.
  static_cast<void>(::send(socket, kGoOn.data(), kGoOn.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
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
  // The limit is asked for when it is known where the body goes. "None" is taken for 0 by Boost
  // 1.74.
  parser_.body_limit(std::numeric_limits<std::uint64_t>::max());
}

Call::~Call() { closed_(); }

void Call::begin() {
  timer_.expires_after(patience_.asking);
  // The timer alone keeps no call.
  timer_.async_wait([weak = weak_from_this()](error_code error) {
    // The request may come while this waits for its turn.
    if (const auto self = weak.lock(); self && !error)
      self->in_turn_([self] {
        if (!self->receiving_ && !self->sending_) self->end();
      });
  });
  http::async_read_header(socket_, buffer_, parser_,
                          [self = shared_from_this()](error_code error, std::size_t) {
                            if (error) return self->refuse_unread(error);
                            self->in_turn_([self] { self->place_body(); });
                          });
}

void Call::place_body() {
  if (!socket_.is_open()) return;
  ask_ = ask_of(parser_.get());
  if (const auto length = parser_.content_length()) ask_.length = *length;
  // Elsewhere anybody could write any address.
  ask_.from = is_from_proxy(socket_) ? address_in(parser_.get()["X-Real-IP"]) : address_of(socket_);
  BodyPlace place = answers_.place_for_body(ask_);
  if (std::holds_alternative<IntoMemory>(place)) return read_body();
  asked_();
  if (const auto* into = std::get_if<IntoFile>(&place)) return receive(*into);
  hears_out_ = true;
  send(std::get<Answer>(std::move(place)), true);
}

void Call::read_body() {
  const std::size_t most = answers_.most_of_a_body();
  if (ask_.length.value_or(0) > most) return refuse_unread(http::error::body_limit);
  if (parser_.is_done()) return answer();
  parser_.body_limit(most);
  http::async_read(socket_, buffer_, parser_,
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (error) return self->refuse_unread(error);
                     self->in_turn_([self] { self->answer(); });
                   });
}

void Call::refuse_unread(error_code error) {
  if (error == http::error::header_limit)
    in_turn_([self = shared_from_this()] {
      self->refuse(431, "The head of this request is longer than " + std::to_string(kMostOfAHead) +
                            " bytes. Ask with fewer or shorter fields.\n");
    });
  if (error == http::error::body_limit)
    in_turn_([self = shared_from_this()] {
      self->refuse(413, "This request is longer than " +
                            std::to_string(self->answers_.most_of_a_body()) + " bytes.\n");
    });
}

void Call::receive(const IntoFile& into) {
  const auto first = buffer_.data();
  auto begun = Receiving::begin(into, ask_.length,
                                {static_cast<const std::byte*>(first.data()), first.size()});
  if (!begun) return refuse_file(begun.error());
  say_go_on(parser_.get(), socket_.native_handle());
  receiving_.emplace(std::move(*begun));
  moved_ = Clock::now();
  watch();
  receive_on();
}

void Call::receive_on() {
  if (!socket_.is_open()) return;
  const Receiving::Step step = receiving_->step(socket_.native_handle());
  if (step == Receiving::Step::broken) return end();
  if (step == Receiving::Step::failed) return refuse_file(receiving_->failure());
  came_ = receiving_->received();
  if (step == Receiving::Step::all) {
    ask_.file = receiving_->take();
    return answer();
  }
  socket_.async_wait(Socket::wait_read, [self = shared_from_this()](error_code error) {
    if (!error) self->in_turn_([self] { self->receive_on(); });
  });
}

void Call::refuse_file(const Refusal& refusal) {
  hears_out_ = true;
  Answer answer = answers_.refusal(refusal.status, refusal.why);
  receiving_.reset();
  send(std::move(answer), true);
}

void Call::end() {
  error_code ignored;
  timer_.cancel();
  socket_.close(ignored);
}

void Call::answer() {
  if (!socket_.is_open()) return;
  asked_();
  Ask ask = std::move(ask_);
  ask.body = parser_.get().body();
  Answer given = answers_.to(ask);
  // What was not taken over is removed before the browser knows the answer.
  ask.file.reset();
  // HEAD asks for the head of the answer to GET.
  send(std::move(given), ask.method != "HEAD");
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
  came_ = counted_ = 0;
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
    if (hears_out_) return hear_out();
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

/// Takes what the browser still says of a body that was refused.
void Call::hear_out() {
  if (!socket_.is_open()) return;
  char rest[Receiving::kPiece];
  const ssize_t n = ::recv(socket_.native_handle(), rest, sizeof rest, MSG_DONTWAIT);
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) return end();
  if (n > 0) came_ += static_cast<std::uint64_t>(n);
  if (came_ > kMostHeardOut) return end();
  socket_.async_wait(Socket::wait_read, [self = shared_from_this()](error_code error) {
    if (!error) self->in_turn_([self] { self->hear_out(); });
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
  // A browser that sends a byte now and then would keep all others from sending a file.
  if (came_ - counted_ >= Receiving::kPiece) {
    counted_ = came_;
    moved_ = now;
  }
  if (now - moved_ >= patience_.progress) return end();
  watch();
}

}  // namespace onggi::web
