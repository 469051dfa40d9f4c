#include "kiosk/ground/files/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "kiosk/ground/files/byte_writer.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::read_file_test {
namespace {

using namespace test;
using Fault = ReadFault::Kind;

class ReadFile : public ::testing::Test {
 protected:
  ReadFile() {
    fs::create_directories(scratch_.path() / "in" / "deep");
    std::ofstream(scratch_.path() / "secret") << "not for you";
    std::ofstream(scratch_.path() / "in" / "a b.bin") << "twelve bytes";
    std::ofstream(scratch_.path() / "in" / "deep" / "c") << "deep";
    fs::create_symlink("../secret", scratch_.path() / "in" / "link");
    fs::create_directory_symlink("..", scratch_.path() / "in" / "up");
  }
  std::string beneath(const std::string& uri) {
    const auto bytes = read_beneath(scratch_.path() / "in", uri, 100);
    return bytes ? std::string(bytes->begin(), bytes->end())
                 : "fault " + std::to_string(static_cast<int>(bytes.error().kind));
  }
  static std::string fault(Fault kind) { return "fault " + std::to_string(static_cast<int>(kind)); }
  ScratchFolder scratch_;
};

TEST_F(ReadFile, a_file_is_read_whole_up_to_the_limit_and_refused_beyond) {
  const fs::path file = scratch_.path() / "in" / "a b.bin";
  ASSERT_TRUE(read_file(file, 12));
  EXPECT_EQ(read_file(file, 12)->size(), 12u);
  const auto large = read_file(file, 11);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().kind, Fault::too_large);
  EXPECT_EQ(large.error().size, 12u);
}

TEST_F(ReadFile, what_says_that_it_is_empty_and_is_not_is_read_to_its_end) {
  const auto status = read_file("/proc/self/status", 1u << 20);
  ASSERT_TRUE(status);
  EXPECT_GT(status->size(), 100u);
  EXPECT_EQ(read_file("/proc/self/status", 20).error().kind, Fault::too_large);
}

TEST_F(ReadFile, nothing_but_a_file_is_read_and_a_pipe_is_not_waited_for) {
  EXPECT_EQ(read_file(scratch_.path() / "gone", 9).error().kind, Fault::missing);
  EXPECT_EQ(read_file(scratch_.path(), 9).error().kind, Fault::folder);
  EXPECT_EQ(read_file("/dev/zero", 9).error().kind, Fault::special);
  const fs::path pipe = scratch_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_file(pipe, 9).error().kind, Fault::special);
}

TEST_F(ReadFile, beneath_a_folder_lies_what_is_in_it_and_nothing_else) {
  EXPECT_EQ(beneath("a%20b.bin"), "twelve bytes");
  EXPECT_EQ(beneath("./deep//c"), "deep");
  for (const char* out : {"../secret", "deep/../../secret", "%2e%2e/secret", "/etc/passwd", "",
                          "https://x/y", "deep\\c", "deep/c%00"})
    EXPECT_EQ(beneath(out), fault(Fault::outside)) << out;
  EXPECT_EQ(beneath("link"), fault(Fault::link));
  EXPECT_EQ(beneath("up/secret"), fault(Fault::link));
  EXPECT_EQ(beneath("deep/gone"), fault(Fault::missing));
  EXPECT_EQ(beneath("deep"), fault(Fault::folder));
}

TEST_F(ReadFile, where_a_file_lies_beneath_a_folder_is_told_by_the_same_rules) {
  const std::filesystem::path in = scratch_.path() / "in";
  const auto deep = find_beneath(in, "./deep//c");
  ASSERT_TRUE(deep);
  EXPECT_EQ(*deep, in / "deep" / "c");
  EXPECT_EQ(read_file(*deep, 100)->size(), 4u);
  EXPECT_EQ(*find_beneath(in, "a%20b.bin"), in / "a b.bin");
  ASSERT_EQ(mkfifo((in / "pipe").c_str(), 0600), 0);
  const std::pair<const char*, Fault> not_there[] = {{"../secret", Fault::outside},
                                                     {"up/secret", Fault::link},
                                                     {"deep", Fault::folder},
                                                     {"pipe", Fault::special}};
  for (const auto& [name, kind] : not_there) {
    const auto found = find_beneath(in, name);
    ASSERT_FALSE(found) << name;
    EXPECT_EQ(found.error().kind, kind) << name;
  }
}

TEST(ByteWriter, the_lowest_byte_of_a_number_comes_first_and_padding_fills_to_a_whole_step) {
  ByteWriter out;
  out.u16(0x0201);
  out.u32(0x06050403);
  out.f32(1.0f);
  out.text("hi");
  out.pad(16, ' ');
  out.pad(16, ' ');
  const std::string expected = std::string("\x01\x02\x03\x04\x05\x06\0\0\x80\x3fhi    ", 16);
  const auto bytes = out.take();
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), expected);
}

}  // namespace
}  // namespace onggi::files::read_file_test
