#include "engine/math/vectors.h"

#include <gtest/gtest.h>

namespace onggi {
namespace {

TEST(Vectors, PlainCodeIsAlwaysThereAndComesLast) {
  ASSERT_FALSE(vector_kinds().empty());
  EXPECT_EQ(vector_kinds().back(), "SCALAR");
}

TEST(Vectors, OnlyAKindThatTheMachineHasCanBeChosen) {
  EXPECT_FALSE(use_vectors("abacus"));
  for (std::string_view kind : vector_kinds()) EXPECT_TRUE(use_vectors(kind)) << kind;
  EXPECT_TRUE(use_vectors(""));
}

}  // namespace
}  // namespace onggi
