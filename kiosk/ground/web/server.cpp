#include "kiosk/ground/web/server.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <algorithm>
#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "kiosk/ground/web/connection_shares.h"
#include "kiosk/ground/web/descriptor_limit.h"
#include "kiosk/ground/web/turns.h"

namespace onggi::web {

namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using Local = asio::local::stream_protocol;
using Acceptor = asio::basic_socket_acceptor<asio::generic::stream_protocol>;
namespace fs = std::filesystem;

// Descriptors for all but connections and their files.
constexpr std::size_t kOwnDescriptors = 16;
// Before another try where the system has no connection to give.
constexpr std::chrono::milliseconds kBreath{100};
// Connections that are taken without a piece of work between them.
constexpr int kTakenAtOnce = 256;

/// Connections at once, each with a file.
std::size_t most_at_once(std::size_t wanted) {
  const std::size_t limit = descriptor_limit(2 * wanted + kOwnDescriptors);
  return std::clamp<std::size_t>((limit - std::min(limit, kOwnDescriptors)) / 2, 1, wanted);
}

/// Makes room for a Unix socket: one that was left by a program that ended is removed.
Result<void> clear(const fs::path& file) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(file, error).type();
  if (type == fs::file_type::not_found) return {};
  asio::io_context context;
  Local::socket socket(context);
  error_code refused;
  if (type == fs::file_type::socket) socket.connect(Local::endpoint(file.string()), refused);
  if (type != fs::file_type::socket || !refused)
    return problem(file.string(),
                   refused || type != fs::file_type::socket ? "Another file has this name."
                                                            : "Another program listens here.",
                   "End that program, or name another file.", 1);
  fs::remove(file, error);
  if (error)
    return problem(file.string(), "This old socket cannot be removed: " + error.message() + ".",
                   "Remove it.", 1);
  return {};
}

}  // namespace

Result<Listening> listening(const std::string& text) {
  constexpr std::string_view kUnix = "unix:";
  Listening found;
  if (text.starts_with(kUnix)) {
    found.file = text.substr(kUnix.size());
    // The system's limit, with the zero behind it.
    if (found.file.is_absolute() && found.file.string().size() < sizeof sockaddr_un{}.sun_path)
      return found;
    return problem("--listen " + text, "This is not the path of a socket, of at most 107 letters.",
                   "Write one such as unix:/run/onggi-console/page.sock.");
  }
  const auto colon = text.rfind(':');
  const std::string port = colon == std::string::npos ? "" : text.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), found.port);
  if (port.empty() || error != std::errc() || end != port.data() + port.size())
    return problem("--listen " + text, "This is not an address with a port.",
                   "Write one such as 127.0.0.1:8080 or [::1]:8080.");
  found.address = text.substr(0, colon);
  if (found.address.starts_with('[') && found.address.ends_with(']'))
    found.address = found.address.substr(1, found.address.size() - 2);
  return found;
}

struct Server::Inside {
  Inside(Answering& of, const Limits& limits)
      : answers(of), patience(limits.patience), shares(most_at_once(limits.connections)) {}
  Answering& answers;
  Patience patience;
  ConnectionShares shares;
  std::unordered_map<ConnectionShares::Number, std::weak_ptr<Call>> calls;
  // After what its calls use: they go with it.
  asio::io_context context{1};
  Acceptor acceptor{context};
  fs::path file;  // of a Unix socket
  asio::steady_timer timer{context}, breath{context};
  Turns turns;  // its work holds calls, which go before the context
  bool taking_turns = false;

