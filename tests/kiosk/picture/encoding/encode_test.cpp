#include "kiosk/picture/encoding/encode.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/picture/encoding/picture_bytes.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::encoding::encode_test {
namespace {

using namespace files::test;
using ::testing::HasSubstr;

const Caption kCaption{"나의 답: 달항아리", "Museum of Jars, ©", "Joseon, 18th century"};

view::Image picture(int width, int height, std::uint8_t alpha = 255) {
  view::Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.rgba.insert(image.rgba.end(),
                        {static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 5),
                         static_cast<std::uint8_t>((x + y) * 3), alpha});
    }
  }
  return image;
}

fs::path helper() { return fs::read_symlink("/proc/self/exe").parent_path() / "onggi-encode"; }

/// What OpenImageIO, started anew, reads from a file with `bytes`.
nlohmann::json read_back(const std::vector<std::byte>& bytes, const char* name) {
  const ScratchFolder scratch;
  const fs::path file = scratch.path() / name;
  EXPECT_TRUE(files::write_durably(file, bytes));
  FILE* const pipe = ::popen((helper().string() + " --describe " + file.string()).c_str(), "r");
  std::string text;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  EXPECT_EQ(::pclose(pipe), 0);
  return nlohmann::json::parse(text, nullptr, false);
}

/// The chunks of a PNG by name, each with its data; checks nothing.
std::multimap<std::string, std::string> chunks(const std::vector<std::byte>& png) {
  std::multimap<std::string, std::string> found;
  const std::string all(reinterpret_cast<const char*>(png.data()), png.size());
  for (std::size_t at = 8; at + 12 <= all.size();) {
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k)
      length = length << 8 | static_cast<unsigned char>(all[at + k]);
    found.emplace(all.substr(at + 4, 4), all.substr(at + 8, length));
    at += 12 + length;
  }
  return found;
}

TEST(encode, a_png_comes_back_pixel_for_pixel_and_tells_its_words_in_utf_8) {
  const view::Image image = picture(60, 84);
  const auto png = encode(image, Format::png, kCaption);
  ASSERT_TRUE(png) << to_text(png.error());
  const auto read = read_back(*png, "postcard.png");
  EXPECT_EQ(read["width"], 60);
  EXPECT_EQ(read["height"], 84);
  EXPECT_EQ(read["channels"], 3);
  for (std::size_t i = 0; i < 20; ++i) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(read["first"][3 * i + k], image.rgba[4 * i + k]);
  }
  const auto found = chunks(*png);
  EXPECT_EQ(found.count("sRGB"), 1u);
  const auto texts = [&](const char* chunk) {
    std::vector<std::string> all;
    for (auto [at, end] = found.equal_range(chunk); at != end; ++at) all.push_back(at->second);
    return all;
  };
  const std::string one("\0", 1), five(5, '\0');
  EXPECT_THAT(texts("iTXt"), ::testing::ElementsAre("Title" + five + kCaption.title,
                                                    "Copyright" + five + kCaption.copyright));
  EXPECT_THAT(texts("tEXt"), ::testing::IsSupersetOf<::testing::Matcher<std::string>>(
                                 {::testing::StrEq("Description" + one + kCaption.description),
                                  ::testing::StartsWith("Software" + one + "Onggi 0.")}));
  EXPECT_EQ(read["metadata"].value("DocumentName", ""), kCaption.title)
      << "checksums are right, too";
  EXPECT_THAT(read["metadata"].dump(), HasSubstr("Onggi 0."));
}

TEST(encode, a_jpeg_carries_title_copyright_and_software) {
  const auto jpeg = encode(picture(60, 84), Format::jpeg, kCaption);
  ASSERT_TRUE(jpeg) << to_text(jpeg.error());
  const auto read = read_back(*jpeg, "postcard.jpg");
  EXPECT_EQ(read["format"], "jpeg");
  EXPECT_EQ(read["width"], 60);
  const auto& metadata = read["metadata"];
  EXPECT_THAT(metadata.value("ImageDescription", ""), HasSubstr(kCaption.title));
  EXPECT_EQ(metadata.value("Copyright", ""), kCaption.copyright);
  EXPECT_THAT(metadata.value("Software", ""), HasSubstr("Onggi 0."));
  EXPECT_EQ(metadata.value("oiio:ColorSpace", ""), "sRGB");
}

