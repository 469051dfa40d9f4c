#include "kiosk/keepsake/souvenir/printed_pot.h"

#include <utility>

#include "kiosk/ground/files/read_file.h"
#include "kiosk/keepsake/souvenir/relief_stl.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::souvenir {

namespace {

/// Takes the relief into `pot` if it is good; says why not.
std::optional<Problem> take_relief(const std::filesystem::path& keepsakes, const std::string& visit,
                                   PrintedPot& pot) {
  const auto told = [&](const char* what, const char* remedy) {
    return Problem{(keepsakes / visit / kRelief).lexically_normal().string(), what, remedy};
  };
  auto opened = files::open_beneath(keepsakes, visit + '/' + kRelief);
  if (!opened && opened.error().kind == files::ReadFault::Kind::missing) return {};
  const ReliefFit fit = opened ? fit_of(*opened, pot.file) : ReliefFit::damaged;
  if (fit == ReliefFit::foreign)
    return told("This is the relief of another pot.",
                "Put the right one back, or remove it. Until then the STL is made from pot.glb, "
                "without what was cut and laid on.");
  auto stl = fit == ReliefFit::good ? StlOfPot::of(*opened) : std::nullopt;
  if (!stl)
    return told("This relief of a pot is damaged.",
                "Copy it from a backup, or remove it. Until then the STL is made from pot.glb, "
                "without what was cut and laid on.");
  pot.file = std::move(*opened);
  pot.stl = std::move(*stl);
  return {};
}

}  // namespace

std::optional<PrintedPot> printed_pot(const std::filesystem::path& keepsakes,
                                      const std::string& visit) {
  auto model = files::open_beneath(keepsakes, visit + '/' + kPotGlb);
  if (!model) return {};
  auto plain = StlOfPot::of(*model);
  if (!plain) return {};
  PrintedPot pot{std::move(*model), std::move(*plain), {}};
  pot.remark = take_relief(keepsakes, visit, pot);
  return pot;
}

Result<PrintedStl> stl_of_visit(const std::filesystem::path& visit) {
  auto pot = printed_pot(visit, ".");
  PrintedStl made;
  if (pot) made.bytes.resize(static_cast<std::size_t>(pot->stl.size()));
  if (!pot || !pot->stl.read(pot->file, 0, made.bytes))
    return problem((visit / kPotGlb).string(), "This is not the model of a kept pot.",
                   "Name the folder of a visit that onggi kept.");
  made.remark = std::move(pot->remark);
  return made;
}

}  // namespace onggi::souvenir