  void accept() {
    acceptor.async_accept([this](error_code error, Socket socket) {
      if (error == asio::error::operation_aborted) return;
      // Those who came meanwhile too: else the last one waits for the work of all before it.
      for (int n = 1; !error; ++n) {
        take(std::move(socket));
        if (n == kTakenAtOnce) return accept();
        socket = acceptor.accept(error);
      }
      if (error == asio::error::would_block) return accept();
      // Somebody who has gone already, or no descriptor left: to ask at once would be to ask
      // without an end.
      breath.expires_after(kBreath);
      breath.async_wait([this](error_code stopped) {
        if (!stopped) accept();
      });
    });
  }
  void take(Socket socket) {
    const std::string address = address_of(socket);
    const ConnectionShares::Entry entry = shares.enter(address);
    if (const auto out = calls.find(entry.out); out != calls.end())
      if (const auto call = out->second.lock()) call->end();
    // A refused phone can ask again.
    if (entry.in == 0) return;
    const auto number = entry.in;
    const auto call = std::make_shared<Call>(
        std::move(socket), answers, patience,
        [this, address](Call::Work work) { in_turn(address, std::move(work)); },
        [this, number] { shares.asked(number); },
        [this, number] {
          shares.leave(number);
          calls.erase(number);
        });
    calls.emplace(number, call);
    call->begin();
  }
  void in_turn(const std::string& address, Call::Work work) {
    turns.add(address, std::move(work));
    if (!std::exchange(taking_turns, true)) asio::post(context, [this] { take_turns(); });
  }
  void take_turns() {
    turns.next();
    taking_turns = !turns.empty();
    if (taking_turns) asio::post(context, [this] { take_turns(); });
  }
  void every_minute(const std::function<bool()>& work) {
    tidying(work);
    timer.expires_after(std::chrono::minutes(1));
    timer.async_wait([this, &work](error_code error) {
      if (!error) every_minute(work);
    });
  }
  void tidying(const std::function<bool()>& work) {
    if (at_work) return;
    at_work = true;
    turn(work);
  }
  void turn(const std::function<bool()>& work) {
    at_work = work();
    if (at_work) asio::post(context, [this, &work] { turn(work); });
  }
  bool at_work = false;
};

Server::Server(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Server::~Server() {
  std::error_code ignored;
  if (!inside_->file.empty()) fs::remove(inside_->file, ignored);
}

Result<std::unique_ptr<Server>> Server::listen(const std::string& address, std::uint16_t port,
                                               Answering& answers, const Limits& limits) {
  const bool v6 = address.find(':') != std::string::npos;
  const std::string where = (v6 ? '[' + address + ']' : address) + ':' + std::to_string(port);
  error_code error;
  const auto ip = asio::ip::make_address(address, error);
  if (error)
    return problem(where, "This is not an IP address.",
                   "Write one such as 127.0.0.1:8080 or [::1]:8080.");
  auto inside = std::make_unique<Inside>(answers, limits);
  const Tcp::endpoint end(ip, port);
  inside->acceptor.open(end.protocol(), error);
  if (!error) inside->acceptor.set_option(Acceptor::reuse_address(true), error);
  if (!error) inside->acceptor.bind(end, error);
  if (!error) inside->acceptor.non_blocking(true, error);
  if (!error) inside->acceptor.listen(Acceptor::max_listen_connections, error);
  if (error)
    return problem(where, "The server cannot start: " + error.message() + ".",
                   "Name an address of this machine and a free port.", 1);
  return std::unique_ptr<Server>(new Server(std::move(inside)));
}

Result<std::unique_ptr<Server>> Server::listen(const fs::path& file, Answering& answers,
                                               const Limits& limits) {
  if (auto clean = clear(file); !clean) return tl::unexpected(clean.error());
  auto inside = std::make_unique<Inside>(answers, limits);
  const Local::endpoint end(file.string());
  error_code error;
  inside->acceptor.open(end.protocol(), error);
  // Nobody connects before it listens, when its rights are these.
  if (!error) inside->acceptor.bind(end, error);
  if (!error && ::chmod(file.c_str(), 0660) != 0)
    error = error_code(errno, boost::system::system_category());
  if (!error) inside->acceptor.non_blocking(true, error);
  if (!error) inside->acceptor.listen(Acceptor::max_listen_connections, error);
  if (error)
    return problem(file.string(), "The server cannot start: " + error.message() + ".",
                   "Name a file in a folder where this program's user may write.", 1);
  inside->file = file;
  return std::unique_ptr<Server>(new Server(std::move(inside)));
}

std::uint16_t Server::port() const {
  const auto end = inside_->acceptor.local_endpoint();
  Tcp::endpoint tcp;
  if (end.data()->sa_family == AF_UNIX || end.size() > tcp.capacity()) return 0;
  std::memcpy(tcp.data(), end.data(), end.size());
  return tcp.port();
}

void Server::run(const std::function<bool()>& look_after) {
  asio::signal_set signals(inside_->context, SIGINT, SIGTERM);
  signals.async_wait([this](error_code error, int) {
    if (!error) stop();
  });
  // sendfile() to a phone that has gone raises it.
  std::signal(SIGPIPE, SIG_IGN);
  inside_->accept();
  inside_->every_minute(look_after);
  inside_->context.run();
}

void Server::stop() { inside_->context.stop(); }

}  // namespace onggi::web
