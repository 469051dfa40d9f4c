#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "kiosk/ground/web/message.h"
#include "kiosk/ground/web/receiving.h"
#include "kiosk/ground/web/sending.h"

namespace onggi::web {

/// How long a browser is waited for.
struct Patience {
  std::chrono::milliseconds asking{5000};     ///< From the connection to the whole request, or to
                                              ///< the head of one whose body goes into a file.
  std::chrono::milliseconds progress{10000};  ///< Without a byte that arrives; also what a download
                                              ///< has left when its keepsake is deleted. Of a body
                                              ///< that goes into a file: without a piece of it.
};

/// A connection over TCP or a Unix socket.
using Socket = boost::asio::generic::stream_protocol::socket;

/// The address at the other end, an IPv4 one written as such; "" if it is gone, or at a Unix
/// socket.
std::string address_of(const Socket& socket);
/// True for a connection over a Unix socket, which only a proxy of this machine may open.
bool is_from_proxy(const Socket& socket);

/// One connection: a request of at most 8 KiB head and Answering::most_of_a_body(), and its answer;
/// a longer head or body is told so, and anything else that is no request is closed without a word.
/// A body may go into a file instead (Answering::place_for_body). Where that is refused, at most
/// 1 GiB more is taken from the browser and forgotten, because browsers look at the answer last.
/// Closes itself. Held alive by what it waits for. One thread.
class Call : public std::enable_shared_from_this<Call> {
 public:
  using Work = std::function<void()>;
  /// `in_turn` is given each piece of work, and does it when it is this phone's turn. `asked` is
  /// called when the request is whole, `closed` when the call goes.
  Call(Socket socket, Answering& answers, const Patience& patience,
       std::function<void(Work)> in_turn, Work asked, Work closed);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  void begin();
  /// Closes the connection now.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void place_body();
  void read_body();
  void refuse_unread(boost::system::error_code error);
  void receive(const IntoFile& into);
  void receive_on();
  void refuse_file(const Refusal& refusal);
  void hear_out();
  void answer();
  void refuse(int status, const std::string& what);
  void send(Answer given, bool content);
  void send_on();
  void watch();
  void end_if_nothing_moves();

  Socket socket_;
  boost::asio::steady_timer timer_;
  boost::beast::flat_buffer buffer_;
  boost::beast::http::request_parser<boost::beast::http::string_body> parser_;
  Answering& answers_;
  Patience patience_;
  std::function<void(Work)> in_turn_;
  Work asked_, closed_;
  Ask ask_;
  std::optional<Receiving> receiving_;
  std::optional<Sending> sending_;
  Clock::time_point moved_{};             // when a byte was last given or confirmed, or a
                                          // piece came
  std::size_t unconfirmed_ = 0;           // as of then
  std::uint64_t came_ = 0, counted_ = 0;  // bytes of the body, or of what is heard out; as of then
  bool hears_out_ = false;                // the rest of the body, when the answer is given
  std::optional<Clock::time_point> deleted_{};  // when the file was first seen to be deleted
};

}  // namespace onggi::web
