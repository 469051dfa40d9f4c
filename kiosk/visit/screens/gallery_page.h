#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/card_shelf.h"

namespace onggi::screens {

/// Today's pots, newest first: small pictures with the vessel's name and the likeness, on a shelf
/// that a finger moves.
class GalleryPage final : private CardShelf::Cards {
 public:
  explicit GalleryPage(const Desk& desk) : desk_(desk), shelf_(desk, *this, "gallery") {}

  /// True if there is a pot to show; otherwise no screen mentions the gallery.
  bool any() const { return count() > 0; }
  /// The button that opens it, named `id`.
  Button way(const std::string& id) const;
  /// Fills the whole page. `onward`: buttons at its foot, above Back and Help.
  void lay_out(Page& page, const std::vector<Button>& onward, bool with_back);

  void update(double dt) { shelf_.update(dt); }
  bool press(const std::string& control) { return shelf_.press(control); }
  bool drag(const view::InputEvent& e) { return shelf_.drag(e); }
  void pointer(const view::InputEvent& e) { shelf_.pointer(e); }
  void let_go() { shelf_.let_go(); }
  /// Starts with the newest.
  void begin() { shelf_.begin(); }

 private:
  int count() const override;
  view::PictureId picture(int i) const override;
  float words(Page& page, int i, const view::Rect& at, float opacity) const override;
  std::string spoken(int i) const override;
  std::string title_of(const std::string& vessel) const;
  std::string control(int) const override { return {}; }
  const TodaysPot& pot(int i) const;

  const Desk& desk_;
  CardShelf shelf_;
};

}  // namespace onggi::screens
