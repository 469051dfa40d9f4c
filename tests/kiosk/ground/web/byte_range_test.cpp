#include "kiosk/ground/web/byte_range.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <utility>

namespace onggi::web::byte_range_test {
namespace {

using Kind = ByteRange::Kind;

TEST(ByteRange, OneSpanIsGivenAsAskedAndEndsWithTheFile) {
  const std::pair<const char*, Span> wanted[] = {
      {"bytes=0-99", {0, 100}},    {"bytes=500-", {500, 500}}, {"bytes=999-", {999, 1}},
      {"bytes=0-0", {0, 1}},       {"bytes=-100", {900, 100}}, {"bytes=-5000", {0, 1000}},
      {"bytes=10-5000", {10, 990}}};
  for (const auto& [header, span] : wanted) {
    const ByteRange range = byte_range(header, 1000);
    EXPECT_EQ(range.kind, Kind::span) << header;
    EXPECT_EQ(range.span, span) << header;
  }
}

TEST(ByteRange, BytesThatTheFileHasNotAreBeyondAndNonsenseIsTheWholeFile) {
  for (const char* header :
       {"bytes=1000-", "bytes=1000-2000", "bytes=-0", "bytes=99999999999999999999-"}) {
    EXPECT_EQ(byte_range(header, 1000).kind, Kind::beyond) << header;
    EXPECT_EQ(byte_range(header, 1000).span, Span{}) << header;
  }
  EXPECT_EQ(byte_range("bytes=0-", 0).kind, Kind::beyond);
  for (const char* header :
       {"", "bytes", "bytes=", "bytes=-", "bytes=a-b", "bytes=9-1", "bytes=0-1,5-6", "bytes= 1-2",
        "bytes=+1-2", "bytes=--1", "lines=0-1", "Bytes=0-1"}) {
    EXPECT_EQ(byte_range(header, 1000).kind, Kind::whole) << header;
    EXPECT_EQ(byte_range(header, 1000).span, (Span{0, 1000})) << header;
  }
}

TEST(ByteRange, NoTextLeadsOutOfTheFile) {
  EXPECT_TRUE(rc::check([] {
    const auto letters = *rc::gen::container<std::string>(
        rc::gen::elementOf(std::string("0123456789-,= +9876543210")));
    const auto size = *rc::gen::inRange<std::uint64_t>(0, 5000);
    const ByteRange range = byte_range("bytes=" + letters, size);
    RC_ASSERT(range.span.from <= size);
    RC_ASSERT(range.span.length <= size - range.span.from);
    RC_ASSERT((range.kind == Kind::span) <= (range.span.length > 0));
  }));
}

TEST(ByteRange, WhereverAPhoneStoppedTheRestIsWhatItLacks) {
  EXPECT_TRUE(rc::check([] {
    const auto size = *rc::gen::inRange<std::uint64_t>(1, 1u << 30);
    const auto has = *rc::gen::inRange<std::uint64_t>(0, size);
    const ByteRange range = byte_range("bytes=" + std::to_string(has) + "-", size);
    RC_ASSERT(range.kind == Kind::span);
    RC_ASSERT(range.span == (Span{has, size - has}));
  }));
}

}  // namespace
}  // namespace onggi::web::byte_range_test