TEST(encode, see_through_pixels_stay_so_in_png_and_lie_on_white_in_jpeg) {
  const view::Image image = picture(32, 32, 0);
  const auto png = encode(image, Format::png, {});
  const auto jpeg = encode(image, Format::jpeg, {});
  ASSERT_TRUE(png) << to_text(png.error());
  ASSERT_TRUE(jpeg) << to_text(jpeg.error());
  EXPECT_EQ(read_back(*png, "a.png")["channels"], 4);
  const auto read = read_back(*jpeg, "a.jpg");
  for (const auto& value : read["first"]) EXPECT_GE(value.get<int>(), 254);
}

TEST(encode, half_see_through_pixels_keep_their_own_colour_in_png) {
  view::Image image{16, 16, {}};
  for (int i = 0; i < 256; ++i) image.rgba.insert(image.rgba.end(), {200, 100, 50, 128});
  const auto png = encode(image, Format::png, {});
  ASSERT_TRUE(png);
  const auto first = read_back(*png, "a.png")["first"];
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(first[k], image.rgba[k]);
}

TEST(encode, the_same_picture_gives_the_same_bytes) {
  const view::Image image = picture(100, 140);
  for (const Format format : {Format::png, Format::jpeg}) {
    EXPECT_EQ(*encode(image, format, kCaption), *encode(image, format, kCaption));
  }
}

TEST(encode, broken_letters_in_a_caption_cost_the_letter_and_not_the_picture) {
  EXPECT_TRUE(
      encode(picture(8, 8), Format::png, {"\xff\xfe\xec\x95", "\n\0x", std::string(9999, 'x')}));
  EXPECT_TRUE(encode(picture(8, 8), Format::jpeg,
                     {std::string(9999, 't'), "\xff\xfe", std::string(70000, 'x')}));
}

TEST(encode, a_picture_that_is_none_is_refused) {
  for (const view::Image& image : {view::Image{}, view::Image{10, 10, {1, 2, 3}},
                                   view::Image{-1, 4, {}}, view::Image{1 << 20, 1, {}}}) {
    const auto encoded = encode(image, Format::png, {});
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().exit_code, 1);
  }
}

/// What a GIF is made of, read by ourselves (GIF89a, appendix A): its pictures' times in hundredths
/// of a second, how often all are shown (0: without end), its comments.
struct GifParts {
  std::vector<int> times;
  std::optional<int> times_shown;
  std::string comments;
  std::size_t pictures = 0;
};
GifParts parts_of(const std::vector<std::byte>& gif) {
  GifParts parts;
  const auto at = [&](std::size_t i) { return std::to_integer<std::size_t>(gif.at(i)); };
  const auto table = [&](std::size_t i) {
    return (at(i) & 0x80u) != 0 ? 3u << ((at(i) & 7u) + 1) : 0u;
  };
  std::size_t i = 13 + table(10);
  while (at(i) != 0x3b) {
    std::size_t kind = 0;
    if (at(i) == 0x21) {
      kind = at(i + 1);
      if (kind == 0xf9) parts.times.push_back(static_cast<int>(at(i + 4) + 256 * at(i + 5)));
      if (kind == 0xff) parts.times_shown = static_cast<int>(at(i + 16) + 256 * at(i + 17));
      i += 2;
    } else {
      EXPECT_EQ(at(i), 0x2cu);
      ++parts.pictures;
      i += 11 + table(i + 9);
    }
    for (; at(i) != 0; i += at(i) + 1)
      if (kind == 0xfe)
        for (std::size_t k = 1; k <= at(i); ++k)
          parts.comments += static_cast<char>(std::to_integer<unsigned char>(gif.at(i + k)));
    ++i;
  }
  EXPECT_EQ(i + 1, gif.size());
  return parts;
}

