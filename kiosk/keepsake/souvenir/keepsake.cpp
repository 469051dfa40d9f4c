#include "kiosk/keepsake/souvenir/keepsake.h"

#include <ctime>
#include <optional>
#include <span>
#include <system_error>

#include "kiosk/ground/files/durable_file.h"
#include "kiosk/ground/files/shared_folder.h"
#include "kiosk/ground/files/zstandard.h"
#include "kiosk/keepsake/souvenir/pass.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace onggi::souvenir {
namespace {

namespace fs = std::filesystem;

constexpr int kMostOfOneName = 99;

/// A pass that is taken back unless its keepsake is saved.
class GivenPass {
 public:
  explicit GivenPass(const fs::path& folder) : passes_(folder) {}
  ~GivenPass() {
    if (pass_) passes_.take_back(*pass_);
  }
  GivenPass(const GivenPass&) = delete;
  GivenPass& operator=(const GivenPass&) = delete;
  /// Its token; "" if the disk refuses, because the keepsake is saved with or without a phone page.
  std::string give(const std::string& visit, const ByPhone& phone) {
    const auto pass =
        passes_.give(visit, std::time(nullptr), phone.hours, phone.language, phone.token);
    if (!pass) return {};
    pass_ = *pass;
    return pass->token;
  }
  void keep() { pass_.reset(); }

 private:
  Passes passes_;
  std::optional<Pass> pass_;
};

/// Finds a name that no visit and no unfinished visit has, and creates its .partial folder.
Result<std::string> take_name(const fs::path& folder, const std::string& wanted) {
  for (int i = 1; i <= kMostOfOneName; ++i) {
    const std::string name = i == 1 ? wanted : wanted + "_" + std::to_string(i);
    std::error_code error;
    if (fs::symlink_status(folder / name, error).type() != fs::file_type::not_found) continue;
    // create_directory is atomic: of two writers only one succeeds.
    if (fs::create_directory(folder / (name + kPartial), error)) {
      files::share_as_above(folder / (name + kPartial));
      return name;
    }
    if (error) {
      return tl::unexpected(
          files::disk_problem(folder / (name + kPartial), "write", error.value()));
    }
  }
  return problem((folder / wanted).string(), "There are already 99 visits with this name.",
                 "Set the machine's clock: it seems to be stopped.", 1);
}

}  // namespace

Result<KeepsakeFiles> save(const Keepsake& keepsake, const fs::path& folder,
                           const KeepsakeLimits& limits) {
  const std::string wanted = visit_name(keepsake.name);
  if (wanted.empty()) {
    return problem(keepsake.name, "A visit's name begins with its date and time.",
                   "This is a fault of the program: report it with the log.", 1);
  }
  // Encode first, so that a failure here has not touched the disk.
  using Picture = Result<std::vector<std::byte>>;
  const auto encoded = [&](const view::Image& image, const encoding::Caption& caption) {
    return encoding::encode(image, encoding::Format::jpeg, caption);
  };
  const Picture postcard = encoded(keepsake.postcard, keepsake.caption);
  if (!postcard) return tl::unexpected(postcard.error());
  const Picture print = keepsake.phone ? encoded(keepsake.phone->card, keepsake.caption)
                                       : Picture(std::vector<std::byte>());
  if (!print) return tl::unexpected(print.error());
  std::vector<std::byte> small;
  if (keepsake.small) {
    auto picture = encoded(keepsake.small->picture, {});
    if (!picture) return tl::unexpected(picture.error());
    small = std::move(*picture);
  }
  std::vector<std::byte> glb = keepsake.glb, rollout, sheet, relief;
  if (keepsake.painted) {
    const Painted& painted = *keepsake.painted;
    auto skin = encoded(painted.skin, {});
    if (!skin) return tl::unexpected(skin.error());
    auto roughness = encoded(painted.roughness, {});
    if (!roughness) return tl::unexpected(roughness.error());
    auto normals = encoded(painted.normals(), {});
    if (!normals) return tl::unexpected(normals.error());
    glb = painted.model({std::move(*skin), std::move(*roughness), std::move(*normals)});
    auto picture = encoded(painted.rollout, keepsake.caption);
    if (!picture) return tl::unexpected(picture.error());
    rollout = std::move(*picture);
    relief = painted.relief(glb);
    auto drawn = encoded(painted.sheet(keepsake.spoken), keepsake.caption);
    if (!drawn) return tl::unexpected(drawn.error());
    sheet = std::move(*drawn);
  }
  const std::string shown = keepsake.small ? text_of(*keepsake.small) : std::string();
  const std::string spoken = keepsake.spoken.empty() ? std::string() : keepsake.spoken + '\n';
  const std::vector<std::byte> replay =
      keepsake.replay.empty() ? keepsake.replay : files::packed(keepsake.replay);

  if (auto made = files::make_folder(folder); !made) return tl::unexpected(made.error());
  const auto name = take_name(folder, wanted);
  if (!name) return tl::unexpected(name.error());
  PartialFolder partial(folder / (*name + kPartial));

  KeepsakeFiles files;
  files.folder = folder / *name;
  files.spoken = keepsake.spoken;
  GivenPass given(folder);
  if (keepsake.phone) files.token = given.give(*name, *keepsake.phone);
  const auto write = [&](fs::path& path, const char* file,
                         std::span<const std::byte> bytes) -> Result<void> {
    if (bytes.empty()) return {};
    path = files.folder / file;
    return files::write_durably(partial.path() / file, bytes);
  };
  fs::path unnamed;
  // A code that leads nowhere is not printed.
  const std::vector<std::byte> nothing;
  for (const Result<void>& written :
       {write(files.postcard, kPostcard, *postcard),
        write(files.print, kPrint, files.token.empty() ? nothing : *print),
        write(files.glb, kPotGlb, glb), write(files.replay, kReplay, replay),
        write(files.rollout, kRollout, rollout), write(unnamed, kSheet, sheet),
        write(unnamed, kRelief, relief), write(unnamed, kSmall, small),
        write(unnamed, kShown, std::as_bytes(std::span(shown))),
        write(unnamed, kSpoken, std::as_bytes(std::span(spoken)))}) {
    if (!written) return tl::unexpected(written.error());
  }
  if (auto renamed = files::rename_durably(partial.path(), files.folder); !renamed) {
    return tl::unexpected(renamed.error());
  }
  partial.keep();
  given.keep();
  // This visit is saved even if others cannot be tidied.
  (void)tidy(folder, limits, *name);
  return files;
}

}  // namespace onggi::souvenir
