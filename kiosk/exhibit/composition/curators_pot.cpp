#include "kiosk/exhibit/composition/curators_pot.h"

#include <utility>

#include "kiosk/collection/content/translation_tables.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/visit/decorating/recorded.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

namespace {

constexpr int kOutlineRows = 400, kOutlineSectors = 64;

Problem no_way(const fs::path& vessel) {
  return {vessel.string(), "The exhibit has no way to decorate this vessel.",
          "Write way = \"celadon\", say, into its vessel.toml, and ways = \"FOLDER\" into the "
          "exhibit's file."};
}

}  // namespace

Result<std::unique_ptr<CuratorsPot>> CuratorsPot::open(const fs::path& config,
                                                       const fs::path& vessel,
                                                       const std::string& language,
                                                       const render::WindowOptions& window) {
  std::unique_ptr<CuratorsPot> table(new CuratorsPot);
  auto exhibit = settings::read_exhibit(config);
  files::log_problems(exhibit.problems);
  settings::Exhibit& of = table->exhibit_ = std::move(exhibit.exhibit);
  of.decorate = true;
  of.order = of.hidden = {};
  of.translations = content::read_translations(files::language_folder(of.file), of.languages);
  table->scenes_ = std::make_unique<Scenes>(of);
  auto languages = read_languages(of, language);
  if (!languages) return tl::unexpected<Problem>(languages.error());
  table->languages_ = std::move(*languages);

  table->shelf_ = std::make_unique<Shelf>(vessel, *table->scenes_, of);
  table->shelf_->wait();
  if (table->shelf_->cards().empty())
    return tl::unexpected<Problem>(table->shelf_->problems().front());
  const screens::ShelfCard& card = table->shelf_->cards().front();
  if (card.wheel.way == nullptr) return tl::unexpected<Problem>(no_way(vessel));

  auto renderer = render::Renderer::create(window);
  if (!renderer) return tl::unexpected<Problem>(renderer.error());
  table->renderer_ = std::move(*renderer);
  table->show_outline(card.target);

  screens::VisitInputs world;
  world.exhibit = &of;
  world.languages = &table->languages_;
  world.shelf = &table->shelf_->cards();
  world.measure = &table->renderer_->measure();
  world.wheel = &table->pot_;
  world.wheel_commands = &table->wheel_;
  table->visit_ = std::make_unique<screens::Visit>(world);
  table->visit_->decorate(0, card.target, 0.0);
  if (table->visit_->decorated_pot() == nullptr)
    return problem(vessel.string(), "Its outline cannot be decorated.",
                   "Look at it with onggi vessel inspect.");
  return table;
}

void CuratorsPot::show_outline(const Profile& pot) {
  ClayDef def;
  def.rows = kOutlineRows;
  def.sectors = kOutlineSectors;
  def.height = pot.height();
  def.floor_thickness = pot.floor_height();
  pot_.clay.lay(def);
  for (int j = 0; j < kOutlineRows; ++j) {
    const double height = pot_.clay.row_height(j);
    const std::vector<float> outer(kOutlineSectors, static_cast<float>(pot.outer_at(height)));
    const std::vector<float> inner(kOutlineSectors, j < pot_.clay.floor_rows()
                                                        ? 0.0f
                                                        : static_cast<float>(pot.inner_at(height)));
    pot_.clay.shape(j, outer, inner);
  }
  pot_.status.scene_serial = 1;  // the first pot, which the screens frame anew
  renderer_->show_clay(pot_.clay);
}

bool CuratorsPot::frame(double now) {
  bool open = true;
  for (const view::InputEvent& event : renderer_->poll()) {
    if (event.kind == view::InputEvent::Kind::close) open = false;
    visit_->input(event, now);
  }
  for (const std::string& line : renderer_->remarks()) files::log_line(line);
  renderer_->update_clay(pot_.clay);
  renderer_->show_decoration(visit_->decoration());
  visit_->update(now);
  while (visit_->take_request()) {
  }
  shown_ = visit_->frame(renderer_->width(), renderer_->height());
  renderer_->draw(shown_);
  renderer_->present();
  return open && !visit_->has_decorated();
}

decoration::Decoration CuratorsPot::decoration() const {
  const screens::ShelfCard& card = shelf_->cards().front();
  decoration::Decoration out = decorating::recorded(*visit_->decorated_pot(), card.scale);
  out.body = card.vessel->color;
  out.glaze = {1.0f, 1.0f, 1.0f};
  if (card.wheel.kiln && !card.wheel.kiln->glazes->empty())
    out.glaze = (*card.wheel.kiln->glazes)[static_cast<std::size_t>(card.wheel.kiln->order.front())]
                    .look.glass;
  return out;
}

}  // namespace onggi::exhibit
