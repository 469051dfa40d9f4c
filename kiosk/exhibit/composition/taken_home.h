#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"
#include "kiosk/wheel/loop/potter_host.h"

namespace onggi::exhibit {

/// What the last kept visit came to, for scripted visits.
struct KeptVisit {
  std::string vessel_id;
  score::Score score;
  std::string glaze;         ///< Its id; "": not fired.
  double thrown_height = 0;  ///< Metres, on the wheel.
  double height = 0;         ///< Metres, as it is kept: out of the kiln where there is one.
  std::uint64_t state_hash = 0;
  std::uint64_t ticks = 0;
  std::optional<Result<souvenir::KeepsakeFiles>> saved;
  std::optional<Result<std::filesystem::path>> turning;  ///< It follows, or nothing does.
};

/// A pot as it is taken home, of which nothing is on the disk yet.
struct TakenHome {
  KeptVisit visit;
  souvenir::Keepsake keepsake;
  std::optional<view::Glazing> glazing;  ///< None: not fired.
};

/// Makes the keepsake of the pot on the wheel, which answers the vessel of `card`: its mesh, fired
/// where `request` says so, its replay, and its postcard, drawn by `renderer` in the words of
/// `language`; and with a `token` (Keepsakes::token()) the postcard with its code. Problem (exit 1)
/// where the clay does not come back from the wheel. Main thread.
Result<TakenHome> take_home(const screens::MakeKeepsake& request, const screens::ShelfCard& card,
                            const content::Language& language, const settings::Exhibit& exhibit,
                            loop::PotterHost& potter, render::Renderer& renderer,
                            const std::string& token);

}  // namespace onggi::exhibit
