#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/keepsake/souvenir/postcard.h"
#include "kiosk/picture/render/text.h"
#include "kiosk/picture/view/high_contrast.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/square_code.h"
#include "tests/kiosk/picture/render/studio_fixture.h"
#include "tests/kiosk/visit/screens/codes_in.h"
#include "tests/kiosk/visit/screens/layout_check.h"

// A visitor's own page and the kiosk's own network, read off drawn screens and postcards as a phone
// reads them: from afar, and not sharp.

namespace onggi::screens::keepsake_code_test {
namespace {

const std::string kPage = "http://192.168.4.1:8080/k/u9fvw8wdsscd3zfq6bmprfmaqa";
const std::string kMuseum = "https://www.museum.go.kr/site/main/relic/search/view?relicId=305";
const std::string kNetwork = "WIFI:T:WPA;S:Onggi;P:moon jar 305;;";
constexpr std::pair<int, int> kScreens[] = {{1280, 720}, {1920, 1080}, {1080, 1920}, {1024, 600}};
// Standard deviations of a Gaussian, in modules.
constexpr double kBlurs[] = {0.0, 0.1, 0.2, 0.3, 0.4};

enum class Reached { no, in_the_museum, by_its_own_network };

/// Somebody at the last screen.
view::Frame last_screen(int width, int height, const std::string& language, Reached reached,
                        bool contrast) {
  const render::Typesetter fonts;
  Visitor v(3, &fonts, true);
  v.exhibit.screen.high_contrast = contrast;
  if (reached == Reached::by_its_own_network) {
    v.exhibit.phone.network = "Onggi";
    v.exhibit.phone.password = "moon jar 305";
  }
  v.width = width;
  v.height = height;
  v.show();
  if (language == "ko") v.speak("ko");
  v.make_result();
  v.glaze_and_fire();
  v.touch("kiln.keep");
  v.frames(1);
  v.visit->keepsake_kept("2026-05-04_141503", reached == Reached::no ? "" : kPage);
  v.frames(1);
  check_layout(v, fonts, "keepsake for a phone");
  return v.frame;
}

/// Modules: boxes of ink that are no drawing's strips.
std::vector<view::Rect> modules_of(const view::Frame& frame) {
  std::vector<view::Rect> modules;
  for (const view::Item& item : frame.items)
    if (const auto* box = std::get_if<view::Box>(&item);
        box != nullptr && box->radius == 0 && box->rect.h >= 3 &&
        (box->fill == view::kInk || box->fill == view::in_high_contrast(view::kInk)))
      modules.push_back(box->rect);
  return modules;
}

/// Pixels.
double smallest(const std::vector<view::Rect>& modules) {
  double least = 1e9;
  for (const view::Rect& box : modules) least = std::min(least, static_cast<double>(box.h));
  return least;
}

/// What of `image` all codes and their quiet zones fill.
view::Image codes_part(const view::Image& image, const view::Frame& frame) {
  float left = 1e9f, top = 1e9f, right = 0, foot = 0, high = 0;
  for (const view::Rect& box : modules_of(frame)) {
    left = std::min(left, box.x);
    top = std::min(top, box.y);
    right = std::max(right, box.x + box.w);
    foot = std::max(foot, box.y + box.h);
    high = std::max(high, box.h);
  }
  const auto x0 = static_cast<int>(std::max(0.0f, left - 6 * high));
  const auto y0 = static_cast<int>(std::max(0.0f, top - 6 * high));
  const int x1 = std::min(image.width, static_cast<int>(right + 6 * high));
  const int y1 = std::min(image.height, static_cast<int>(foot + 6 * high));
  view::Image part{x1 - x0, y1 - y0, {}};
  for (int y = y0; y < y1; ++y) {
    const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width + x0);
    part.rgba.insert(part.rgba.end(), row, row + 4 * part.width);
  }
  return part;
}

class AVisitorsPage : public render::testing::StudioTest {};

TEST_F(AVisitorsPage, IsReadOffTheLastScreenWhileAPhoneCanReachItAndOnlyThen) {
  for (const auto& [width, height] : kScreens)
    for (const char* language : {"en", "ko"})
      for (const Reached reached :
           {Reached::no, Reached::in_the_museum, Reached::by_its_own_network}) {
        const view::Frame frame = last_screen(width, height, language, reached, false);
        const view::Image image = renderer().draw_offscreen(frame);
        const std::string name = "phone_" + std::to_string(width) + '_' + language + '_' +
                                 std::to_string(static_cast<int>(reached));
        render::testing::keep_for_looking(image, name);
        std::vector<std::string> wanted;
        if (reached == Reached::by_its_own_network) wanted.push_back(kNetwork);
        if (reached != Reached::no) wanted.push_back(kPage);
        EXPECT_EQ(codes_in(image), wanted) << name;
      }
}

TEST_F(AVisitorsPage,
       IsDarkOnLightWithItsQuietAndReadThroughFiveBlursOnEveryScreenInHighContrastToo) {
  for (const auto& [width, height] : kScreens)
    for (const bool contrast : {false, true}) {
      const view::Frame frame =
          last_screen(width, height, "en", Reached::by_its_own_network, contrast);
      const view::Image image = renderer().draw_offscreen(frame);
      const auto modules = modules_of(frame);
      ASSERT_FALSE(modules.empty());
      SCOPED_TRACE(std::to_string(width) + (contrast ? ", high contrast" : ""));
      render::testing::keep_for_looking(
          image, "phone_contrast_" + std::to_string(width) + (contrast ? "_high" : ""));
      // All ink is dark, and the four modules round it light: what a phone takes for granted.
      int darkest_light = 255, lightest_dark = 0;
      const auto grey = [&](double x, double y) {
        const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
        return (299 * image.rgba[at] + 587 * image.rgba[at + 1] + 114 * image.rgba[at + 2]) / 1000;
      };
      for (const view::Rect& box : modules)
        for (double x = box.x + box.h / 2; x < box.x + box.w; x += box.h)
          lightest_dark = std::max(lightest_dark, grey(x, box.y + box.h / 2));
      // From each row's first ink outward.
      for (const view::Rect& box : modules) {
        const bool first = std::none_of(modules.begin(), modules.end(), [&](const view::Rect& o) {
          return o.y == box.y && o.x < box.x && o.x + o.w > box.x - 40 * box.h;
        });
        for (double away = 0.5; first && away < 4; away += 1)
          darkest_light = std::min(darkest_light, grey(box.x - away * box.h, box.y + box.h / 2));
      }
      EXPECT_LT(lightest_dark, 80);
      EXPECT_GT(darkest_light, 190);
      const view::Image part = codes_part(image, frame);
      const double module = smallest(modules);
      for (const double blur : kBlurs)
        EXPECT_EQ(codes_in(seen_through(part, 1.0, blur * module)),
                  (std::vector<std::string>{kNetwork, kPage}))
            << blur << " modules of " << module << " px";
    }
}

struct Card {
  const char *code, *title, *vessel, *credit, *date, *glaze, *phone, *museum;
};
const Card kCards[] = {
    {"en", "My pot, inspired by: Panathenaic amphora", "Greece, Athens, about 530 BCE",
     "The Museum of Pots, with a credit as long as a museum may have in its exhibit's file",
     "4 May 2026", "Celadon, 175 mm high", "Your pot on a phone, until 5 May 2026",
     "The vessel at the museum"},
    {"ko", "나의 대답: 달항아리", "조선, 18세기", "국립중앙박물관", "2026년 5월 4일",
     "청자유, 높이 175mm", "휴대전화로 보는 나의 그릇, 2026년 5월 5일까지", "박물관에 있는 그릇"},
    {"de", "Meine Antwort auf: Panathenäische Amphora", "Griechenland, Athen, um 530 v. Chr.",
     "Onggi, Formen nach veröffentlichten Maßen gezeichnet", "4. Mai 2026", "Seladon, 175 mm hoch",
     "Ihr Gefäß auf dem Telefon, bis 5. Mai 2026", "Das Gefäß im Museum"},
    {"ja", "わたしの答え：月の壺", "朝鮮時代、18世紀", "博物館", "2026年5月4日",
     "青磁釉、高さ175mm", "携帯電話で見られます（2026年5月5日まで）", "博物館の器"},
    {"ar", "إنائي على مثال: جرّة القمر", "كوريا، عهد جوسون، القرن الثامن عشر",
     "Onggi, shapes drawn from published dimensions.", "4 مايو 2026", "سيلادون، الارتفاع 175 مم",
     "إناؤك على الهاتف حتى 5 مايو 2026", "الإناء في المتحف"}};

/// `belly` wide, `height` high, metres.
Profile vessel_of(double belly, double height) {
  Profile p = jar(belly, 0.5 * belly, 0.5 * belly);
  for (ProfilePoint& point : p.points) point.height *= height / 0.2;
  return p;
}

TEST_F(AVisitorsPage, IsReadOffThePostcardInEveryScriptOfTallAndWideVesselsAndBesideTheMuseums) {
  const render::Typesetter fonts;
  const std::pair<double, double> vessels[] = {{0.04, 0.38}, {0.13, 0.14}};
  for (const Card& card : kCards)
    for (const auto& [belly, height] : vessels)
      for (const bool museum : {false, true}) {
        souvenir::PostcardWords words;
        words.title = card.title;
        words.vessel = card.vessel;
        words.credit = card.credit;
        words.date = card.date;
        words.glaze = card.glaze;
        words.language = card.code;
        words.right_to_left = std::string(card.code) == "ar";
        words.phone = kPage;
        words.phone_words = card.phone;
        words.address = museum ? kMuseum : "";
        words.address_words = card.museum;
        const auto made = vessel_of(belly, height), target = vessel_of(1.1 * belly, height);
        const view::Frame frame =
            souvenir::compose_postcard(words, made, target, fonts, view::Glazing{});
        const view::Image image = renderer().draw_offscreen(frame);
        const std::string name = std::string("postcard_") + card.code +
                                 (height > 0.2 ? "_tall" : "_wide") + (museum ? "_both" : "");
        render::testing::keep_for_looking(image, name);
        std::vector<std::string> wanted{kPage};
        if (museum) wanted.push_back(kMuseum);
        // As it is printed, and whole on a screen of 1080 lines.
        EXPECT_EQ(codes_in(image), wanted) << name;
        EXPECT_EQ(codes_in(seen_through(image, 0.5, 0)), wanted) << name;
      }
}

TEST_F(AVisitorsPage, IsReadOffPaperThroughFiveBlursAndOffAScreenThroughFour) {
  souvenir::PostcardWords words;
  words.title = kCards[0].title;
  words.phone_words = kCards[0].phone;
  for (const std::string& page :
       {kPage, "http://" + std::string(93, 'm') + "/k/u9fvw8wdsscd3zfq6bmprfmaqa"}) {
    words.phone = page;
    const view::Frame frame = souvenir::compose_postcard(words, jar(0.08), jar(0.09),
                                                         render::Typesetter(), view::Glazing{});
    const view::Image part = codes_part(renderer().draw_offscreen(frame), frame);
    const double module = smallest(modules_of(frame));
    for (const double blur : kBlurs) {
      EXPECT_EQ(codes_in(seen_through(part, 1.0, blur * module)), std::vector{page})
          << page << ' ' << blur << " modules of " << module << " px";
      if (blur == kBlurs[4]) continue;
      EXPECT_EQ(codes_in(seen_through(part, 0.5, blur * module / 2)), std::vector{page})
          << page << ' ' << blur << " modules of " << module / 2 << " px";
    }
  }
}

}  // namespace
}  // namespace onggi::screens::keepsake_code_test
