#include "kiosk/ground/web/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

#include "kiosk/ground/files/descriptor.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::web::server_test {
namespace {

using files::test::ScratchFolder;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Says from where somebody asks.
class Echo final : public Answering {
 public:
  Answer to(const Ask& ask) override {
    return {.status = 200, .type = "text/plain", .body = "from <" + ask.from + ">"};
  }
};

std::string hear(const fs::path& file, const std::string& words) {
  const files::Descriptor link(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_un at{};
  at.sun_family = AF_UNIX;
  std::ranges::copy(file.string(), at.sun_path);
  if (::connect(link.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0) return "away";
  std::string heard;
  if (::write(link.get(), words.data(), words.size()) < 0) return "broken";
  char piece[4096];
  for (ssize_t n = 0; (n = ::read(link.get(), piece, sizeof piece)) > 0;)
    heard.append(piece, static_cast<std::size_t>(n));
  return heard;
}

TEST(UnixSocket, AnswersAProxyAndTakesItsWordForWhoAsks) {
  const ScratchFolder scratch;
  const fs::path file = scratch / "page.sock";
  Echo echo;
  {
    auto server = Server::listen(file, echo, {});
    ASSERT_TRUE(server) << to_text(server.error());
    EXPECT_EQ((*server)->port(), 0);
    struct stat info {};
    ASSERT_EQ(::stat(file.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 07777, 0660u);
    std::thread runs([&] { (*server)->run([] { return false; }); });
    const std::string head = "GET / HTTP/1.1\r\nHost: x\r\n";
    EXPECT_THAT(hear(file, head + "\r\n"), HasSubstr("from <>"));
    EXPECT_THAT(hear(file, head + "X-Real-IP: 192.168.1.7\r\n\r\n"), HasSubstr("<192.168.1.7>"));
    EXPECT_THAT(hear(file, head + "X-Real-IP: a\"b\r\n\r\n"), HasSubstr("from <>"));
    EXPECT_THAT(hear(file, "POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 4294967296\r\n\r\n"),
                HasSubstr("413"));
    // Another program does not take its place.
    const auto second = Server::listen(file, echo, {});
    EXPECT_THAT(second ? "" : to_text(second.error()), HasSubstr("Another program listens here"));
    (*server)->stop();
    runs.join();
  }
  EXPECT_FALSE(fs::exists(file)) << "it goes with its server";
}

TEST(UnixSocket, ReplacesWhatADeadProgramLeftAndNothingElse) {
  const ScratchFolder scratch;
  const fs::path file = scratch / "page.sock", other = scratch / "other";
  {
    const files::Descriptor left(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
    sockaddr_un at{};
    at.sun_family = AF_UNIX;
    std::ranges::copy(file.string(), at.sun_path);
    ASSERT_EQ(::bind(left.get(), reinterpret_cast<const sockaddr*>(&at), sizeof at), 0);
  }
  Echo echo;
  EXPECT_TRUE(Server::listen(file, echo, {}));
  std::ofstream(other) << "the museum's";
  const auto refused = Server::listen(other, echo, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(to_text(refused.error()), HasSubstr("Another file has this name"));
  EXPECT_EQ(files::test::content(other), "the museum's");
  EXPECT_FALSE(Server::listen(scratch / "no/page.sock", echo, {}));
}

TEST(Listening, IsAnAddressWithAPortOrAUnixSocket) {
  const auto socket = listening("unix:/run/onggi-console/page.sock");
  ASSERT_TRUE(socket);
  EXPECT_EQ(socket->file, "/run/onggi-console/page.sock");
  EXPECT_EQ(socket->address, "");
  for (const std::string& wrong :
       {std::string("unix:"), std::string("unix:page.sock"), "unix:/" + std::string(107, 'x')})
    EXPECT_FALSE(listening(wrong)) << wrong;
}

}  // namespace
}  // namespace onggi::web::server_test