Turning turning(int frames, double seconds) {
  Turning all{40, 30, frames, seconds, {}};
  for (int n = 0; n < frames; ++n) {
    view::Image one = picture(40, 30);
    for (std::size_t k = 0; k < one.rgba.size(); k += 4)
      one.rgba[k] = static_cast<std::uint8_t>(250 * n / frames);
    all.rgba.insert(all.rgba.end(), one.rgba.begin(), one.rgba.end());
  }
  return all;
}

TEST(encode, a_turning_picture_has_all_its_frames_takes_its_time_and_goes_on_without_end) {
  for (const auto& [frames, seconds, hundredths] :
       {std::tuple(40, 4.0, 10), {36, 4.0, 11}, {7, 0.5, 7}, {3, 0.03, 2}, {1, 4.0, 400}}) {
    const auto gif = encode(turning(frames, seconds), kCaption);
    ASSERT_TRUE(gif) << to_text(gif.error());
    const GifParts parts = parts_of(*gif);
    EXPECT_EQ(parts.pictures, static_cast<std::size_t>(frames));
    EXPECT_EQ(parts.times, std::vector<int>(static_cast<std::size_t>(frames), hundredths));
    EXPECT_EQ(parts.times_shown, 0);
    EXPECT_EQ(parts.comments, kCaption.title + kCaption.copyright + kCaption.description +
                                  parts.comments.substr(parts.comments.find("Onggi 0.")));
    const auto read = read_back(*gif, "turning.gif");
    EXPECT_EQ(read["width"], 40);
    EXPECT_EQ(read["height"], 30);
  }
  EXPECT_EQ(*encode(turning(5, 1), kCaption), *encode(turning(5, 1), kCaption)) << "the same bytes";
}

TEST(encode, a_turning_picture_that_is_none_is_refused) {
  Turning short_of_one = turning(4, 1.0);
  short_of_one.frames = 5;
  Turning endless = turning(1, 1.0);
  endless.frames = kMostFrames + 1;
  endless.rgba.resize(endless.rgba.size() * static_cast<std::size_t>(endless.frames));
  for (const Turning& none : {Turning{}, short_of_one, endless}) {
    const auto encoded = encode(none, {});
    ASSERT_FALSE(encoded);
    EXPECT_EQ(encoded.error().exit_code, 1);
  }
}

class BadHelper : public ::testing::Test {
 protected:
  /// What comes of a helper that is this shell script.
  Result<std::vector<std::byte>> with_helper(const std::string& script, double timeout_s = 10) {
    const fs::path file = scratch_.path() / "helper";
    EXPECT_TRUE(files::write_durably(file, bytes("#!/bin/sh\n" + script + "\n")));
    fs::permissions(file, fs::perms::owner_all);
    return encode_with(file, picture(600, 600), Format::png, kCaption, timeout_s);
  }
  ScratchFolder scratch_;
};

TEST_F(BadHelper, one_that_is_missing_is_named) {
  const fs::path gone = scratch_.path() / "onggi-encode";
  const auto encoded = encode_with(gone, picture(8, 8), Format::png, {}, 5);
  ASSERT_FALSE(encoded);
  EXPECT_EQ(encoded.error().where, gone.string());
  EXPECT_THAT(encoded.error().what, HasSubstr("could not be started"));
}

TEST_F(BadHelper, one_that_fails_has_its_last_words_told) {
  const auto encoded = with_helper("cat > /dev/null; echo 'no colour left' >&2; exit 3");
  ASSERT_FALSE(encoded);
  EXPECT_EQ(encoded.error().what, "The helper ended with status 3. It printed: no colour left");
}

TEST_F(BadHelper, one_that_dies_is_told_by_its_signal) {
  const auto encoded = with_helper("kill -SEGV $$");
  ASSERT_FALSE(encoded);
  EXPECT_THAT(encoded.error().what, HasSubstr("signal 11"));
}

TEST_F(BadHelper, what_one_was_killed_at_or_hung_at_is_done_by_another) {
  const auto whole = encode(picture(600, 600), Format::png, kCaption);
  ASSERT_TRUE(whole);
  for (const std::string first : {"kill -KILL $$", "exec sleep 60"}) {
    const std::string been = (scratch_.path() / ("been" + first.substr(0, 4))).string();
    const auto encoded = with_helper(
        "[ -e " + been + " ] && exec '" + helper().string() + "'\ntouch " + been + "\n" + first, 2);
    ASSERT_TRUE(encoded) << first << ": " << encoded.error().what;
    EXPECT_EQ(*encoded, *whole) << first;
  }
}

