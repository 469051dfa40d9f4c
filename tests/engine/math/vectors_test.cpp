#include "engine/math/vectors.h"

#include <gtest/gtest.h>

namespace onggi {
namespace {

TEST(Vectors, PlainCodeIsAlwaysThereAndComesLast) {
  ASSERT_FALSE(vector_kinds().empty());
  // Highway has two ways of plain code; which one depends on the compiler.
  const std::string_view last = vector_kinds().back();
  EXPECT_TRUE(last == "SCALAR" || last == "EMU128") << last;
}

TEST(Vectors, OnlyAKindThatTheMachineHasCanBeChosen) {
  EXPECT_FALSE(use_vectors("abacus"));
  for (std::string_view kind : vector_kinds()) EXPECT_TRUE(use_vectors(kind)) << kind;
  EXPECT_TRUE(use_vectors(""));
}

}  // namespace
}  // namespace onggi
