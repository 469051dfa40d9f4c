#include "kiosk/exhibit/shelf.h"

#include <chrono>
#include <utility>

#include "engine/scene/lump.h"
#include "kiosk/exhibit/log.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr int kPictureWidth = 480, kPictureHeight = 600;

struct Counters {
  std::atomic<int>* done;
  std::atomic<int>* total;
};

content::Catalogue read_shelf(const fs::path& path, Counters counters,
                              settings::ReaderLimits limits) {
  std::error_code ignored;
  const bool one = fs::is_regular_file(path, ignored) || fs::exists(path / "vessel.toml", ignored);
  if (!one)
    return content::open_shelf(
        path,
        [](int done, int total, const std::string&, void* user) {
          const auto* to = static_cast<Counters*>(user);
          to->total->store(total);
          to->done->store(done);
        },
        &counters, limits);
  content::Catalogue catalogue;
  content::LoadOptions options;
  options.limits = limits;
  if (auto vessels = content::load_vessels(path, options))
    catalogue.vessels = std::move(*vessels);
  else
    catalogue.problems.push_back(vessels.error());
  return catalogue;
}

}  // namespace

Shelf::Shelf(const fs::path& path, const Scenes& scenes, const settings::ReaderLimits& limits)
    : scenes_(scenes),
      reading_(
          std::async(std::launch::async, read_shelf, path, Counters{&done_, &total_}, limits)) {}

Shelf::~Shelf() = default;

bool Shelf::ready() {
  if (!reading_.valid()) return true;
  if (reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  fill_cards();
  return true;
}

void Shelf::wait() {
  if (reading_.valid()) fill_cards();
}

void Shelf::fill_cards() {
  catalogue_ = reading_.get();
  log_problems(catalogue_.problems);
  log_line("The shelf holds " + std::to_string(catalogue_.vessels.size()) + " vessels; " +
           std::to_string(catalogue_.problems.size()) + " could not be used.");
  cards_.reserve(catalogue_.vessels.size());
  for (const content::Vessel& vessel : catalogue_.vessels) {
    screens::ShelfCard card;
    card.vessel = &vessel;
    const Profile& own = vessel.extracted.profile;
    card.scale = workspace_scale(own);
    card.target = scaled(own, card.scale);
    card.wheel = scenes_.wheel_of(vessel.id);
    cards_.push_back(std::move(card));
  }
}

bool Shelf::draw_next_picture(render::Renderer& renderer) {
  for (screens::ShelfCard& card : cards_) {
    if (card.picture != 0) continue;
    card.picture =
        renderer.make_picture(card.vessel->mesh, card.vessel->color, kPictureWidth, kPictureHeight);
    return true;
  }
  return false;
}

}  // namespace onggi::exhibit
