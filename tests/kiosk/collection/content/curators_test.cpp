#include <iterator>

#include "kiosk/collection/content/drawing.h"
#include "kiosk/collection/content/pack.h"
#include "tests/kiosk/collection/content/temporary.h"

// What the curators' pages in kiosk/docs show must work when it is copied.

namespace onggi::content::curators_test {
namespace {

class CuratorsPage : public Temporary {
 protected:
  /// The toml listing of kiosk/docs/`name` that contains `words`.
  static std::string listing(const std::string& name, const std::string& words) {
    const std::string text = files::test::content("kiosk/docs/" + name);
    const std::string open = "```toml\n";
    for (auto at = text.find(open); at != std::string::npos; at = text.find(open, at + 1)) {
      const auto from = at + open.size();
      const std::string found = text.substr(from, text.find("```", from) - from);
      if (found.find(words) != std::string::npos) return found;
    }
    return "";
  }
};

TEST_F(CuratorsPage, its_drawing_can_be_turned) {
  const DrawingRead read =
      check_drawing(write("profile.toml", listing("draw_a_vessel.md", "outer = [")));
  for (const Problem& p : read.problems) ADD_FAILURE() << to_text(p);
  EXPECT_GT(read.drawing.section.outline.size(), 20u);
}

TEST_F(CuratorsPage, its_pack_is_read_without_a_word_of_complaint) {
  const PackRead read =
      read_pack(write("jar/vessel.toml", listing("add_a_vessel.md", "true_height_mm")));
  for (const auto* list : {&read.problems, &read.advice})
    for (const Problem& p : *list) ADD_FAILURE() << to_text(p);
  EXPECT_EQ(read.pack.labels.size(), 2u);
}

}  // namespace
}  // namespace onggi::content::curators_test
