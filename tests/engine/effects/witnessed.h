#pragma once

#include <gtest/gtest.h>

#include <string>

namespace onggi::effects_test {

/// A law of the engine against something that is not the engine: a closed form, plain sums, a
/// balance, a limiting case, a symmetry. Fails where `off` is beyond `bound`; the test's report
/// (--gtest_output=xml) keeps one row of it.
inline void witnessed(const std::string& law, const std::string& witness, double off,
                      double bound) {
  EXPECT_LE(off, bound) << law << ", against " << witness;
  testing::Test::RecordProperty(law + " | " + witness,
                                std::to_string(off) + " of " + std::to_string(bound));
}

}  // namespace onggi::effects_test
