#include "kiosk/exhibit/composition/shelf.h"

#include <functional>
#include <utility>

#include "engine/scene/lump.h"
#include "kiosk/collection/content/translation_tables.h"
#include "kiosk/ground/files/log.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

void read(const fs::path& path, Arrivals& arrivals, settings::ReaderLimits limits,
          const content::Arrangement& arrangement) {
  std::error_code ignored;
  const bool one = fs::is_regular_file(path, ignored) || fs::exists(path / "vessel.toml", ignored);
  if (one) {
    arrivals.begins(0, 1, path.filename().string());
    content::LoadOptions options;
    options.limits = limits;
    options.for_screen = true;
    arrivals.has_read(0, content::load_vessels(path, options));
  } else if (auto good = content::read_shelf(path, arrivals, limits, arrangement); !good) {
    arrivals.begins(0, 1, path.filename().string());
    arrivals.has_read(0, tl::unexpected<Problem>(good.error()));
  }
  arrivals.finish();
}

}  // namespace

Shelf::Shelf(const fs::path& path, const Scenes& scenes, const settings::Exhibit& exhibit)
    : scenes_(scenes),
      exhibit_(exhibit),
      reading_(std::async(std::launch::async, read, path, std::ref(arrivals_), exhibit.reader,
                          content::Arrangement{exhibit.order, exhibit.hidden})) {}

Shelf::~Shelf() = default;

bool Shelf::look(double now) {
  if (!complete_) take(now);
  return complete_ || !cards_.empty();
}

void Shelf::wait() {
  if (reading_.valid()) reading_.get();
  look(0.0);
}

void Shelf::take(double now) {
  for (Arrivals::Read& read : arrivals_.take(now)) {
    if (!read) {
      problems_.push_back(read.error());
      files::log_problem(read.error());
      continue;
    }
    for (content::Vessel& vessel : *read) {
      if (cards_.size() == content::kMostOnShelf) break;
      content::translate(vessel, exhibit_.translations);
      vessels_.push_back(std::move(vessel));
      screens::ShelfCard card;
      card.vessel = &vessels_.back();
      const Profile& own = card.vessel->extracted.profile;
      card.scale = workspace_scale(own);
      card.target = scaled(own, card.scale);
      card.wheel = scenes_.wheel_of(*card.vessel);
      if (const SceneDef* built = scenes_.built(*card.vessel))
        card.built = scenes_.for_visitor(*built, *card.vessel);
      cards_.push_back(std::move(card));
    }
  }
  complete_ = arrivals_.over();
  if (complete_)
    files::log_line("The shelf holds " + std::to_string(cards_.size()) +
                    (cards_.size() == 1 ? " vessel; " : " vessels; ") +
                    std::to_string(problems_.size()) + " could not be used.");
}

bool Shelf::draw_next_picture(render::Renderer& renderer) {
  for (screens::ShelfCard& card : cards_) {
    if (card.picture != 0) continue;
    card.picture = picture_.next(renderer, *card.vessel);
    return true;
  }
  return false;
}

}  // namespace onggi::exhibit
