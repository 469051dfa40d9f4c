#include "engine/math/vectors.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace onggi::vectors_test {
namespace {

TEST(Vectors, ArraysAreAlwaysThereAndComeLast) {
  ASSERT_FALSE(vectors_here().empty());
  EXPECT_EQ(vectors_here().back(), Vectors::plain);
}

TEST(Vectors, TheBestIsWiderThanWhatEveryProcessorOfTheKindHas) {
  EXPECT_EQ(best_vectors(), vectors_here().front());
#if defined(__x86_64__)
  EXPECT_NE(std::ranges::find(vectors_here(), Vectors::sse2), vectors_here().end());
  EXPECT_EQ(best_vectors() == Vectors::avx2, __builtin_cpu_supports("avx2") != 0);
#elif defined(__aarch64__)
  EXPECT_EQ(best_vectors(), Vectors::neon);
#endif
}

TEST(Vectors, EveryKindHasANameOfItsOwn) {
  for (const Vectors kind : vectors_here()) {
    EXPECT_FALSE(name_of(kind).empty());
    EXPECT_EQ(std::ranges::count(vectors_here(), name_of(kind), name_of), 1);
  }
}

}  // namespace
}  // namespace onggi::vectors_test
