#include "kiosk/exhibit/composition/taken_home.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <string_view>
#include <utility>

#include "engine/clay/clay_mesh.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/decoration/relief.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/exhibit/composition/cones.h"
#include "kiosk/exhibit/composition/pot_model.h"
#include "kiosk/exhibit/composition/pot_relief.h"
#include "kiosk/exhibit/composition/rollout_views.h"
#include "kiosk/exhibit/composition/small_picture.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/postcard.h"
#include "kiosk/picture/drawing/pot_sheet.h"

namespace onggi::exhibit {

namespace {

// Of the kept model: a row a millimetre, and 3 degrees a sector. So it has under 65,536 corners,
// and two bytes name one.
constexpr int kKeptRows = 240, kKeptSectors = 120;
// Of a decorated one, whose picture takes as much as its corners save.
constexpr int kPaintedRows = 160, kPaintedSectors = 96;
// Of the body of a printed one, on which its relief lies.
constexpr int kPrintedRows = 400, kPrintedSectors = 120;

/// As much as a frame's share measures.
class Shared final : public view::TextMeasure {
 public:
  explicit Shared(screens::Measuring& measuring) : measuring_(measuring) {}
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override {
    return measuring_(text, style, width);
  }

 private:
  screens::Measuring& measuring_;
};

/// Of the relief's slopes, the share that is left under the glass, which melts level (clay.glsl).
double seen_under(const std::optional<view::Glazing>& glazing) {
  return glazing ? 1.0 - 0.85 * std::min(4.0 * glazing->coat, 1.0) : 1.0;
}

// Of the page: points of the outline, its zones, and how far a cone may lie from it before there is
// another one.
constexpr std::size_t kOutlinePoints = 200;
constexpr int kMostZones = 6;
constexpr double kConeTolerance = 1e-3;                  // m
constexpr const char* kErrorHere = "{mm}";               // of the cones, known later
constexpr double kPagePixels = 6000, kZonesGap = 0.010;  // of a metre; m

void shrink(TriangleMesh& mesh, double size) {
  for (auto& at : mesh.positions)
    for (float& x : at) x *= static_cast<float>(size);
}

}  // namespace

Result<TakingHome> TakingHome::begin(const screens::MakeKeepsake& request,
                                     const screens::ShelfCard& card,
                                     const content::Language& language,
                                     const settings::Exhibit& exhibit,
                                     const content::KeepsakeNames& names,
                                     loop::WheelHost& wheel_host, const std::string& token) {
  const content::Label label = card.vessel->label(language.code());
  const screens::SceneForVisitor& scene_of_pot =
      request.built && card.built ? *card.built : card.wheel;
  const auto fired_in = request.glaze >= 0 ? scene_of_pot.kiln : std::nullopt;
  const content::Glaze* glaze =
      fired_in ? &(*fired_in->glazes)[static_cast<std::size_t>(request.glaze)] : nullptr;
  TakingHome taking;
  if (fired_in) taking.size_ = fired_in->fired_size;
  KeptVisit& kept = taking.taken.visit;
  kept.vessel_id = card.vessel->id;
  kept.score = request.score;
  kept.thrown_height = request.made.height();
  kept.height = taking.size_ * kept.thrown_height;
  if (glaze != nullptr) kept.glaze = glaze->id;

  const bool lent = wheel_host.with_scene([&](Scene& scene) {
    kept.state_hash = scene.state_hash();
    kept.ticks = scene.counters().ticks;
  });
  if (!lent)
    return problem("the wheel", "The clay did not come back from the wheel in time.",
                   "If this happens again, look for a stuck 1 kHz loop in the log.", 1);
  souvenir::Keepsake& keepsake = taking.taken.keepsake;
  if (wheel_host.dropped_records() == 0)
    keepsake.replay = wheel_host.replay(kept.state_hash, kept.glaze);

  souvenir::PostcardWords& words = taking.words_;
  words = postcard_words(language, label, exhibit);
  if (glaze != nullptr) {
    words.glaze =
        language.say("postcard.glaze", {{"glaze", glaze->name_in(language.code())},
                                        {"mm", std::to_string(std::lround(1000 * kept.height))}});
    taking.taken.glazing = view::Glazing{glaze->look, fired_in->coat};
  }
  if (!request.decorated_how.empty())
    words.decorated = language.say("postcard.decorated", {{"what", request.decorated_how}});
  if (!token.empty()) {
    taking.phone_address_ = phone_address(exhibit, token);
    keepsake.phone = souvenir::ByPhone{token, exhibit.phone.hours, language.code(), {}};
  }
  taking.names_ = &names;
  taking.side_words_ = language.say("sheet.side");
  taking.strip_words_ = language.say("sheet.strip");
  taking.zones_words_ = language.say("sheet.zones", {{"mm", kErrorHere}});
  taking.hands_ = {language.say(request.built ? "sheet.built_by" : "sheet.thrown_by"),
                   language.say("sheet.decorated_by")};
  taking.made_ = request.made;
  // A pot that answers a description has no vessel under its section.
  taking.target_ = screens::mission_of_own(request.card) >= 0 ? request.made : card.target;
  keepsake.name = files::local_time(files::wall_now(), files::kStamp) + '_' + card.vessel->id;
  keepsake.caption = {words.title, exhibit.credit, words.vessel};
  return taking;
}

bool TakingHome::compose(const render::Renderer& renderer) {
  if (!measuring_) measuring_ = std::make_unique<screens::Measuring>(renderer.measure());
  measuring_->begin_frame();
  card_ = souvenir::compose_postcard(words_, made_, target_, Shared(*measuring_), taken.glazing);
  if (measuring_->spent()) return false;
  measuring_.reset();
  return true;
}

void TakingHome::unroll(const decoration::CoatPicture& coat, render::Renderer& renderer) {
  if (!unrolled_) unrolled_.emplace(made_, coat);
  unrolled_->take(renderer.read_skin(unrolled_->next_places(), taken.glazing));
}

// The surface is read at thrown size; the model has the fired size.
void TakingHome::make_model(const ClayView& clay, const std::string& copyright,
                            render::Renderer& renderer) {
  souvenir::Keepsake& keepsake = taken.keepsake;
  const std::string surface = taken.visit.glaze.empty() ? "clay" : taken.visit.glaze;
  ClayMesh pot = faced_mesh_of(clay, kKeptRows, kKeptSectors);
  const auto skin = renderer.read_skin(pot, taken.glazing);
  shrink(pot.mesh, size_);
  keepsake.glb = pot_model(pot.mesh, skin, surface, words_.title, copyright);
}

void TakingHome::make_painted(const ClayView& clay, const surface::Surface& surface,
                              const std::string& copyright) {
  ClayMesh pot = faced_mesh_of(clay, kPaintedRows, kPaintedSectors);
  const double rings = static_cast<double>(pot.faces.size()) / kPaintedSectors;
  auto places = unrolled_->places_of(pot);
  auto painted =
      std::make_shared<decoration::Skin>(decoration::Skin{std::move(pot.mesh), std::move(places)});
  decoration::close_round(*painted);
  shrink(painted->mesh, size_);
  // A copy: the next visitor's hand is on the pot while a worker reads this.
  const auto relief = std::make_shared<const surface::Surface>(surface);
  const double share = seen_under(taken.glazing);
  souvenir::Painted out{
      unrolled_->picture(), unrolled_->roughness(), unrolled_->rollout(), {}, {}, {}, {}};
  out.sheet = page_of(out.rollout);
  out.normals = [relief, share, width = out.skin.width, height = out.skin.height] {
    auto normals = decoration::normals_of(*relief, width, height, share);
    return view::Image{normals.width, normals.height, std::move(normals.rgba)};
  };
  const std::string coat = taken.visit.glaze.empty() ? "clay" : taken.visit.glaze;
  out.model = [painted, relief, coat, size = size_, share, rings, title = words_.title,
               copyright](souvenir::Painted::Pictures pictures) {
    raise(*painted, *relief, size, share, 1.0 / kPaintedSectors, 1.0 / rings);
    return pot_model(painted->mesh, coat, title, copyright,
                     {painted->places, std::move(pictures.skin), std::move(pictures.roughness),
                      std::move(pictures.normals)});
  };
  ClayMesh body = faced_mesh_of(clay, kPrintedRows, kPrintedSectors);
  auto body_places = unrolled_->places_of(body);
  out.relief = [body = std::move(body), places = std::move(body_places), relief, size = size_,
                title = words_.title](std::span<const std::byte> model) {
    return souvenir::relief_file(relief_of(body, places, *relief, size, title),
                                 souvenir::mark_of_model(model, model.size()));
  };
  taken.keepsake.painted = std::move(out);
}

std::function<view::Image(const std::string&)> TakingHome::page_of(view::Image strip) const {
  drawing::PotSheet page;
  page.title = words_.title;
  page.right_to_left = words_.right_to_left;
  for (const std::string& line : {words_.decorated, words_.glaze, words_.credit, words_.date})
    if (!line.empty()) page.facts.push_back(line);
  page.side_words = side_words_;
  page.strip_words = strip_words_;
  page.hands = hands_;
  page.pot = made_;
  for (ProfilePoint& point : page.pot.points)
    point.height *= size_, point.outer *= size_, point.inner *= size_;
  std::vector<Vec2> outline = unrolled_->outline();
  for (Vec2& at : outline) at = size_ * at;
  return [page, outline, strip = std::move(strip), names = names_, language = words_.language,
          vessel = words_.vessel, zones_words = zones_words_](const std::string& spoken) mutable {
    // Those who know its name find it at the desk.
    page.subtitle = spoken.empty() ? vessel : names->said(spoken, language);
    const std::vector<Vec2> even = evenly_along(outline, kOutlinePoints);
    const std::vector<Cone> cones = cones_of(even, kConeTolerance, kMostZones);
    double error = 0.0;
    for (const Cone& cone : cones) error = std::max(error, cone.error);
    page.zones_words = zones_words;
    if (const auto at = zones_words.find(kErrorHere); at != std::string::npos)
      page.zones_words.replace(at, std::string_view(kErrorHere).size(),
                               std::to_string(std::max(1L, std::lround(std::ceil(1e3 * error)))));
    page.side = {side_view(strip, even, page.pot.height(), kPagePixels), kPagePixels};
    page.zones = {on_cones(strip, even, cones, kPagePixels, kZonesGap), kPagePixels};
    double widest = 0.0;
    for (const Vec2& at : even) widest = std::max(widest, at.x);
    page.strip = {strip, strip.width / (2.0 * std::numbers::pi * widest)};
    return drawing::draw_sheet(page);
  };
}

bool TakingHome::draw_next(const settings::Exhibit& exhibit, const ClayView& clay,
                           const decorating::DecoratedPot* decorated, render::Renderer& renderer) {
  souvenir::Keepsake& keepsake = taken.keepsake;
  // The rows on the wheel are drawn, not the fired ones, because a picture shows no size.
  switch (next_) {
    case Next::words:
      if (compose(renderer)) next_ = Next::room;
      return true;
    case Next::room:
      if (!renderer.prepare_offscreen(card_)) next_ = Next::postcard;
      return true;
    case Next::postcard:
      keepsake.postcard = renderer.draw_offscreen(card_);
      next_ = keepsake.phone             ? Next::phone_words
              : exhibit.keepsake.gallery ? Next::small
                                         : Next::model;
      return true;
    case Next::phone_words:
      words_.phone = phone_address_;
      if (compose(renderer)) next_ = Next::phone_card;
      return true;
    case Next::phone_card:
      keepsake.phone->card = renderer.draw_offscreen(card_);
      next_ = exhibit.keepsake.gallery ? Next::small : Next::model;
      return true;
    case Next::small:
      keepsake.small = {renderer.draw_offscreen(small_picture(made_, taken.glazing)),
                        taken.visit.vessel_id, taken.visit.score.stars};
      next_ = Next::plaster;
      return true;
    case Next::plaster: {
      const view::Frame picture = small_picture(made_, taken.glazing);
      view::Image& small = keepsake.small->picture;
      small = with_soft_shadow(std::move(small), renderer.draw_offscreen(without_pot(picture)),
                               picture.pot->camera, made_);
      next_ = Next::model;
      return true;
    }
    case Next::model:
      if (decorated != nullptr && !(unrolled_ && unrolled_->whole())) {
        unroll(decorated->picture(), renderer);
        return true;
      }
      if (decorated != nullptr)
        make_painted(clay, decorated->surface(), exhibit.credit);
      else
        make_model(clay, exhibit.credit, renderer);
      next_ = Next::nothing;
      return false;
    case Next::nothing:
      return false;
  }
  return false;
}

}  // namespace onggi::exhibit
