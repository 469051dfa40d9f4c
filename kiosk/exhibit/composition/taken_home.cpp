#include "kiosk/exhibit/composition/taken_home.h"

#include <cmath>
#include <ctime>

#include "engine/clay/clay_mesh.h"
#include "engine/profile/mesh.h"
#include "kiosk/exhibit/composition/pot_model.h"
#include "kiosk/exhibit/composition/words.h"
#include "kiosk/ground/files/local_time.h"
#include "kiosk/ground/files/wall_clock.h"
#include "kiosk/keepsake/souvenir/postcard.h"

namespace onggi::exhibit {

namespace {

// Of the kept model: a row a millimetre, and 3 degrees a sector. So it has under 65,536 corners,
// and two bytes name one.
constexpr int kKeptRows = 240, kKeptSectors = 120;

void shrink(TriangleMesh& mesh, double size) {
  for (auto& at : mesh.positions)
    for (float& x : at) x *= static_cast<float>(size);
}

/// The pot alone, for the gallery.
view::Frame small_picture(const Profile& made, const std::optional<view::Glazing>& glazing) {
  constexpr int kWidth = 240, kHeight = 300;
  view::Frame frame;
  frame.width = kWidth;
  frame.height = kHeight;
  view::PotView pot;
  pot.camera =
      view::frame_pot(kWidth, kHeight, {24, 24, 192, 236}, made.height(), made.max_radius());
  pot.wheel = false;
  if (glazing) {
    pot.finish = view::Finish::fired;
    pot.glazing = *glazing;
  }
  frame.pot = pot;
  return frame;
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

bool TakingHome::draw_next(const settings::Exhibit& exhibit, const ClayView& clay,
                           render::Renderer& renderer) {
  souvenir::Keepsake& keepsake = taken.keepsake;
  // The rows on the wheel are drawn, not the fired ones, because a picture shows no size.
  const auto card = [&] {
    return renderer.draw_offscreen(
        souvenir::compose_postcard(words_, made_, target_, renderer.measure(), taken.glazing));
  };
  switch (next_) {
    case Next::postcard:
      keepsake.postcard = card();
      next_ = keepsake.phone             ? Next::phone_card
              : exhibit.keepsake.gallery ? Next::small
                                         : Next::model;
      return true;
    case Next::phone_card:
      words_.phone = phone_address_;
      keepsake.phone->card = card();
      next_ = exhibit.keepsake.gallery ? Next::small : Next::model;
      return true;
    case Next::small:
      keepsake.small = {renderer.draw_offscreen(small_picture(made_, taken.glazing)),
                        taken.visit.vessel_id, taken.visit.score.stars};
      next_ = Next::model;
      return true;
    case Next::model: {
      // Read the surface at thrown size; the model has the fired size.
      ClayMesh pot = faced_mesh_of(clay, kKeptRows, kKeptSectors);
      const auto skin = renderer.read_skin(pot, taken.glazing);
      shrink(pot.mesh, size_);
      keepsake.glb =
          pot_model(pot.mesh, skin, taken.visit.glaze.empty() ? "clay" : taken.visit.glaze,
                    words_.title, exhibit.credit);
      next_ = Next::nothing;
      return false;
    }
    case Next::nothing:
      return false;
  }
  return false;
}

}  // namespace onggi::exhibit
