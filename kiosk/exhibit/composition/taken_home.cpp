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

Result<TakenHome> take_home(const screens::MakeKeepsake& request, const screens::ShelfCard& card,
                            const content::Language& language, const settings::Exhibit& exhibit,
                            loop::WheelHost& wheel_host, render::Renderer& renderer,
                            const std::string& token) {
  const content::Label label = card.vessel->label(language.code());
  const auto fired_in = request.glaze >= 0 ? card.wheel.kiln : std::nullopt;
  const content::Glaze* glaze =
      fired_in ? &(*fired_in->glazes)[static_cast<std::size_t>(request.glaze)] : nullptr;
  const double size = fired_in ? fired_in->fired_size : 1.0;
  TakenHome taken;
  KeptVisit& kept = taken.visit;
  kept.vessel_id = card.vessel->id;
  kept.score = request.score;
  kept.thrown_height = request.made.height();
  kept.height = size * kept.thrown_height;
  if (glaze != nullptr) kept.glaze = glaze->id;

  const bool lent = wheel_host.with_scene([&](Scene& scene) {
    kept.state_hash = scene.state_hash();
    kept.ticks = scene.counters().ticks;
  });
  if (!lent)
    return problem("the wheel", "The clay did not come back from the wheel in time.",
                   "If this happens again, look for a stuck 1 kHz loop in the log.", 1);
  souvenir::Keepsake& keepsake = taken.keepsake;
  // The wheel has paused since the pot was called done, so the view has every row.
  ClayMesh pot = faced_mesh_of(wheel_host.view().clay);
  if (wheel_host.dropped_records() == 0)
    keepsake.replay = wheel_host.replay(kept.state_hash, kept.glaze);

  souvenir::PostcardWords words = postcard_words(language, label, exhibit);
  std::optional<view::Glazing>& glazing = taken.glazing;
  if (glaze != nullptr) {
    words.glaze =
        language.say("postcard.glaze", {{"glaze", glaze->name_in(language.code())},
                                        {"mm", std::to_string(std::lround(1000 * kept.height))}});
    glazing = view::Glazing{glaze->look, fired_in->coat};
  }
  // A pot that answers a description has no vessel under its section.
  const Profile& target = screens::mission_of_own(request.card) >= 0 ? request.made : card.target;
  // Draw the picture from the rows on the wheel, because a picture shows no size.
  const auto draw = [&] {
    return renderer.draw_offscreen(
        souvenir::compose_postcard(words, request.made, target, renderer.measure(), glazing));
  };
  keepsake.postcard = draw();
  if (!token.empty()) {
    words.phone = phone_address(exhibit, token);
    keepsake.phone = souvenir::ByPhone{token, exhibit.phone.hours, language.code(), draw()};
  }
  if (exhibit.keepsake.gallery)
    keepsake.small = {renderer.draw_offscreen(small_picture(request.made, glazing)),
                      card.vessel->id, request.score.stars};
  keepsake.name = files::local_time(files::wall_now(), files::kStamp) + '_' + card.vessel->id;
  keepsake.caption = {words.title, exhibit.credit, words.vessel};
  // Read the surface at thrown size; the model has the fired size.
  const std::vector<view::SkinPoint> skin = renderer.read_skin(pot, glazing);
  keepsake.pot = std::move(pot.mesh);
  shrink(keepsake.pot, size);
  keepsake.glb = pot_model(keepsake.pot, skin, glaze != nullptr ? glaze->id : "clay", words.title,
                           exhibit.credit);
  return taken;
}

}  // namespace onggi::exhibit