TEST_F(BadHelper, one_that_never_listens_does_not_break_us_by_a_signal) {
  const auto encoded = with_helper("exec 0<&-; sleep 0.2; exit 4");
  ASSERT_FALSE(encoded);
  EXPECT_THAT(encoded.error().what, HasSubstr("status 4"));
}

TEST_F(BadHelper, one_that_hangs_is_ended_in_time_and_leaves_no_zombie) {
  for (const char* script : {"exec sleep 600", "exec 1>&- 2>&-; exec sleep 600",
                             "trap '' TERM; while :; do echo x >&2; done"}) {
    const auto before = std::chrono::steady_clock::now();
    const auto encoded = with_helper(script, 0.5);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - before;
    ASSERT_FALSE(encoded);
    EXPECT_THAT(encoded.error().what, HasSubstr("was stopped"));
    EXPECT_LT(took.count(), 300.0) << "half a second was allowed, on a machine that may be busy";
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
    EXPECT_EQ(errno, ECHILD);
  }
}

TEST_F(BadHelper, one_that_talks_too_much_is_ended) {
  const auto encoded = with_helper("cat > /dev/null; exec cat /dev/zero");
  ASSERT_FALSE(encoded);
  EXPECT_THAT(encoded.error().what, HasSubstr("a larger picture than it may"));
}

TEST_F(BadHelper, half_a_picture_is_no_picture) {
  const auto encoded = with_helper("cat > /dev/null; printf '\\211PNG\\r\\n\\032\\n half'");
  ASSERT_FALSE(encoded);
  EXPECT_THAT(encoded.error().what, HasSubstr("an incomplete picture"));
}

TEST_F(BadHelper, it_inherits_three_descriptors_and_nothing_else) {
  const int null = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int stray = ::fcntl(null, F_DUPFD, 77);  // without CLOEXEC, as a driver might
  const auto encoded = with_helper("cat > /dev/null; ls /proc/$$/fd >&2; exit 5");
  ::close(stray);
  ::close(null);
  ASSERT_FALSE(encoded);
  // The shell's own descriptor of its script (10 or 255) may be among them; the stray one may not.
  EXPECT_THAT(encoded.error().what,
              ::testing::MatchesRegex(".*It printed: 0 1( 10| 11)* 2( 255)?"));
}

TEST_F(BadHelper, it_works_with_standard_input_closed_and_child_signals_ignored) {
  const int status = in_child([&] {
    ::close(0);
    ::signal(SIGCHLD, SIG_IGN);
    ::signal(SIGPIPE, SIG_DFL);
    return encode(picture(20, 20), Format::png, {}).has_value();
  });
  EXPECT_EQ(status, 0);
}

TEST(encode_helper, an_order_that_makes_no_sense_ends_with_a_reason) {
  const ScratchFolder scratch;
  for (const std::string order :
       {"", "x\n", "{}\n", "[1]\n", "{\"width\":1e9,\"height\":1,\"format\":\"png\"}\n",
        "{\"width\":99999,\"height\":1,\"format\":\"png\"}\n",
        "{\"width\":2,\"height\":2,\"format\":\"gif\"}\n",
        "{\"width\":2,\"height\":2,\"format\":\"png\"}\nabc"}) {
    const fs::path file = scratch.path() / "order";
    ASSERT_TRUE(files::write_durably(file, bytes(order)));
    FILE* const pipe = ::popen((helper().string() + " < " + file.string() + " 2>&1").c_str(), "r");
    std::string said(200, '\0');
    said.resize(std::fread(said.data(), 1, said.size(), pipe));
    EXPECT_EQ(WEXITSTATUS(::pclose(pipe)), 1);
    EXPECT_THAT(said, ::testing::StartsWith("onggi-encode: ")) << order;
  }
}

}  // namespace
}  // namespace onggi::encoding::encode_test
