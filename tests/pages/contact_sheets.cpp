#include "tests/pages/contact_sheets.h"

#include <algorithm>
#include <cstdio>
#include <future>
#include <map>
#include <utility>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/picture/encoding/encode.h"
#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/comfort.h"

namespace fs = std::filesystem;

namespace onggi::pages {

namespace {

constexpr int kSmallLong = 150;  // pixels of a small picture's longer side
constexpr float kGap = 8, kSheetHead = 22, kMargin = 16, kWords = 13, kNarrow = 120,
                kStateName = 400;
constexpr int kPiece = 2048;  // pixels wide and high

/// `image` reduced to `width` x `height` pixels by averaging.
view::Image smaller(const view::Image& image, int width, int height) {
  view::Image out{width, height, {}};
  out.rgba.resize(static_cast<std::size_t>(4 * width * height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int x0 = x * image.width / width, x1 = std::max(x0 + 1, (x + 1) * image.width / width);
      const int y0 = y * image.height / height,
                y1 = std::max(y0 + 1, (y + 1) * image.height / height);
      for (int k = 0; k < 4; ++k) {
        int sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u)
            sum += image.rgba[static_cast<std::size_t>(4 * (v * image.width + u) + k)];
        const int count = (x1 - x0) * (y1 - y0);
        out.rgba[static_cast<std::size_t>(4 * (y * width + x) + k)] =
            static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  return out;
}

Result<void> keep(const view::Image& image, const fs::path& file, const std::string& title) {
  auto bytes = encoding::encode(image, encoding::Format::jpeg, {title, "", ""});
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto made = files::make_folder(file.parent_path()); !made) return made;
  return files::write_durably(file, *bytes);
}

settings::Exhibit::Screen screen_of(settings::Exhibit::Screen screen, const std::string& comfort) {
  for (const screens::Comfort::Choice& choice : screens::Comfort::kChoices)
    if (comfort == "all" || comfort == choice.name) screen.*choice.of = true;
  // The highest mounting of an exhibit, where low reach leaves the least space.
  if (screen.low_reach) screen.lower_edge_mm = 1000;
  return screen;
}

/// Takes pictures: two workers write them at full size, and small copies are kept.
class Album {
 public:
  Album(exhibit::Kiosk& kiosk, const std::vector<SheetPlan>& plans, fs::path folder, bool full)
      : kiosk_(kiosk),
        plans_(plans),
        folder_(std::move(folder)),
        full_(full),
        usual_(kiosk.exhibit().screen) {}

  Result<void> look(const std::string& state) {
    states_.push_back(state);
    char number[8];
    std::snprintf(number, sizeof number, "%02zu_", states_.size());
    std::string file = number + state + ".jpg";
    std::replace(file.begin(), file.end(), ' ', '_');
    for (const SheetPlan& plan : plans_)
      for (const Sight& sight : plan.sights) {
        const std::string key = sight.name();
        if (small_[key].size() == states_.size() || (!plan.kept && !full_)) continue;
        const view::Image image = picture(sight);
        small_[key].push_back(
            sight.width > sight.height
                ? smaller(image, kSmallLong, kSmallLong * sight.height / sight.width)
                : smaller(image, kSmallLong * sight.width / sight.height, kSmallLong));
        if (!full_) continue;
        if (auto good = write(image, folder_ / key / file, state); !good) return good;
      }
    kiosk_.show_as(usual_, plans_.front().sights.front().language);
    const auto status = kiosk_.renderer().status();
    if (status.text_overflows > overflows_)
      return problem("screen " + state, "Words do not fit their box: " + status.last_overflow + ".",
                     "This is a fault of the program: please report it.", 1);
    return {};
  }

  Result<void> finish() {
    while (!writing_.empty())
      if (auto good = settle(); !good) return good;
    for (const SheetPlan& plan : plans_)
      if (plan.kept)
        if (auto good = keep(sheet(plan), folder_ / (plan.name + ".jpg"), plan.name); !good)
          return good;
    return {};
  }

 private:
  view::Image picture(const Sight& sight) {
    kiosk_.show_as(screen_of(usual_, sight.comfort), sight.language);
    return kiosk_.renderer().draw_offscreen(kiosk_.visit().frame(sight.width, sight.height));
  }

  Result<void> write(const view::Image& image, const fs::path& file, const std::string& state) {
    if (writing_.size() >= 2)
      if (auto good = settle(); !good) return good;
    writing_.push_back(std::async(std::launch::async, keep, image, file, "Onggi: " + state));
    return {};
  }
  Result<void> settle() {
    const Result<void> good = writing_.front().get();
    writing_.erase(writing_.begin());
    return good;
  }

  /// A column for each sight, a row for each state.
  view::Image sheet(const SheetPlan& plan) {
    std::vector<view::Item> items;
    std::vector<view::PictureId> held;
    const auto words = [&](float x, float y, float w, const std::string& text, float lines = 1) {
      view::Text line;
      line.box = {x, y, w, lines * kSheetHead};
      line.text = text;
      line.style.px = kWords;
      line.color = view::kInk;
      items.emplace_back(line);
    };
    float x = kMargin, bottom = 0;
    for (const Sight& sight : plan.sights) {
      const auto& column = small_[sight.name()];
      const auto wide = static_cast<float>(column.front().width);
      float y = kMargin;
      // Over a narrow column a name needs three lines.
      const float lines = wide < kNarrow ? 3 : 1;
      std::string name = sight.name();
      std::replace(name.begin(), name.end(), '_', ' ');
      words(x, y, wide, name, lines);
      y += lines * kSheetHead;
      for (std::size_t i = 0; i < column.size(); ++i) {
        const auto high = static_cast<float>(column[i].height);
        // Nothing is beside it, over the other columns.
        if (&sight == &plan.sights.front()) words(x, y, kStateName, states_[i]);
        y += kSheetHead;
        held.push_back(kiosk_.renderer().make_picture(column[i]));
        items.emplace_back(view::Picture{{x, y, wide, high}, held.back(), 1});
        y += high;
      }
      x += wide + kGap;
      bottom = std::max(bottom, y);
    }
    const view::Image image = drawn_in_pieces(items, static_cast<int>(x - kGap + kMargin),
                                              static_cast<int>(bottom + kMargin));
    for (const view::PictureId id : held) kiosk_.renderer().drop_picture(id);
    return image;
  }

  /// A sheet is larger than any picture that can be drawn at once.
  view::Image drawn_in_pieces(const std::vector<view::Item>& items, int width, int height) {
    view::Image whole{width, height, {}};
    whole.rgba.resize(static_cast<std::size_t>(4 * width) * static_cast<std::size_t>(height));
    for (int top = 0; top < height; top += kPiece)
      for (int left = 0; left < width; left += kPiece) {
        view::Frame piece;
        piece.width = std::min(kPiece, width - left);
        piece.height = std::min(kPiece, height - top);
        const view::Rect here{0, 0, static_cast<float>(piece.width),
                              static_cast<float>(piece.height)};
        piece.items.emplace_back(view::Box{here, 0, view::kPlaster, 0, {}});
        for (view::Item item : items) {
          view::Rect& box = std::holds_alternative<view::Text>(item)
                                ? std::get<view::Text>(item).box
                                : std::get<view::Picture>(item).box;
          box.x -= static_cast<float>(left);
          box.y -= static_cast<float>(top);
          if (box.x < here.w && box.x + box.w > 0 && box.y < here.h && box.y + box.h > 0)
            piece.items.push_back(std::move(item));
        }
        const view::Image drawn = kiosk_.renderer().draw_offscreen(piece);
        const auto row = static_cast<std::size_t>(4 * piece.width);
        for (int y = 0; y < piece.height; ++y)
          std::copy_n(
              &drawn.rgba[static_cast<std::size_t>(y) * row], row,
              &whole.rgba[4 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(left))]);
      }
    return whole;
  }

  exhibit::Kiosk& kiosk_;
  const std::vector<SheetPlan>& plans_;
  fs::path folder_;
  bool full_;
  settings::Exhibit::Screen usual_;
  std::uint64_t overflows_ = kiosk_.renderer().status().text_overflows;
  std::vector<std::string> states_;
  std::map<std::string, std::vector<view::Image>> small_;
  std::vector<std::future<Result<void>>> writing_;
};

}  // namespace

std::string Sight::name() const {
  return std::to_string(width) + "x" + std::to_string(height) + "_" + language +
         (comfort.empty() ? "" : "_" + comfort);
}

std::vector<SheetPlan> plans(const std::vector<std::string>& languages) {
  constexpr std::pair<int, int> kAcross{1280, 720}, kUpright{1080, 1920}, kLarge{1920, 1080},
      kSmall{1024, 600};
  const auto in_all = [&](std::pair<int, int> size) {
    std::vector<Sight> sights;
    for (const std::string& language : languages)
      sights.push_back({size.first, size.second, language, ""});
    return sights;
  };
  const auto comforts = [&](std::pair<int, int> size) {
    std::vector<Sight> sights;
    for (const screens::Comfort::Choice& choice : screens::Comfort::kChoices)
      sights.push_back({size.first, size.second, languages.front(), choice.name});
    sights.push_back({size.first, size.second, languages.front(), "all"});
    if (languages.size() > 1) sights.push_back({size.first, size.second, languages.back(), "all"});
    return sights;
  };
  std::vector<Sight> sizes{{kLarge.first, kLarge.second, languages.front(), ""},
                           {kSmall.first, kSmall.second, languages.front(), ""},
                           {kSmall.first, kSmall.second, languages.back(), ""}};
  return {{"languages_across", in_all(kAcross)},
          {"languages_upright", in_all(kUpright)},
          {"comforts_across", comforts(kAcross)},
          {"comforts_upright", comforts(kUpright)},
          {"sizes", sizes},
          {"large", in_all(kLarge), false},
          {"small", in_all(kSmall), false}};
}

Result<void> draw_contact_sheets(exhibit::Kiosk& kiosk, const ScreenWalk& walk,
                                 const std::vector<SheetPlan>& plans, const fs::path& folder,
                                 bool full, const std::function<void(const std::string&)>& told) {
  Album album(kiosk, plans, folder, full);
  const auto walked = walk([&](const std::string& state) {
    told(state);
    return album.look(state);
  });
  if (!walked) return walked;
  return album.finish();
}

}  // namespace onggi::pages
