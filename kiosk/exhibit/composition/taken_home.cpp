#include "kiosk/exhibit/composition/taken_home.h"

#include <cmath>
#include <ctime>

#include "engine/clay/clay_mesh.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/decoration/unrolled.h"
#include "kiosk/exhibit/composition/pot_model.h"
#include "kiosk/exhibit/composition/small_picture.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/postcard.h"

namespace onggi::exhibit {

namespace {

// Of the kept model: a row a millimetre, and 3 degrees a sector. So it has under 65,536 corners,
// and two bytes name one.
constexpr int kKeptRows = 240, kKeptSectors = 120;
// Of a decorated one, whose picture takes as much as its corners save.
constexpr int kPaintedRows = 160, kPaintedSectors = 96;

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

void shrink(TriangleMesh& mesh, double size) {
  for (auto& at : mesh.positions)
    for (float& x : at) x *= static_cast<float>(size);
}

}  // namespace

Result<TakingHome> TakingHome::begin(const screens::MakeKeepsake& request,
                                     const screens::ShelfCard& card,
                                     const content::Language& language,
                                     const settings::Exhibit& exhibit, loop::WheelHost& wheel_host,
                                     const std::string& token) {
  const content::Label label = card.vessel->label(language.code());
  const auto fired_in = request.glaze >= 0 ? card.wheel.kiln : std::nullopt;
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
  const int rows = unrolled_ ? kPaintedRows : kKeptRows;
  const int sectors = unrolled_ ? kPaintedSectors : kKeptSectors;
  ClayMesh pot = faced_mesh_of(clay, rows, sectors);
  auto skin = renderer.read_skin(pot, taken.glazing);
  if (!unrolled_) {
    shrink(pot.mesh, size_);
    keepsake.glb = pot_model(pot.mesh, skin, surface, words_.title, copyright);
    return;
  }
  auto places = unrolled_->places_of(pot);
  decoration::Skin painted{std::move(pot.mesh), std::move(places)};
  for (const std::uint32_t one : decoration::close_round(painted)) skin.push_back(skin[one]);
  shrink(painted.mesh, size_);
  keepsake.painted =
      souvenir::Painted{unrolled_->picture(), unrolled_->rollout(),
                        [painted = std::move(painted), skin = std::move(skin), surface,
                         title = words_.title, copyright](std::vector<std::byte> picture) {
                          return pot_model(painted.mesh, skin, surface, title, copyright,
                                           {painted.places, std::move(picture)});
                        }};
}

bool TakingHome::draw_next(const settings::Exhibit& exhibit, const ClayView& clay,
                           const decoration::CoatPicture* coat, render::Renderer& renderer) {
  souvenir::Keepsake& keepsake = taken.keepsake;
  // The rows on the wheel are drawn, not the fired ones, because a picture shows no size.
  switch (next_) {
    case Next::words:
      if (compose(renderer)) next_ = Next::postcard;
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
      if (coat != nullptr && !(unrolled_ && unrolled_->whole())) {
        unroll(*coat, renderer);
        return true;
      }
      make_model(clay, exhibit.credit, renderer);
      next_ = Next::nothing;
      return false;
    case Next::nothing:
      return false;
  }
  return false;
}

}  // namespace onggi::exhibit
