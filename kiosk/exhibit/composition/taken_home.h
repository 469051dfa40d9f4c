#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/base/result.h"
#include "kiosk/collection/content/keepsake_names.h"
#include "kiosk/collection/content/language.h"
#include "kiosk/collection/score/score.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/unrolled_pot.h"
#include "kiosk/keepsake/souvenir/keepsake.h"
#include "kiosk/keepsake/souvenir/postcard.h"
#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/measuring.h"
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

/// Makes the keepsake of the pot on the wheel, a step at a time, because each may take a frame's
/// time: a picture, or the words of a postcard. The wheel must rest and the clay stay shown until
/// the last one. Main thread.
class TakingHome {
 public:
  /// `card`: what the pot answers; `language`: of the words; with a `token` (Keepsakes::token())
  /// there is a second postcard, with its QR code. `names` outlive the keepsake's save. Problem
  /// (exit 1) if the wheel does not return the clay.
  static Result<TakingHome> begin(const screens::MakeKeepsake& request,
                                  const screens::ShelfCard& card, const content::Language& language,
                                  const settings::Exhibit& exhibit,
                                  const content::KeepsakeNames& names, loop::WheelHost& wheel_host,
                                  const std::string& token);
  /// Takes the next step: the postcard first, the pot's model (fired if the request says so) last.
  /// False once all is drawn. `decorated`: what `renderer` shows on it; null: nothing.
  bool draw_next(const settings::Exhibit& exhibit, const ClayView& clay,
                 const decorating::DecoratedPot* decorated, render::Renderer& renderer);
  /// Complete when draw_next() has returned false.
  TakenHome taken;
  bool has_postcard() const { return !taken.keepsake.postcard.rgba.empty(); }

 private:
  TakingHome() = default;
  /// False while some words have guessed sizes: they are more than a frame's share.
  bool compose(const render::Renderer& renderer);

  /// Reads the skin of a decorated pot, some rows a step.
  void unroll(const decoration::CoatPicture& coat, render::Renderer& renderer);
  void make_model(const ClayView& clay, const std::string& copyright, render::Renderer& renderer);
  /// Of a pot that is unrolled.
  void make_painted(const ClayView& clay, const surface::Surface& surface,
                    const std::string& copyright);
  /// The page of it, to be drawn by a worker, in which it is called by its name.
  std::function<view::Image(const std::string& spoken)> page_of(view::Image strip) const;

  enum class Next {
    words,
    room,
    postcard,
    phone_words,
    phone_card,
    small,
    plaster,
    model,
    nothing
  };
  Next next_ = Next::words;
  souvenir::PostcardWords words_;
  view::Frame card_;                               ///< The next postcard,
  std::unique_ptr<screens::Measuring> measuring_;  ///< and its words, while they are measured.
  std::string phone_address_;
  const content::KeepsakeNames* names_ = nullptr;
  std::string side_words_, strip_words_, zones_words_;  ///< Of its page; the last with "{mm}".
  std::vector<std::string> hands_;
  Profile made_, target_;
  double size_ = 1.0;                    ///< Of the model; the clay has 1.
  std::optional<UnrolledPot> unrolled_;  ///< Of a decorated pot.
};

}  // namespace onggi::exhibit
