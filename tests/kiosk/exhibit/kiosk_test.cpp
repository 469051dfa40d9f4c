#include "kiosk/exhibit/kiosk.h"

#include <gtest/gtest.h>

#include "kiosk/loop/memory.h"
#include "tests/support/holes.h"
#include "tests/support/sanitized.h"

namespace onggi::exhibit {
namespace {

TEST(Kiosk, AnExhibitIsOpenedInPagesAnewAndNotInThoseOfTheOneBefore) {
  if (ONGGI_SANITIZED) GTEST_SKIP() << "a sanitizer owns malloc";
  loop::keep_heap_small();
  const test::Holes holes;
  const double before = test::resident_mib();
  KioskOptions options;
  options.config = "/nowhere/exhibit.toml";
  EXPECT_FALSE(Kiosk::open(options));
  EXPECT_LT(test::resident_mib(), before - 0.9 * test::Holes::kMib);
}

}  // namespace
}  // namespace onggi::exhibit
