#include "engine/surface/layer.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/math/random.h"

namespace onggi::surface::layer_test {
namespace {

using Small = Layer<std::uint16_t, 64, 60>;

std::uint64_t hash_of(const Small& layer) {
  StateHash hash;
  layer.add_to(hash);
  return hash.value();
}

TEST(Layer, KeepsWhatIsSetAndNothingElse) {
  Small layer(100, 120);
  std::vector<std::uint16_t> plain(100 * 120);
  Random random(1);
  for (int n = 0; n < 20000; ++n) {
    const int row = static_cast<int>(random.bits() % 100),
              column = static_cast<int>(random.bits() % 120);
    const auto value = static_cast<std::uint16_t>(random.bits() % 5);
    layer.set(row, column, value);
    plain[static_cast<std::size_t>(row * 120 + column)] = value;
  }
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 120; ++column)
      ASSERT_EQ(layer.at(row, column), plain[static_cast<std::size_t>(row * 120 + column)]);
}

TEST(Layer, ATileIsAllocatedWhenTouchedAndATileOfOneValueIsOneValue) {
  Small layer(128, 120);
  const std::size_t bare = layer.bytes();
  layer.set(3, 3, 0);  // what it was
  EXPECT_EQ(layer.bytes(), bare);
  layer.begin_step();
  for (int row = 64; row < 128; ++row)
    for (int column = 0; column < 60; ++column) layer.set(row, column, 9);
  EXPECT_EQ(layer.bytes(), bare + 64 * 60 * 2);
  layer.settle();
  EXPECT_EQ(layer.bytes(), bare);
  EXPECT_EQ(layer.at(64, 0), 9);
  EXPECT_EQ(layer.at(63, 0), 0);
  EXPECT_EQ(layer.at(64, 60), 0);
}

TEST(Layer, StepsComeBackLastOneFirstAndTheHashWithThem) {
  Small layer(100, 120);
  Random random(2);
  std::vector<std::uint64_t> hashes;
  for (int step = 0; step < 10; ++step) {
    hashes.push_back(hash_of(layer));
    layer.begin_step();
    for (int n = 0; n < 300; ++n)
      layer.set(static_cast<int>(random.bits() % 100), static_cast<int>(random.bits() % 120),
                static_cast<std::uint16_t>(random.bits()));
    layer.settle();
  }
  for (int step = 9; step >= 0; --step) {
    layer.undo();
    EXPECT_EQ(hash_of(layer), hashes[static_cast<std::size_t>(step)]) << step;
  }
}

TEST(Layer, WhatIsChangedAgainAfterAStepBackIsKeptAgain) {
  Small layer(64, 60);
  layer.begin_step(), layer.set(0, 0, 1), layer.settle();
  layer.begin_step(), layer.set(0, 0, 2), layer.settle();
  layer.undo();
  layer.set(0, 0, 3);  // goes on with the first step
  layer.undo();
  EXPECT_EQ(layer.at(0, 0), 0);
  layer.begin_step(), layer.set(0, 0, 4), layer.undo();
  EXPECT_EQ(layer.at(0, 0), 0);
}

TEST(Layer, TheHashTellsOneValueFromAnother) {
  Small a(64, 60), b(64, 60);
  EXPECT_EQ(hash_of(a), hash_of(b));
  a.set(5, 5, 1), b.set(5, 6, 1);
  EXPECT_NE(hash_of(a), hash_of(b));
}

}  // namespace
}  // namespace onggi::surface::layer_test
