#include "engine/lab/scene_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace onggi::lab::scene_fields_test {
namespace {

TEST(SceneFields, EndsAreThoseOfTheCheckedRangeAndNoStepBeyond) {
  for (const SceneField& field : scene_fields())
    for (const bool upper : {false, true}) {
      const double end = upper ? field.most : field.least;
      SceneDef def = bare({});
      field.set(def, end);
      ASSERT_TRUE(validate(def)) << field.name << ' ' << end << ": "
                                 << to_text(validate(def).error());
      ASSERT_TRUE(field.there(def)) << field.name;
      EXPECT_EQ(field.get(def), end) << field.name;
      if (field.bounded) continue;
      const bool whole = field.name == "clay.rows" || field.name == "clay.sectors";
      const double step = upper ? 1.0 : -1.0;
      // Of a tool's size 0 stands for the usual one; nothing is just below 0 but what is negative.
      field.set(def, whole ? end + step : std::nextafter(end, upper ? 2.0 * end + 1.0 : -1.0));
      EXPECT_FALSE(validate(def)) << field.name << ' ' << end;
    }
}

TEST(SceneFields, NameEveryEffectsFieldsOnce) {
  std::set<std::string> names;
  for (const SceneField& field : scene_fields())
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
  SceneDef any;
  each_effect(any, [&]<class Def>(const std::optional<Def>&) {
    for (const DefField<Def>& field : Def::fields())
      EXPECT_TRUE(names.contains(std::string(Def::kName) + "." + field.key)) << field.key;
  });
  EXPECT_TRUE(names.contains("clay.wall_min"));
  EXPECT_TRUE(names.contains("needle.length"));
  EXPECT_FALSE(names.contains("needle.thickness"));
}

TEST(SceneFields, AnEffectComesWithWhatItNeedsAndGoesWithWhatNeedsIt) {
  const std::vector<std::string> names = effect_names();
  SceneDef def = bare({});
  for (std::size_t n = 0; n < names.size(); ++n) {
    add_effect(def, n);
    ASSERT_TRUE(has_effect(def, n)) << names[n];
    ASSERT_TRUE(validate(def)) << names[n];
  }
  for (std::size_t n = 0; n < names.size(); ++n) {
    SceneDef less = def;
    remove_effect(less, n);
    EXPECT_FALSE(has_effect(less, n)) << names[n];
    EXPECT_TRUE(validate(less)) << names[n];
  }
}

}  // namespace
}  // namespace onggi::lab::scene_fields_test
