#include "kiosk/ground/files/printed.h"

#include <gtest/gtest.h>

#include <iostream>
#include <streambuf>

namespace onggi::files::printed_test {
namespace {

/// A disk that takes `room` bytes, and no more when it is flushed.
class FullDisk : public std::streambuf {
 public:
  explicit FullDisk(int room) : room_(room), old_(std::cout.rdbuf(this)) {}
  ~FullDisk() override {
    std::cout.rdbuf(old_);
    std::cout.clear();
  }

 protected:
  int overflow(int c) override { return held_++, c; }
  int sync() override { return held_ <= room_ ? 0 : -1; }

 private:
  int room_, held_ = 0;
  std::streambuf* old_;
};

TEST(Printed, WhatAFullDiskDoesNotTakeIsTold) {
  {
    const FullDisk disk(10);
    std::cout << "a line\n";
    EXPECT_TRUE(all_printed());
    std::cout << "another one\n";
    const auto printed = all_printed();
    ASSERT_FALSE(printed);
    EXPECT_EQ(printed.error().exit_code, 1);
  }
  EXPECT_TRUE(all_printed());
}

TEST(Printed, AnEarlierFaultIsNotForgotten) {
  const FullDisk disk(0);
  std::cout << "a line\n" << std::flush;
  EXPECT_FALSE(all_printed());
}

}  // namespace
}  // namespace onggi::files::printed_test
