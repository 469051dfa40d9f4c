#include "kiosk/ground/files/child_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>

#include "kiosk/ground/files/helper_process.h"
#include "kiosk/ground/files/read_file.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::child_process_test {
namespace {

using namespace test;
using ::testing::HasSubstr;

std::string text_of(const Result<std::vector<std::byte>>& bytes) {
  if (!bytes) return to_text(bytes.error());
  return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
}

TEST(helper_process, its_arguments_arrive_as_they_are_whatever_a_shell_would_make_of_them) {
  const std::string odd = "a b; $HOME 'c' \"d\" *";
  EXPECT_EQ(text_of(run_helper({.program = "printf", .arguments = {"%s|%s", odd, ""}})), odd + "|");
}

// As one among many on a busy machine: a little work, a long wait for the next turn.
TEST(helper_process, one_that_gets_on_slowly_is_waited_for) {
  const std::string slow =
      "for i in $(seq 30); do for j in $(seq 1500); do :; done; sleep 0.1; done; echo done";
  // On a busy machine a turn may be a second away.
  EXPECT_EQ(text_of(run_helper({.program = "bash", .arguments = {"-c", slow}, .timeout_s = 2.0})),
            "done\n");
}

TEST(helper_process, one_that_stands_still_or_works_without_end_is_stopped) {
  for (const char* words : {"sleep 60", "while :; do :; done"}) {
    const auto begun = std::chrono::steady_clock::now();
    const auto out = run_helper({.program = "bash", .arguments = {"-c", words}, .timeout_s = 0.5});
    EXPECT_THAT(text_of(out), HasSubstr("was stopped")) << words;
    EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(30)) << words;
  }
}

TEST(helper_process, what_it_is_given_comes_back_from_cat_head_first) {
  const std::vector<std::uint8_t> body(300'000, 'x');
  const auto out =
      run_helper({.program = "cat", .head = "head\n", .body = body, .most_bytes = 1u << 20});
  EXPECT_EQ(text_of(out), "head\n" + std::string(body.size(), 'x'));
}

TEST(helper_process, a_name_that_is_nowhere_in_the_path_is_told) {
  const auto out = run_helper({.program = "onggi-no-such-program"});
  ASSERT_FALSE(out);
  EXPECT_EQ(out.error().exit_code, 1);
  EXPECT_THAT(out.error().what, HasSubstr("No such file"));
}

TEST(child_process, it_ends_with_the_object_that_stands_for_it) {
  {
    const auto child = ChildProcess::start("sleep", {"60"}, {});
    ASSERT_TRUE(child) << std::strerror(child.error());
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), 0) << "it ended by itself";
  }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  EXPECT_EQ(errno, ECHILD);
}

TEST(child_process, a_stream_that_leads_nowhere_is_empty_and_takes_everything) {
  auto child = ChildProcess::start("sh", {"-c", "echo out; echo err >&2; test -z \"$(cat)\""}, {});
  ASSERT_TRUE(child) << std::strerror(child.error());
  ASSERT_TRUE(child->wait_until(ChildProcess::Clock::now() + std::chrono::seconds(20)));
  EXPECT_EQ(child->status(), 0);
}

TEST(virtual_display, where_there_is_a_display_none_is_started) {
  const int status = in_child([] {
    ::setenv("DISPLAY", ":77", 1);
    const auto display = VirtualDisplay::ensure(320, 240);
    return display && *display == nullptr && std::string(::getenv("DISPLAY")) == ":77";
  });
  EXPECT_EQ(status, 0);
}

TEST(virtual_display, where_there_is_no_xvfb_the_remedy_is_told) {
  const int status = in_child([] {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    ::setenv("PATH", "/nowhere", 1);
    const auto display = VirtualDisplay::ensure(320, 240);
    return !display && display.error().exit_code == 1 &&
           display.error().remedy.find("xvfb") != std::string::npos;
  });
  EXPECT_EQ(status, 0);
}

/// Is there an X server of this many pixels, which are nobody else's?
bool server_is_there() {
  std::error_code error;
  for (const auto& process : fs::directory_iterator("/proc", error)) {
    const auto line = read_file(process.path() / "cmdline", 1u << 16);
    if (!line) continue;
    const std::string words(line->begin(), line->end());
    if (words.starts_with("Xvfb") && words.find("333x222x24") != std::string::npos) return true;
  }
  return false;
}

TEST(virtual_display, the_server_ends_with_the_program_even_where_that_is_killed) {
  const ScratchFolder scratch;
  const pid_t program = ::fork();
  if (program == 0) {
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
    const auto display = VirtualDisplay::ensure(333, 222);
    if (!display) ::_exit(1);
    ::kill(::getpid(), SIGSTOP);  // "it is there"
    ::pause();
  }
  int status = 0;
  ASSERT_EQ(::waitpid(program, &status, WUNTRACED), program);
  ASSERT_TRUE(WIFSTOPPED(status)) << "no server could be started";
  EXPECT_TRUE(server_is_there());
  ::kill(program, SIGKILL);
  ASSERT_EQ(::waitpid(program, &status, 0), program);
  for (int tenth = 0; tenth < 100 && server_is_there(); ++tenth) ::usleep(100'000);
  EXPECT_FALSE(server_is_there());
}

TEST(child_process, one_that_does_not_mind_a_signal_is_killed_when_patience_ends) {
  Channel said;
  ASSERT_TRUE(said.open_for_reading());
  auto deaf = ChildProcess::start("sh", {"-c", "trap '' TERM; echo; while :; do sleep 0.05; done"},
                                  {.out = said.theirs.get()});
  ASSERT_TRUE(deaf);
  said.theirs.close();
  pollfd waiting{said.ours.get(), POLLIN, 0};
  ASSERT_EQ(::poll(&waiting, 1, 10'000), 1) << "it has set its trap";
  deaf->end(SIGTERM, 0.2);
  EXPECT_TRUE(WIFSIGNALED(deaf->status()));
  EXPECT_EQ(WTERMSIG(deaf->status()), SIGKILL);
}

}  // namespace
}  // namespace onggi::files::child_process_test
