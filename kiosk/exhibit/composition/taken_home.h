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
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// The result of the last kept visit, for scripted visits.
struct KeptVisit {
  std::string vessel_id;
  score::Score score;
  std::string glaze;         ///< Its id; "": not fired.
  double thrown_height = 0;  ///< Metres, on the wheel.
  double height = 0;         ///< Metres, as kept: fired size if there is a kiln.
  std::uint64_t state_hash = 0;
  std::uint64_t ticks = 0;
  std::optional<Result<souvenir::KeepsakeFiles>> saved;
  /// Absent until the turning picture follows, if it does.
  std::optional<Result<std::filesystem::path>> turning;
};

/// A finished keepsake, before anything is on the disk.
struct TakenHome {
  KeptVisit visit;
  souvenir::Keepsake keepsake;
  std::optional<view::Glazing> glazing;  ///< Absent: not fired.
};

/// Makes the keepsake of the pot on the wheel, which answers the vessel of `card`: its mesh (fired
/// if `request` says so), its replay, and its postcard, drawn by `renderer` in `language`; with a
/// `token` (Keepsakes::token()) also the postcard with its QR code. Problem (exit 1) if the wheel
/// does not return the clay. Main thread.
Result<TakenHome> take_home(const screens::MakeKeepsake& request, const screens::ShelfCard& card,
                            const content::Language& language, const settings::Exhibit& exhibit,
                            loop::WheelHost& wheel_host, render::Renderer& renderer,
                            const std::string& token);

}  // namespace onggi::exhibit
