#include "kiosk/visit/screens/gallery_page.h"

#include "kiosk/visit/screens/overlays.h"

namespace onggi::screens {

using view::Face;
using view::Rect;

int GalleryPage::count() const {
  return desk_.world.todays == nullptr ? 0 : static_cast<int>(desk_.world.todays->size());
}

const TodaysPot& GalleryPage::pot(int i) const {
  return (*desk_.world.todays)[static_cast<std::size_t>(i)];
}

view::PictureId GalleryPage::picture(int i) const { return pot(i).picture; }

Button GalleryPage::way(const std::string& id) const {
  return {id, desk_.say("gallery.open"), Look::outline};
}

void GalleryPage::lay_out(Page& page, const std::vector<Button>& onward, bool with_back) {
  const TypeScale& t = page.type();
  Column column(page, page.where().page);
  column.text(desk_.say("gallery.title"), t.title, Face::serif);
  column.text(desk_.say("gallery.lead"), t.body, Face::sans, view::kFaintInk);
  column.foot_buttons(standing_buttons(desk_, with_back));
  column.foot_space(t.gap * 1.5f);
  column.foot_buttons(onward);
  column.foot_space(t.gap * 1.5f);
  column.space(t.gap * 1.5f);
  shelf_.lay_out(page, column);
}

/// Title of a vessel on the shelf, or of an offered mission; else empty.
std::string GalleryPage::title_of(const std::string& vessel) const {
  for (int card = 0; card < desk_.cards(); ++card)
    if (desk_.shelf_card(card)->vessel->id == vessel) return desk_.label(card).title;
  for (int n = 0; n < desk_.missions(); ++n)
    if (desk_.mission_card(n).mission->id == vessel)
      return desk_.mission_card(n).mission->title_in(desk_.words().code());
  return {};
}

float GalleryPage::words(Page& page, int i, const Rect& at, float opacity) const {
  const TypeScale& t = page.type();
  CardWords lines(page, at, opacity);
  lines.add(title_of(pot(i).vessel), Face::serif, t.body, view::kInk);
  lines.stars(pot(i).stars);
  if (opacity > 0)
    page.tell(at.y, spoken(i));  // it is not a control, so nothing else would speak it
  return lines.height();
}

std::string GalleryPage::spoken(int i) const {
  std::string all = title_of(pot(i).vessel);
  if (!all.empty()) all += ", ";
  return all + desk_.say("result.stars", {{"stars", std::to_string(pot(i).stars)}});
}

}  // namespace onggi::screens
